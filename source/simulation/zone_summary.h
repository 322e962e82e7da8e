// SPDX-License-Identifier: LGPL-2.1-or-later
// What the summary says of each plate's zone of points, its elements and what ties them together.
#pragma once

#include "ricochet/simulation/run_summary.h"

namespace ricochet
{
/// One object per plate, from top to bottom.
nlohmann::ordered_json zone_summary(const Simulation &simulation,
                                    const std::vector<InterfaceReport> &interfaces);

void append_zone_fields(std::vector<SummaryField> &fields, const std::string &place);
} // namespace ricochet
