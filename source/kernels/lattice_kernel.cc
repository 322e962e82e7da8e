// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/kernels/lattice_kernel.h"

#include "instruction_set.h"

namespace ricochet
{
extern const LatticeKernel *const lattice_kernels_baseline;
extern const LatticeKernel *const lattice_kernels_avx2;
extern const LatticeKernel *const lattice_kernels_avx512;

const LatticeKernel *lattice_kernel(const int law, const char *instruction_set)
{
  const LatticeKernel *kernels = table_for_this_processor(
      instruction_set, lattice_kernels_avx512, lattice_kernels_avx2, lattice_kernels_baseline);
  return kernels == nullptr ? nullptr : kernels + law;
}
} // namespace ricochet
