// SPDX-License-Identifier: LGPL-2.1-or-later
// What the value of an entry has to look like: patterns that say what is wrong with a value and
// what is expected instead.
#pragma once

#include "ricochet/scene/quantity.h"

#include <string>
#include <vector>

namespace ricochet
{
/// Base of all patterns. An empty text is never asked about: it means "not given".
class EntryPattern
{
public:
  virtual ~EntryPattern() = default;

  /// Why the value does not fit, a sentence; "" if it fits.
  virtual std::string problem(const std::string &value) const = 0;

  /// What is expected, "a length above 0 in um, mm, cm, m or in".
  virtual std::string expected() const = 0;
};

/// One quantity, a tuple of quantities of the same dimension, or a list of any length.
class QuantityPattern : public EntryPattern
{
public:
  static QuantityPattern list(Dimension dimension, Limit limit);

  /// components names the values of a tuple: {"length", "width"}; empty for a single value.
  QuantityPattern(Dimension dimension, Limit limit, std::vector<std::string> components = {});

  std::string problem(const std::string &value) const override;
  std::string expected() const override;

  Dimension dimension() const { return dimension_; }
  Limit limit() const { return limit_; }
  const std::vector<std::string> &components() const { return components_; }
  bool is_list() const { return n_values_ == 0; }

  /// The values in SI; the text must match.
  std::vector<double> values(const std::string &text) const;

private:
  Dimension dimension_;
  Limit limit_;
  std::vector<std::string> components_;
  unsigned int n_values_; // 0: any number above 0
};

/// One of several words.
class ChoicePattern : public EntryPattern
{
public:
  explicit ChoicePattern(std::vector<std::string> choices);

  std::string problem(const std::string &value) const override;
  std::string expected() const override;

  const std::vector<std::string> &choices() const { return choices_; }

private:
  std::vector<std::string> choices_;
};

/// Any text.
class TextPattern : public EntryPattern
{
public:
  /// expected: what the text is, "a folder".
  explicit TextPattern(std::string expected);

  std::string problem(const std::string &) const override { return ""; }
  std::string expected() const override { return expected_; }

private:
  std::string expected_;
};
} // namespace ricochet
