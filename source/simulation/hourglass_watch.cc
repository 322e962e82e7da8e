// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/hourglass_watch.h"

namespace ricochet
{
void HourglassWatch::update(const Moment &moment)
{
  const auto &simulation = moment.simulation;
  for (std::size_t i = 0; i < simulation.n_plates(); ++i)
  {
    const auto *const plate = simulation.coupled_plate(i);
    if (plate == nullptr)
      continue;
    const auto energies = plate->multiplicity() * plate->elements().energies(simulation.dt());
    const double stored = energies.strain + energies.hourglass;
    if (moment.totals.share(stored) < least_energy)
      continue;
    if (const double share = energies.hourglass / stored;
        largest_.time < 0. || share > largest_.share)
      largest_ = {share, simulation.time(), i};
  }
}
} // namespace ricochet
