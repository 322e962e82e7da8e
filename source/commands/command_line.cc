// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command_line.h"

#include <fstream>

namespace ricochet
{
namespace
{
std::string quoted(const std::string &word)
{
  const std::string harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                               "_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos)
    return word;
  std::string text = "'";
  for (const char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}
} // namespace

std::string command_line()
{
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::string text;
  for (std::string word; std::getline(in, word, '\0');)
    text += (text.empty() ? "" : " ") + quoted(word);
  return text;
}
} // namespace ricochet
