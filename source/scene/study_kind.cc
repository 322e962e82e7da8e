// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_kind.h"

#include "ricochet/scene/quantity.h"
#include "ricochet/scene/text_tools.h"
#include "study_axis.h"

#include <algorithm>

namespace ricochet
{
namespace
{
const Words<StudyKind> kinds{
    {StudyKind::cases, "cases"}, {StudyKind::map, "map"}, {StudyKind::convergence, "convergence"}};

/// Columns of numbers that have at least two of them; a limit's has.
std::size_t n_axes_of_numbers(const StudyParameters &study)
{
  std::size_t n = 0;
  for (const auto &axis : study.axes)
    if (axis.values.size() > 1 && !axis.is_ensemble)
    {
      const auto columns = columns_of({axis});
      n += std::any_of(columns.begin(), columns.end(),
                       [](const auto &column) { return column.column.is_number; });
    }
  return n;
}

void check_map(const Entry &kind, const StudyParameters &study)
{
  const auto n = n_axes_of_numbers(study);
  if (n != 2)
    kind.fail("A map needs two axes of numbers with two values or more, and this study has " +
                  (n == 0 ? std::string("none") : std::to_string(n)) + ".",
              n < 2 ? "Add another one, for example 'set Axis 2 = Impact/Incidence angle: 20 deg | "
                      "30 deg'."
                    : "Make a study of its own for the others, or leave out 'Kind'.");
  if (study.combination == Combination::zipped)
    kind.fail("Axes that go side by side make a line and no map.", "Remove 'Combine'.");
}

/// The values of the axis that is refined, in its unit.
std::vector<double> resolutions(const Entry &kind, const StudyParameters &study)
{
  if (study.axes.empty())
    kind.fail("There is no axis to refine.",
              "Add 'set Axis 1 = Plate 1/Grid spacing: 1.5 mm | 1.0 mm | 0.75 mm'.");
  const auto column = columns_of({study.axes[0]}).front().column;
  std::vector<double> values;
  for (const auto &value : study.axes[0].values)
  {
    const auto number = value_in(column, split(value, ';').front()).number;
    if (!number || !(*number > 0.))
      kind.fail("'Axis 1', which is refined, has the value " + in_quotes(value) +
                    ", which is no number above 0.",
                "Let it be the grid spacing or the size of elements: the smaller, the finer.");
    values.push_back(*number);
  }
  if (values.size() < 2)
    kind.fail("'Axis 1', which is refined, has a single value.",
              "Give it three values or more: an order needs three.");
  return values;
}

/// The number of the value that the others are compared with.
std::size_t finest_of(const Entry &kind, const Entry &reference, const StudyParameters &study)
{
  const auto numbers = resolutions(kind, study);
  if (!reference.is_given())
    return std::min_element(numbers.begin(), numbers.end()) - numbers.begin();
  const auto &values = study.axes[0].values;
  const auto found   = std::find_if(values.begin(), values.end(),
                                    [&](const std::string &value)
                                    { return split(value, ';').front() == reference.text(); });
  if (found == values.end())
    reference.fail("A study of convergence is compared with one of the values of 'Axis 1', and " +
                       in_quotes(reference.text()) + " is none.",
                   "Name one of " + joined(values, " or ") +
                       ", or leave the entry out: then it is the smallest.");
  return found - values.begin();
}
} // namespace

const Entry &add_kind(Section &in, StudyParameters &study)
{
  return in.with_default(
      "Kind", choice(study.kind, kinds), "cases",
      "What the study is for. map: outcomes and exit speeds over two axes of numbers, which are "
      "drawn; convergence: the first axis is refined, the smaller the finer, and the errors "
      "against its smallest value and the observed order are worked out");
}

void check_kind(const Entry &kind, const Entry &reference, StudyParameters &study)
{
  if (study.kind == StudyKind::map)
    check_map(kind, study);
  if (study.kind != StudyKind::convergence)
    return;
  if (study.combination != Combination::all)
    kind.fail("In a study of convergence all values of the first axis go with all of the others.",
              "Remove 'Combine'.");
  if (!study.axes.empty() && study.axes[0].is_ensemble)
    kind.fail("'Axis 1' is refined and cannot be an ensemble.", "Take it out of 'Ensemble'.");
  study.finest = finest_of(kind, reference, study);
}
} // namespace ricochet
