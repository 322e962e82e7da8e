// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite elements that carry a plate outside its peridynamic zone, and what ties both together.
// In the zone elements are switched off; around it points are slaved to them (slaved_points.h) and
// elements take over what the bonds lack (calibration.h). One step reads
//   points.update_ghosts(), points.evaluate(), contact forces on the points;  evaluate();
//   points.advance(), advance(), lead()
#pragma once

#include "ricochet/coupling/calibration.h"
#include "ricochet/coupling/coupling_method.h"
#include "ricochet/coupling/slaved_points.h"

namespace ricochet
{
struct FarFieldOptions
{
  CouplingParameters coupling;
  Quadrature quadrature        = Quadrature::one_point;
  double hourglass_coefficient = 1.; // see FiniteElementForce::Options
  int coarsening_levels        = 0;  // the largest cubes have 2^levels times the edge of a cell
  Zone::Cells fine_region{};         // cubes have the size of cells here, and two cells around
};

/// Layers of the zone that a method needs, for the constructor of Zone.
Zone make_zone(const std::array<int, 3> &n_cells, const Stencil &stencil,
               const CouplingParameters &coupling);

class FarField
{
public:
  /// At rest. `points` must have been built with `zone`; both must outlive this object. Collective.
  /// Throws InputError if the plate cannot be divided into cubes.
  FarField(MPI_Comm communicator, PeridynamicForce &points, Zone &zone,
           const FarFieldOptions &options);
  FarField(const FarField &)            = delete;
  FarField &operator=(const FarField &) = delete;

  /// Slaved points take over the nodes' motion; call after every change of it, before the points'
  /// update_ghosts(). Collective.
  void lead();
  /// Forces on nodes: of the elements and of the slaved points, which must be complete. With
  /// `energy`, also the elements' energies. Collective.
  void evaluate(bool energy);
  /// Kick and drift of the nodes [s].
  void advance(double kick, double drift) { elements_.advance(kick, drift); }

  /// Of points and elements together, as their own functions say [J]. Collective.
  struct Energies
  {
    double kinetic, strain, hourglass;
    double total() const { return kinetic + strain + hourglass; }
  };
  Energies energies(double dt) const;
  PeridynamicForce::Momenta momenta() const;

  /// The cells become part of the zone, with the present motion of the elements there; the
  /// interface is set up anew. Returns whether anything changed. Collective.
  bool convert(const std::vector<Zone::Cells> &cells);

  const Zone &zone() const { return zone_; }
  PeridynamicForce &points() { return points_; }
  const PeridynamicForce &points() const { return points_; }
  FiniteElementForce &elements() { return elements_; }
  const FiniteElementForce &elements() const { return elements_; }
  const CalibrationReport &calibration() const { return calibration_.report(); }

private:
  void join();
  std::vector<ElementStiffness> blended_stiffness() const;
  void blend_forces();

  MPI_Comm communicator_;
  PeridynamicForce &points_;
  Zone &zone_;
  FarFieldOptions options_;
  FiniteElementForce elements_;
  SlavedPoints slaved_;
  Calibration calibration_;
  std::vector<double> bond_share_; // of the force of each owned node; force_blend only [-]
  std::vector<double> bond_force_; // workspace [N]
};
} // namespace ricochet
