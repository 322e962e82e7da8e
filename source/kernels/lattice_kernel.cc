// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/kernels/lattice_kernel.h"

#include <cstring>

namespace ricochet
{
extern const LatticeKernel *const lattice_kernels_baseline;
extern const LatticeKernel *const lattice_kernels_avx2;
extern const LatticeKernel *const lattice_kernels_avx512;

const LatticeKernel *lattice_kernel(const int law, const char *instruction_set)
{
  struct Choice
  {
    bool available;
    const LatticeKernel *kernels;
  };
  __builtin_cpu_init();
  const Choice best_first[] = {
      {__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl"),
       lattice_kernels_avx512},
      {__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"), lattice_kernels_avx2},
      {true, lattice_kernels_baseline}};
  for (const auto &choice : best_first)
    if (choice.available && (instruction_set == nullptr ||
                             std::strcmp(instruction_set, choice.kernels[0].instruction_set) == 0))
      return choice.kernels + law;
  return nullptr;
}
} // namespace ricochet
