// SPDX-License-Identifier: LGPL-2.1-or-later
// Which sections and entries a parameter file may have, with their defaults, examples and meaning:
// the one table behind the checks, the error messages, the template and the used parameters.
#pragma once

#include "entry_patterns.h"

#include <memory>
#include <string>
#include <vector>

namespace ricochet
{
enum class Presence
{
  required,
  optional // has a default, or belongs to a Choice
};

struct EntryDeclaration
{
  std::string name;
  std::shared_ptr<const EntryPattern> pattern;
  Presence presence;
  std::string default_value; // "" if there is none
  std::string example;       // a value that makes sense, with its unit
  std::string documentation; // half a sentence; the pattern completes it
};

/// Exactly one of the options, each a group of entries, must be given; with `entry` not empty only
/// if that entry of the same section has one of the values.
struct Choice
{
  std::vector<std::vector<std::string>> options;
  std::string entry               = "";
  std::vector<std::string> values = {};
};

struct SectionDeclaration
{
  std::string name; // "" for the entries at the top
  std::string documentation;
  std::vector<EntryDeclaration> entries;
  std::vector<Choice> choices;
};

/**
 * The sections of a scene.
 *
 * @param stem       Name of the parameter file without folder and ending, for the defaults.
 * @param n_plates   Sections Plate 1 to Plate n_plates are declared.
 * @param materials  Sections Material NAME are declared for these names.
 */
std::vector<SectionDeclaration> scene_declarations(const std::string &stem, unsigned int n_plates,
                                                   const std::vector<std::string> &materials);

/// The sections of a stability experiment; stem as above.
std::vector<SectionDeclaration> stability_declarations(const std::string &stem);

/// A study may have the entries Axis 1 to Axis most_axes.
constexpr int most_axes = 20;

/// The one section of a study; stem as above.
std::vector<SectionDeclaration> study_declarations(const std::string &stem);
} // namespace ricochet
