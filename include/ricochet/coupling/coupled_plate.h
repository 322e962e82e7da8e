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
struct CoupledPlateOptions
{
  CouplingParameters coupling;
  Quadrature quadrature        = Quadrature::one_point;
  double hourglass_coefficient = 1.;    // see FiniteElementBody::Options
  int coarsening_levels        = 0;     // the largest cubes have 2^levels times the edge of a cell
  bool absorbing_edges         = false; // dashpots at the side faces, along x and y
  Zone::Cells fine_region{};            // cubes have the size of cells here, and two cells around
};

/// Layers of the zone that a method needs, for the constructor of Zone.
Zone make_zone(const std::array<int, 3> &n_cells, const Stencil &stencil,
               const CouplingParameters &coupling);

class CoupledPlate
{
public:
  /// At rest. `points` must have been built with `zone`; both must outlive this object. Collective.
  /// Throws InputError if the plate cannot be divided into cubes.
  CoupledPlate(MPI_Comm communicator, PeridynamicBody &points, Zone &zone,
               const CoupledPlateOptions &options);
  CoupledPlate(const CoupledPlate &)            = delete;
  CoupledPlate &operator=(const CoupledPlate &) = delete;

  /// Slaved points take over the nodes' motion; call after every change of it, before the points'
  /// update_ghosts(). Collective.
  void lead();
  /// Forces on nodes: of the elements and of the slaved points, which must be complete. With
  /// `energy`, also the elements' energies; not a step: see PeridynamicBody::evaluate().
  /// Collective.
  void add_forces(bool energy, bool is_step = true);
  /// The same, ready for advance(): with the mass correction.
  void evaluate(bool energy, bool is_step = true);
  /// See FiniteElementBody and PeridynamicBody: of both, if their material relaxes.
  void start_relaxation(double dt);
  /// Kick and drift of the nodes [s].
  void advance(double kick, double drift) { elements_.advance(kick, drift); }

  /// Everything at rest in the reference configuration, without forces. Collective.
  void rest();

  /// Of points and elements together, as their own functions say [J]. Collective.
  struct Energies
  {
    double kinetic, strain, hourglass;
    double viscous;  // turned into heat so far
    double absorbed; // by the edges so far
    double total() const { return kinetic + strain + hourglass; }
  };
  Energies energies(double dt) const;
  PeridynamicBody::Momenta momenta() const;

  /// The cells become part of the zone, with the present motion of the elements there; the
  /// interface is set up anew. Returns whether anything changed. Collective.
  bool convert(const std::vector<Zone::Cells> &cells);

  /// If the zone has grown so that some rank has too much of it, the points are shared anew; the
  /// elements stay where they are. Call between steps. Returns whether they were. Collective.
  bool rebalance();

  const Zone &zone() const { return zone_; }
  PeridynamicBody &points() { return points_; }
  const PeridynamicBody &points() const { return points_; }
  FiniteElementBody &elements() { return elements_; }
  const FiniteElementBody &elements() const { return elements_; }
  /// With relaxation the worse of the two parts, each in units of its own M.
  CalibrationReport calibration() const;

private:
  void join();
  void tie();
  std::vector<ElementStiffness> calibrated_stiffness();
  std::vector<ElementStiffness> blended_stiffness() const;
  void blend_forces();
  /// Histories of the elements, as means at the nodes: three components each of two fields per
  /// branch, 11, 22, 33 and 23, 13, 12. Collective.
  std::vector<std::vector<double>> nodal_histories() const;

  MPI_Comm communicator_;
  PeridynamicBody &points_;
  Zone &zone_;
  CoupledPlateOptions options_;
  FiniteElementBody elements_;
  SlavedPoints slaved_;
  Calibration calibration_;                        // of all, with relaxation of what is left
  std::unique_ptr<Calibration> shear_calibration_; // of the part that relaxes
  std::vector<double> bond_share_; // of the force of each owned node; force_blend only [-]
  std::vector<double> bond_force_; // workspace [N]
};
} // namespace ricochet
