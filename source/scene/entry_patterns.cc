// SPDX-License-Identifier: LGPL-2.1-or-later
#include "entry_patterns.h"

#include "ricochet/scene/text_tools.h"

#include <algorithm>

namespace ricochet
{
QuantityPattern::QuantityPattern(const Dimension dimension, const Limit limit,
                                 std::vector<std::string> components) :
  dimension_(dimension),
  limit_(limit), components_(std::move(components)),
  n_values_(std::max<std::size_t>(1, components_.size()))
{
}

QuantityPattern QuantityPattern::list(const Dimension dimension, const Limit limit)
{
  QuantityPattern pattern(dimension, limit);
  pattern.n_values_ = 0;
  return pattern;
}

std::string QuantityPattern::problem(const std::string &value) const
{
  return parse_quantities(value, dimension_, limit_, n_values_).problem;
}

std::string QuantityPattern::expected() const
{
  std::string text = dimension_name(dimension_);
  if (n_values_ > 1)
    text = joined(components_) + ", each " + text;
  if (limit_ == Limit::positive)
    text += " above 0";
  if (limit_ == Limit::not_negative)
    text += " of 0 or more";
  if (limit_ == Limit::fraction)
    text += " from 0 to 1";
  if (dimension_ != Dimension::number)
    text += " in " + unit_names(dimension_);
  return n_values_ > 0 ? text : "one or more values separated by commas, each " + text;
}

std::vector<double> QuantityPattern::values(const std::string &text) const
{
  return parse_quantities(text, dimension_, limit_, n_values_).values;
}

ChoicePattern::ChoicePattern(std::vector<std::string> choices) : choices_(std::move(choices)) {}

std::string ChoicePattern::problem(const std::string &value) const
{
  if (std::find(choices_.begin(), choices_.end(), value) != choices_.end())
    return "";
  return "There is no choice " + in_quotes(value) + guess(value, choices_);
}

std::string ChoicePattern::expected() const
{
  return joined(choices_, " or ");
}

TextPattern::TextPattern(std::string expected) : expected_(std::move(expected)) {}
} // namespace ricochet
