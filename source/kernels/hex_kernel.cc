// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/kernels/hex_kernel.h"

#include "instruction_set.h"

namespace ricochet
{
extern const HexKernel *const hex_kernel_baseline;
extern const HexKernel *const hex_kernel_avx2;
extern const HexKernel *const hex_kernel_avx512;

const HexKernel *hex_kernel(const char *instruction_set)
{
  return table_for_this_processor(instruction_set, hex_kernel_avx512, hex_kernel_avx2,
                                  hex_kernel_baseline);
}
} // namespace ricochet
