// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/plate_stress.h"

namespace ricochet
{
std::vector<StressState> plate_stress(const PeridynamicBody &points, CoupledPlate *const coupled,
                                      const std::vector<std::ptrdiff_t> &indices)
{
  const auto slaved = coupled != nullptr ? coupled->slaved_stress() : std::vector<StressState>();
  PointStress of_bonds(points);
  std::vector<StressState> states;
  states.reserve(indices.size());
  for (const std::ptrdiff_t p : indices)
    states.push_back(points.lattice().free(p) ? of_bonds.of(p) : slaved[p]);
  return states;
}
} // namespace ricochet
