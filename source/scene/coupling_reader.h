// SPDX-License-Identifier: LGPL-2.1-or-later
// Entries that the sections Coupling and Stability share.
#pragma once

#include "parameters.h"
#include "ricochet/coupling/coupling_method.h"

namespace ricochet
{
/// What ties points and elements together. Throws InputError if the blend is wider than 10
/// horizons.
CouplingParameters read_coupling(const Parameters &parameters, const std::string &section);
} // namespace ricochet
