// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop over general hexahedra for one instruction set; CMakeLists.txt gives this file its own
// compiler flags.
#include "simd_avx2.h"

#include "general_hex_kernel_loops.h"

namespace ricochet
{
extern const GeneralHexKernel *const general_hex_kernel_avx2;
const GeneralHexKernel *const general_hex_kernel_avx2 = &kernel;
} // namespace ricochet
