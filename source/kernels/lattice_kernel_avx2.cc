// SPDX-License-Identifier: LGPL-2.1-or-later
// The lattice loops for one instruction set; CMakeLists.txt gives this file its own compiler flags.
#include "simd_avx2.h"

#include "lattice_kernel_loops.h"

namespace ricochet
{
extern const LatticeKernel *const lattice_kernels_avx2;
const LatticeKernel *const lattice_kernels_avx2 = kernels;
} // namespace ricochet
