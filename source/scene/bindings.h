// SPDX-License-Identifier: LGPL-2.1-or-later
// Ties the value of an entry to the variable that takes it: what a value has to look like, and how
// it gets there. The first half of a row of a section, see section.h.
#pragma once

#include "entry_patterns.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ricochet
{
struct Binding
{
  std::shared_ptr<const EntryPattern> pattern;
  std::function<void(const std::string &)> assign; // takes a text that matches the pattern
};

/// Words of a parameter file and what they mean, the only place that says so.
template <class T>
struct Word
{
  T value;
  std::string name;
};
template <class T>
using Words = std::vector<Word<T>>;

/// The same from a table whose rows have `name` and a member of another name.
template <class T, class Table, class Row>
Words<T> words_of(const Table &table, T Row::*value)
{
  Words<T> words;
  for (const Row &row : table)
    words.push_back({row.*value, row.name});
  return words;
}

template <class T>
std::vector<std::string> names_of(const Words<T> &words)
{
  std::vector<std::string> names;
  for (const auto &word : words)
    names.push_back(word.name);
  return names;
}

template <class T>
std::string name_of(const Words<T> &words, const T &value)
{
  for (const auto &word : words)
    if (word.value == value)
      return word.name;
  return "";
}

// The variables must outlive the section that they are bound in.

/// One number with its unit, in SI afterwards.
Binding quantity(double &variable, Dimension dimension, Limit limit);

/// A tuple of quantities of one dimension; components names them.
Binding quantities(const std::vector<double *> &variables,
                   const std::vector<std::string> &components, Dimension dimension, Limit limit);

/// One or more quantities of one dimension.
Binding quantity_list(std::vector<double> &variable, Dimension dimension, Limit limit);

/// true or false.
Binding flag(bool &variable);

/// Any text; expected says what it is, "a folder".
Binding text(std::string &variable, const std::string &expected);

/// Any text that a check takes apart (Entry::text) and that no variable takes.
Binding unbound_text(const std::string &expected);

/// One of the words, kept as it is.
Binding word(std::string &variable, const std::vector<std::string> &words);

/// What one of the words means.
template <class T>
Binding choice(T &variable, const Words<T> &words)
{
  return {std::make_shared<ChoicePattern>(names_of(words)),
          [&variable, words](const std::string &text)
          {
            for (const auto &word : words)
              if (word.name == text)
                variable = word.value;
          }};
}
} // namespace ricochet
