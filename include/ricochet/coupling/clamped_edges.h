// SPDX-License-Identifier: LGPL-2.1-or-later
// Supports: a plate whose points and nodes in a frame along some of its side faces do not move. The
// reaction is what it takes to hold them.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/bodies/interaction.h"
#include "ricochet/coupling/clamped_sides.h"
#include "ricochet/finite_elements/finite_element_body.h"
#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/peridynamics/plane_archive.h"

#include <vector>

namespace ricochet
{
class ClampedEdges : public Interaction
{
public:
  /// Holds all of the plate that is nearer to one of its held faces than `width` [m], from rest.
  /// `elements`: null if the plate is peridynamic throughout. Both must outlive this object, which
  /// must act after all other interactions.
  ClampedEdges(MPI_Comm communicator, PeridynamicBody &points, FiniteElementBody *elements,
               ClampedSides sides, double width);

  void bodies_changed() override;
  void add_forces(double dt) override;
  /// Also adds to the impulse.
  void record_work(double dt) override;
  void exchange_state(StateArchive &archive) override;
  double energy() const override { return 0.; }
  double friction_work() const override { return 0.; } // what rests does no work

  /// Force of the supports on the plate, both halves, once the forces are complete [N]. Collective.
  Vector3 reaction() const;
  /// What the supports have given to the plate so far, both halves. Collective.
  Momenta impulse() const;

private:
  struct HeldPoint
  {
    std::ptrdiff_t point;
    Vector3 reaction; // of the last add_forces() [N]
  };

  struct HeldNode
  {
    int node; // owned
    /// What it has been given so far: each keeps its own, as a sum over a rank's nodes would depend
    /// on which these are.
    Momenta impulse;
  };

  bool holds(const Vector3 &reference) const;
  void find_points();
  /// Both halves; without what the mirror plane cancels.
  Vector3 whole(const Vector3 &linear) const;

  MPI_Comm communicator_;
  PeridynamicBody &points_;
  FiniteElementBody *elements_;
  ClampedSides sides_;
  double width_; // [m]
  std::vector<HeldPoint> held_points_;
  std::vector<HeldNode> held_nodes_;
  PlaneSums<6> impulse_of_points_;
};
} // namespace ricochet
