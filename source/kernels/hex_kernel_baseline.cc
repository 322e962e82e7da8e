// SPDX-License-Identifier: LGPL-2.1-or-later
// The element loops for one instruction set; CMakeLists.txt gives this file its own compiler flags.
#include "simd_baseline.h"

#include "hex_kernel_loops.h"

namespace ricochet
{
extern const HexKernel *const hex_kernel_baseline;
const HexKernel *const hex_kernel_baseline = &kernel;
} // namespace ricochet
