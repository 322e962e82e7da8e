// SPDX-License-Identifier: LGPL-2.1-or-later
#include "law_entries.h"

#include "ricochet/scene/text_tools.h"

namespace ricochet
{
std::string meaning_of_constant(const std::string &meaning, const std::vector<std::string> &laws,
                                const std::size_t n_laws)
{
  if (laws.size() == n_laws)
    return meaning;
  std::vector<std::string> quoted;
  quoted.reserve(laws.size());
  for (const auto &law : laws)
    quoted.push_back(in_quotes(law));
  return meaning + (laws.size() == 1 ? "; of the law " : "; of the laws ") +
         joined(quoted, " and ") + " only";
}
} // namespace ricochet
