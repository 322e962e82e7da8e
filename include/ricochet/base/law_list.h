// SPDX-License-Identifier: LGPL-2.1-or-later
// A menu of laws as a list of types. A law of such a list has
//   static constexpr const char *name;           its name in parameter files
//   struct Parameters;                           its own constants, all of them numbers
//   static constexpr EntryRow<Parameters> entries[];
//   explicit Law(const Parameters &).
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace ricochet
{
template <class Interface, class... Laws>
struct LawList
{
  /// The constants of one law of the list, which also say which law it is.
  using Parameters = std::variant<typename Laws::Parameters...>;

  /// Calls f(law) with a null pointer to each law in turn, for its type.
  template <class F>
  static void for_each(F &&f)
  {
    (f(static_cast<const Laws *>(nullptr)), ...);
  }

  /// Of all laws, in the order of the list.
  static std::vector<std::string> names() { return {Laws::name...}; }

  /// Of the law whose constants these are.
  static std::string name(const Parameters &parameters) { return names()[parameters.index()]; }

  /// That law.
  static std::unique_ptr<Interface> make(const Parameters &parameters)
  {
    std::unique_ptr<Interface> made;
    for_each(
        [&](const auto *law)
        {
          using Law = std::remove_const_t<std::remove_pointer_t<decltype(law)>>;
          if (const auto *const own = std::get_if<typename Law::Parameters>(&parameters))
            made = std::make_unique<Law>(*own);
        });
    return made;
  }
};
} // namespace ricochet
