// SPDX-License-Identifier: LGPL-2.1-or-later
// The bodies whose points touch each other.
#pragma once

#include "ricochet/peridynamics/peridynamic_body.h"

#include <vector>

namespace ricochet
{
/// From top to bottom; whoever made the list owns them.
using Bodies = std::vector<PeridynamicBody *>;
} // namespace ricochet
