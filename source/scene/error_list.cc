// SPDX-License-Identifier: LGPL-2.1-or-later
#include "error_list.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>

namespace ricochet
{
namespace
{
/// An error that is several.
template <class Kind>
struct Several : Kind
{
  std::vector<std::string> messages;

  explicit Several(const std::vector<std::string> &several) :
    Kind(together(several)), messages(several)
  {
  }

  static std::string together(const std::vector<std::string> &several)
  {
    std::string text = std::to_string(several.size()) + " errors:";
    for (const auto &message : several)
      text += "\n" + message;
    return text;
  }
};
} // namespace

void ErrorList::add(const std::string &message)
{
  if (std::find(messages_.begin(), messages_.end(), message) == messages_.end())
    messages_.push_back(message);
}

void ErrorList::keep(const std::exception_ptr &error)
{
  const auto add_all = [&](const auto &several)
  {
    for (const auto &message : several.messages)
      add(message);
  };
  if (!first_)
    first_ = error;
  try
  {
    std::rethrow_exception(error);
  }
  catch (const Several<InputError> &several)
  {
    of_input_ = true;
    add_all(several);
  }
  catch (const Several<FileError> &several)
  {
    add_all(several);
  }
  catch (const InputError &one)
  {
    of_input_ = true;
    add(one.what());
  }
  catch (const FileError &one)
  {
    add(one.what());
  }
}

void ErrorList::throw_if_any() const
{
  if (messages_.size() == 1)
    std::rethrow_exception(first_);
  if (messages_.empty())
    return;
  if (of_input_)
    throw Several<InputError>(messages_);
  throw Several<FileError>(messages_);
}
} // namespace ricochet
