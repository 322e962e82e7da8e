// SPDX-License-Identifier: LGPL-2.1-or-later
// Where Open MPI cannot start, it prints pages and ends the process without coming back, so that
// nobody in the process can say in one sentence what that means. A second process can.
#pragma once

#include <string>

namespace ricochet
{
/// Lives while MPI starts in a process that nobody has launched. What is written to stderr
/// meanwhile appears when it has started. If the process ends before that, its place takes one
/// sentence.
class StartWatch
{
public:
  StartWatch();
  ~StartWatch(); // MPI has started
  StartWatch(const StartWatch &)            = delete;
  StartWatch &operator=(const StartWatch &) = delete;

private:
  int stderr_ = -1, held_back_ = -1; // descriptors: what stderr was; a file in memory
  int started_ = -1;                 // connection to the second process
  int watcher_ = -1;                 // its number
};

/// The reason that Open MPI gives in such a text, in one line: its first sentence that is no
/// decoration; "" if there is none.
std::string reason_in(const std::string &text);
} // namespace ricochet
