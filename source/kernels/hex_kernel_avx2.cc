// SPDX-License-Identifier: LGPL-2.1-or-later
// The element loops for one instruction set; CMakeLists.txt gives this file its own compiler flags.
#include "simd_avx2.h"

#include "hex_kernel_loops.h"

namespace ricochet
{
extern const HexKernel *const hex_kernel_avx2;
const HexKernel *const hex_kernel_avx2 = &kernel;
} // namespace ricochet
