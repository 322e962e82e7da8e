// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings.h"

namespace ricochet
{
Binding quantity(double &variable, const Dimension dimension, const Limit limit)
{
  return quantities({&variable}, {}, dimension, limit);
}

Binding quantities(const std::vector<double *> &variables,
                   const std::vector<std::string> &components, const Dimension dimension,
                   const Limit limit)
{
  const auto pattern = std::make_shared<QuantityPattern>(dimension, limit, components);
  return {pattern, [pattern, variables](const std::string &text)
          {
            const auto values = pattern->values(text);
            for (std::size_t i = 0; i < variables.size(); ++i)
              *variables[i] = values[i];
          }};
}

Binding quantity_list(std::vector<double> &variable, const Dimension dimension, const Limit limit)
{
  const auto pattern = std::make_shared<QuantityPattern>(QuantityPattern::list(dimension, limit));
  return {pattern,
          [pattern, &variable](const std::string &text) { variable = pattern->values(text); }};
}

Binding flag(bool &variable)
{
  return choice(variable, Words<bool>{{true, "true"}, {false, "false"}});
}

Binding text(std::string &variable, const std::string &expected)
{
  return {std::make_shared<TextPattern>(expected),
          [&variable](const std::string &text) { variable = text; }};
}

Binding unbound_text(const std::string &expected)
{
  return {std::make_shared<TextPattern>(expected), [](const std::string &) {}};
}

Binding word(std::string &variable, const std::vector<std::string> &words)
{
  return {std::make_shared<ChoicePattern>(words),
          [&variable](const std::string &text) { variable = text; }};
}
} // namespace ricochet
