// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/search/pair_loops.h"

#include "ricochet/base/exceptions.h"

#include <cstring>

namespace ricochet
{
extern const PairLoops *const pair_loops_baseline;
extern const PairLoops *const pair_loops_avx2;
extern const PairLoops *const pair_loops_avx512;

const PairLoops &pair_loops(const char *instruction_set)
{
  struct Choice
  {
    bool available;
    const PairLoops *loops;
  };
  __builtin_cpu_init();
  const Choice best_first[] = {
      {__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl"),
       pair_loops_avx512},
      {__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2"),
       pair_loops_avx2},
      {true, pair_loops_baseline}};
  for (const auto &choice : best_first)
    if (choice.available && (instruction_set == nullptr ||
                             std::strcmp(instruction_set, choice.loops->instruction_set) == 0))
      return *choice.loops;
  throw InputError(std::string("This processor does not have the instruction set '") +
                   instruction_set + "'.");
}
} // namespace ricochet
