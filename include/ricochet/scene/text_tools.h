// SPDX-License-Identifier: LGPL-2.1-or-later
// Small operations on the text of parameter files: cut, join, and guess what was meant.
#pragma once

#include <string>
#include <vector>

namespace ricochet
{
/// Without blanks at both ends, and with every run of blanks inside replaced by one space.
std::string squeezed(const std::string &text);

/// The squeezed parts between the separators; a text without separator is one part.
std::vector<std::string> split(const std::string &text, char separator);

/// "a, b or c" with last_separator " or ".
std::string joined(const std::vector<std::string> &words, const std::string &last_separator = ", ");

/// "Plate 1/Grid spacing", or the name alone for an entry at the top.
std::string entry_path(const std::string &section, const std::string &name);

/// With ASCII letters alone changed.
std::string lower_case(std::string text);

/**
 * The candidate with the smallest edit distance to the word, capitals ignored. Returns "" if none
 * is close: more than a third of the word would have to change.
 */
std::string nearest(const std::string &word, const std::vector<std::string> &candidates);

/// The text in single quotes, cut to 60 characters, control characters replaced by '?'.
std::string in_quotes(const std::string &text);

/// "; did you mean 'x'?" for a near candidate, else ".".
std::string guess(const std::string &word, const std::vector<std::string> &candidates);

/// Letters, digits, points and signs as they are, everything else as one underscore.
std::string file_name_of(const std::string &text);

/// Six significant digits, without trailing zeros.
std::string number_text(double value);
} // namespace ricochet
