// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <sstream>

namespace ricochet
{
namespace
{
// Levenshtein's distance in which a swap of neighbours also counts as one change.
unsigned int edit_distance(const std::string &a, const std::string &b)
{
  const auto n = a.size(), m = b.size();
  std::vector<unsigned int> before_last, last(m + 1), row(m + 1);
  std::iota(last.begin(), last.end(), 0U);
  for (std::size_t i = 1; i <= n; ++i)
  {
    row[0] = i;
    for (std::size_t j = 1; j <= m; ++j)
    {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last        = row;
  }
  return last[m];
}
} // namespace

std::string squeezed(const std::string &text)
{
  std::istringstream words(text);
  std::string result, word;
  while (words >> word)
    result += (result.empty() ? "" : " ") + word;
  return result;
}

std::vector<std::string> split(const std::string &text, const char separator)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;)
  {
    const auto end = text.find(separator, begin);
    parts.push_back(squeezed(text.substr(begin, end - begin)));
    if (end == std::string::npos)
      return parts;
    begin = end + 1;
  }
}

std::string joined(const std::vector<std::string> &words, const std::string &last_separator)
{
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i)
    result += (i == 0 ? "" : i + 1 == words.size() ? last_separator : ", ") + words[i];
  return result;
}

std::string entry_path(const std::string &section, const std::string &name)
{
  return section.empty() ? name : section + "/" + name;
}

std::string lower_case(std::string text)
{
  for (char &c : text)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string nearest(const std::string &word, const std::vector<std::string> &candidates)
{
  std::string best;
  unsigned int best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const auto &candidate : candidates)
  {
    const unsigned int distance = edit_distance(lower_case(word), lower_case(candidate));
    if (distance < best_distance)
    {
      best          = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string in_quotes(const std::string &text)
{
  constexpr std::size_t longest = 60;
  std::string shown             = text.substr(0, longest);
  for (char &c : shown)
    if (static_cast<unsigned char>(c) < ' ' || c == 127)
      c = '?';
  return "'" + shown + (text.size() > longest ? "..." : "") + "'";
}

std::string guess(const std::string &word, const std::vector<std::string> &candidates)
{
  const std::string meant = nearest(word, candidates);
  return meant.empty() ? "." : "; did you mean '" + meant + "'?";
}

std::string file_name_of(const std::string &text)
{
  std::string name;
  for (const char c : text)
  {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '-' || c == '+';
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  if (!name.empty() && name.back() == '_')
    name.pop_back();
  return name;
}

std::string number_text(const double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}
} // namespace ricochet
