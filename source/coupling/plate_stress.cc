// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/plate_stress.h"

namespace ricochet
{
std::vector<StressState> plate_stress(const PeridynamicBody &points, CoupledPlate *const coupled)
{
  auto states = coupled != nullptr ? coupled->slaved_stress()
                                   : std::vector<StressState>(points.lattice().size());
  PointStress of_bonds(points);
  points.lattice().for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (points.lattice().free(p))
          states[p] = of_bonds.of(p);
      });
  return states;
}
} // namespace ricochet
