// SPDX-License-Identifier: LGPL-2.1-or-later
// One line of the history: what stands in each column, in what unit and what it means, in one list.
#pragma once

#include "ricochet/simulation/simulation.h"

#include <functional>
#include <string>
#include <vector>

namespace ricochet
{
/// Sums over all ranks and plates at one record.
struct Totals
{
  EnergyBalance energies{}; // [J]
  double broken_bonds = 0.; // so far, each once [-]

  /// An energy as a share of all that there was at the start and that a drive has brought [-].
  double share(const double energy) const
  {
    const double all = energies.initial + energies.drive;
    return all > 0. ? energy / all : 0.;
  }
  /// What the balance does not account for, as such a share [-].
  double relative_residual() const { return share(energies.residual()); }
};

/// Between compute_forces(true) and advance(). Collective.
Totals totals_of(const Simulation &simulation);

/// What a record is computed from: a simulation between compute_forces(true) and advance().
struct Moment
{
  const Simulation &simulation;  // at that time
  const Totals &totals;          // now
  std::size_t projectile    = 0; // of which it speaks
  /// Of that projectile, velocities too.
  Projectile::Motion motion = simulation.present_motion(projectile);
  Vector3 support           = simulation.support_reaction(); // force on the plates [N]
};

/// A column of history.csv and a dataset of history.h5. Whoever adds one writes this row and
/// nothing else.
struct HistoryColumn
{
  std::string name;                                  // without comma and slash
  std::string unit;                                  // "-" if dimensionless
  std::function<double(const Moment &moment)> value; // in that unit
  std::string meaning;                               // half a sentence, for the user
};

/// In the order of the file. With several projectiles the columns of the first are followed by all
/// others, and these by what the further projectiles have of their own: "x 2", "force z 3".
std::vector<HistoryColumn> history_columns(std::size_t n_projectiles = 1);

/// One value per column, of all projectiles that there are.
std::vector<double> history_record(const Moment &moment);
} // namespace ricochet
