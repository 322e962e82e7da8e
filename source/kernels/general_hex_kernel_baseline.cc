// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop over general hexahedra for one instruction set; CMakeLists.txt gives this file its own
// compiler flags.
#include "simd_baseline.h"

#include "general_hex_kernel_loops.h"

namespace ricochet
{
extern const GeneralHexKernel *const general_hex_kernel_baseline;
const GeneralHexKernel *const general_hex_kernel_baseline = &kernel;
} // namespace ricochet
