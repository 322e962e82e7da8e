// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors of a parameter file that do not follow from each other, told together: who has made five
// mistakes learns of them in one go.
#pragma once

#include <exception>
#include <string>
#include <vector>

namespace ricochet
{
class ErrorList
{
public:
  /// Calls the action and keeps the InputError or FileError, or the list of such, that it throws.
  template <class Action>
  void collect(const Action &action)
  {
    try
    {
      action();
    }
    catch (...)
    {
      keep(std::current_exception());
    }
  }
  bool empty() const { return messages_.empty(); }
  std::size_t size() const { return messages_.size(); } // without what was said before

  /// Throws a single error as it was, several as one InputError (or FileError, if all are) of all
  /// messages, in the order in which they came.
  void throw_if_any() const;

private:
  void keep(const std::exception_ptr &error);
  void add(const std::string &message);

  std::vector<std::string> messages_; // each once
  std::exception_ptr first_;
  bool of_input_ = false; // one of them
};
} // namespace ricochet
