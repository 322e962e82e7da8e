// SPDX-License-Identifier: LGPL-2.1-or-later
// The bodies whose points touch each other.
#pragma once

#include "ricochet/peridynamics/peridynamic_body.h"

#include <memory>
#include <vector>

namespace ricochet
{
using Bodies = std::vector<std::unique_ptr<PeridynamicBody>>;
}
