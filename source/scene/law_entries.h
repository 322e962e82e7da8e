// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of a list of laws: one that chooses the law, and one for each constant that some law
// declares (base/law_list.h). A new law of the list needs no line here.
#pragma once

#include "ricochet/base/law_list.h"
#include "section.h"

#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace ricochet
{
/// Calls f(row) for all constants of a law that is given by a null pointer.
template <class Law, class F>
void for_each_row(const Law *, F &&f)
{
  for (const auto &row : Law::entries)
    f(row);
}

/// Names of the laws that have a constant of this name.
template <class Interface, class... Laws>
std::vector<std::string> laws_with(LawList<Interface, Laws...> list, const std::string &constant)
{
  std::vector<std::string> names;
  list.for_each(
      [&](const auto *law)
      {
        for_each_row(law,
                     [&](const auto &row)
                     {
                       if (row.name == constant)
                         names.push_back(law->name);
                     });
      });
  return names;
}

/// "Decay of the coefficient; of the laws 'exponential' and 'hyperbolic' only"
std::string meaning_of_constant(const std::string &meaning, const std::vector<std::string> &laws,
                                std::size_t n_laws);

/**
 * Adds the entry `name` that chooses a law, and the constants of all laws. Those of the law that is
 * chosen must be given; those of others may stand in the file and are not used. A check puts the
 * constants of the chosen law into `chosen`.
 */
template <class Interface, class... Laws>
void add_law(Section &in, const std::string &name,
             std::variant<typename Laws::Parameters...> &chosen, LawList<Interface, Laws...> list,
             const std::string &example, const std::string &documentation)
{
  struct Given
  {
    std::string law;
    std::tuple<typename Laws::Parameters...> constants = {};
  };
  const auto given = std::make_shared<Given>();
  const Entry &law = in.required(name, word(given->law, list.names()), example, documentation);
  list.for_each(
      [&](const auto *one)
      {
        using Law       = std::remove_const_t<std::remove_pointer_t<decltype(one)>>;
        auto &constants = std::get<typename Law::Parameters>(given->constants);
        Entries needed;
        for (const auto &row : Law::entries)
        {
          const auto users     = laws_with(list, row.name);
          const bool is_of_all = users.size() == sizeof...(Laws);
          const Binding value  = quantity(constants.*row.member, row.dimension, row.limit);
          const auto meaning   = meaning_of_constant(row.meaning, users, sizeof...(Laws));
          const Entry &entry   = is_of_all ? in.required(row.name, value, row.example, meaning)
                                           : in.optional(row.name, value, row.example, meaning);
          if (!is_of_all)
            needed.push_back(&entry);
        }
        if (!needed.empty())
          in.all_of(needed, {&law, {Law::name}});
      });
  in.check(
      [given, &chosen, list]
      {
        list.for_each(
            [&](const auto *one)
            {
              using Law = std::remove_const_t<std::remove_pointer_t<decltype(one)>>;
              if (given->law == Law::name)
                chosen = std::get<typename Law::Parameters>(given->constants);
            });
      });
}
} // namespace ricochet
