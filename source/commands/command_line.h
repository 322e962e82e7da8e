// SPDX-License-Identifier: LGPL-2.1-or-later
// How this program was started, for records of what made a result.
#pragma once

#include <string>

namespace ricochet
{
/// The program and its arguments, quoted for a shell where they need it; "" if the system does not
/// say. What started it (mpirun) is not part of it.
std::string command_line();
} // namespace ricochet
