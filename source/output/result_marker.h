// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ricochet
{
/// The hidden file that marks a folder as one of results, and that whoever works in it locks.
constexpr const char *result_marker = ".ricochet";
} // namespace ricochet
