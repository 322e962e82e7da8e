// SPDX-License-Identifier: LGPL-2.1-or-later
// The project's exceptions. Whatever a user, a file or a disk can cause is thrown as one of these;
// the message says what, where, which value, which limit, and what to do. Caught only in main.
#pragma once

#include <stdexcept>
#include <string>

namespace ricochet
{
/// Base of all errors that are reported to the user in one message and end the program.
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The parameter file or the command line asks for something impossible. Exit status 2.
struct InputError : Error
{
  using Error::Error;
};

/// A file cannot be read or written: missing, not permitted, disk full. Exit status 3.
struct FileError : Error
{
  using Error::Error;
};

/// The simulation itself went wrong: NaN, runaway energy, tunnelling. Exit status 4.
struct RunError : Error
{
  using Error::Error;
};
} // namespace ricochet
