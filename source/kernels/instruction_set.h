// SPDX-License-Identifier: LGPL-2.1-or-later
// Which of a kernel's tables suits this processor.
#pragma once

#include <cstring>

namespace ricochet
{
/// The table compiled for the best instruction set of this processor, or for the one named
/// ("avx512", "avx2", "baseline"); null if the processor lacks it or no set has that name. `Table`
/// has a member instruction_set.
template <class Table>
const Table *table_for_this_processor(const char *instruction_set, const Table *avx512,
                                      const Table *avx2, const Table *baseline)
{
  struct Choice
  {
    bool available;
    const Table *table;
  };
  __builtin_cpu_init();
  const Choice best_first[] = {
      {__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl"),
       avx512},
      {__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"), avx2},
      {true, baseline}};
  for (const auto &choice : best_first)
    if (choice.available && (instruction_set == nullptr ||
                             std::strcmp(instruction_set, choice.table->instruction_set) == 0))
      return choice.table;
  return nullptr;
}
} // namespace ricochet
