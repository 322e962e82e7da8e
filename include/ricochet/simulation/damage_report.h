// SPDX-License-Identifier: LGPL-2.1-or-later
// How badly each plate is damaged: numbers for the summary, maps for the picture.
#pragma once

#include "ricochet/output/damage_map.h"
#include "ricochet/simulation/simulation.h"

namespace ricochet
{
/// Of one plate.
struct PlateDamage
{
  /// Of the bonds of the whole plate, had it no elements; cracks it had at the start included [-].
  double broken_share;
  // Area of the faces' points that have lost more than damaged_share of their bonds, both halves.
  double front_area; // [m^2]
  double rear_area;  // [m^2]
  /// Of the joint to the plate above, what has broken [-]; negative: there is none.
  double joint_broken_share = -1.;
};

class DamageReport
{
public:
  /// A point counts as damaged beyond this share of broken bonds. A flat crack beside a point of
  /// the bulk takes 37 % of its 92 bonds, one a spacing further away 14 %.
  static constexpr double damaged_share = 0.25;

  /// Counts the bonds of the sound plates. `simulation` must outlive this object. Collective.
  DamageReport(MPI_Comm communicator, const Simulation &simulation);

  /// Of whole plates at the start.
  double n_bonds() const;

  /// Damage now, per plate. Collective, slow.
  std::vector<PlateDamage> plates() const;

  /// Damage now, for the picture; complete on rank 0. Collective.
  std::vector<DamageMap> maps() const;

private:
  MPI_Comm communicator_;
  const Simulation &simulation_;
  std::vector<double> n_bonds_;            // per plate
  std::vector<double> n_bonds_everywhere_; // per plate, had it no elements and no damage
};
} // namespace ricochet
