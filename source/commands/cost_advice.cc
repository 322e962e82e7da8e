// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cost_advice.h"

#include "ricochet/base/number_text.h"
#include "ricochet/scene/text_tools.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
// What is asked of a zone, and what most uses can do with [%].
constexpr double limits[] = {2., 5.};

struct Choice
{
  std::string scene;
  double error, cost, share; // of the path [%]; [core-seconds]; of the reference's cost
};

/// Those with error and cost, the cheapest first.
std::vector<Choice> choices_of(const std::vector<const ComparedScene *> &group)
{
  std::vector<Choice> choices;
  for (const auto *one : group)
    if (const auto &row = one->row; !one->is_reference && row["path_error_percent"].is_number() &&
                                    row["core_seconds"].is_number())
      choices.push_back(
          {one->scene, row["path_error_percent"], row["core_seconds"],
           row["cost_ratio"].is_number() ? row["cost_ratio"].get<double>() : std::nan("")});
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice &a, const Choice &b) { return a.cost < b.cost; });
  return choices;
}

std::string described(const Choice &choice)
{
  return choice.scene + ", with " + with_digits(choice.error, 2) + " % error of the path at " +
         with_digits(choice.cost, 3) + " core-seconds" +
         (std::isfinite(choice.share)
              ? ", " + with_decimals(choice.share, 2) + " of the reference's cost"
              : "");
}

std::string within(const std::vector<Choice> &choices, const double limit)
{
  const std::string start = "Within " + with_digits(limit, 2) + " % ";
  for (const auto &choice : choices)
    if (choice.error <= limit)
      return start + "the cheapest is " + described(choice) + ".\n";
  const auto &best =
      *std::min_element(choices.begin(), choices.end(),
                        [](const auto &a, const auto &b) { return a.error < b.error; });
  return start + "there is none; the closest is " + described(best) + ".\n";
}

/// What the scatter hides; it is that of the reference at the time of the comparison [%].
std::string hidden(const std::vector<Choice> &choices, const double scatter)
{
  if (!std::isfinite(scatter))
    return "The reference is a single run, so its scatter is unknown and small differences may be "
           "chance; an ensemble tells.\n";
  std::vector<std::string> as_good, alike;
  for (auto one = choices.begin(); one != choices.end(); ++one)
  {
    if (one->error <= scatter)
      as_good.push_back(one->scene);
    for (auto other = one + 1; other != choices.end(); ++other)
      if (std::abs(one->error - other->error) <= scatter)
        alike.push_back(one->scene + " and " + other->scene);
  }
  std::string text = "Single runs of the reference scatter by " + with_digits(scatter, 2) + " %: ";
  text += as_good.empty()
              ? "every error is larger than that"
              : "the error of " + joined(as_good, " and ") + " cannot be told from none";
  if (!alike.empty())
    text += "; no difference can be told between " + joined(alike, ", nor between ");
  return text + ".\n";
}
} // namespace

std::string cost_advice(const std::vector<ComparedScene> &scenes)
{
  std::vector<std::string> names;
  for (const auto &one : scenes)
    if (std::find(names.begin(), names.end(), one.group) == names.end())
      names.push_back(one.group);
  std::string text;
  for (const auto &name : names)
  {
    std::vector<const ComparedScene *> group;
    double scatter = std::nan("");
    for (const auto &one : scenes)
      if (one.group == name)
      {
        group.push_back(&one);
        if (!one.is_reference && one.row["reference_scatter_percent"].is_number())
          scatter = std::fmax(scatter, one.row["reference_scatter_percent"].get<double>());
      }
    const auto choices = choices_of(group);
    if (choices.empty())
      continue;
    const std::string front = name.empty() ? "" : name + ": ";
    for (const double limit : limits)
      text += front + within(choices, limit);
    text += front + hidden(choices, scatter);
  }
  return text;
}
} // namespace ricochet
