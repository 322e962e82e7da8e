// SPDX-License-Identifier: LGPL-2.1-or-later
// Looks after the edge of a peridynamic zone: bonds near it that are stretched half way to their
// limit say that damage is coming. An adaptive zone then grows, ahead of need; a fixed one is
// reported as reached, and its results should not be quoted.
#pragma once

#include "ricochet/coupling/coupled_plate.h"

#include <limits>

namespace ricochet
{
class AdaptiveZone
{
public:
  /// With the usual time step waves cross less than the interface band in so many steps.
  static constexpr int steps_between_looks = 8;

  /// When and whether the zone grows.
  struct Parameters
  {
    double stretch;        // of a bond, at which damage is expected [-]
    bool adaptive;         // whether it grows at all
    bool rebalance = true; // whether ranks share the points anew as the zone grows
  };

  /// `coupled_plate` and its points must outlive this object.
  AdaptiveZone(MPI_Comm communicator, CoupledPlate &coupled_plate, const Parameters &parameters);

  /// Call once per step, before bonds break, with ghosts up to date. `time` and `dt` in s. Beyond
  /// `furthest` along x nothing grows yet [m]. Returns whether elements became points. Collective.
  bool update(double time, double dt, double furthest = std::numeric_limits<double>::infinity());

  /// Saves or restores what has become of the zone, once the plate has got it back. Collective.
  void exchange_state(StateArchive &archive);

  long n_conversions() const { return n_conversions_; }         // how often elements became points
  long n_redistributions() const { return n_redistributions_; } // of points over the ranks
  /// Energy lost in conversions so far, of the plate as computed [J]: lumped masses hold more
  /// kinetic energy than the points they become.
  double loss() const { return loss_; }
  /// When damage first came near an interface that did not give way; negative: never [s].
  double reached() const { return reached_; }

private:
  void find_interface_band();
  std::vector<Zone::Cell> columns_in_danger();
  double energy(double dt);

  MPI_Comm communicator_;
  CoupledPlate &coupled_plate_;
  Parameters parameters_;
  int band_width_, brick_; // in cells
  long n_updates_ = 0, n_conversions_ = 0, n_redistributions_ = 0;
  double loss_ = 0., reached_ = -1.;
  std::vector<char> interface_band_;             // per cell: within reach of the interface
  std::vector<Lattice::BlockRange> band_blocks_; // with points of such cells
};
} // namespace ricochet
