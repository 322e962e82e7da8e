// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/kernels/general_hex_kernel.h"

#include "instruction_set.h"

namespace ricochet
{
extern const GeneralHexKernel *const general_hex_kernel_baseline;
extern const GeneralHexKernel *const general_hex_kernel_avx2;
extern const GeneralHexKernel *const general_hex_kernel_avx512;

const GeneralHexKernel *general_hex_kernel(const char *instruction_set)
{
  return table_for_this_processor(instruction_set, general_hex_kernel_avx512,
                                  general_hex_kernel_avx2, general_hex_kernel_baseline);
}
} // namespace ricochet
