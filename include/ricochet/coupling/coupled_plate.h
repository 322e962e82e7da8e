// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite elements that carry a plate outside its peridynamic zone, and what ties both together.
// In the zone elements are switched off; around it points are slaved to them (slaved_points.h) and
// elements take over what the bonds lack (calibration.h). Owns its points and elements.
#pragma once

#include "ricochet/base/stress_state.h"
#include "ricochet/coupling/calibration.h"
#include "ricochet/coupling/coupling_method.h"
#include "ricochet/coupling/slaved_points.h"

namespace ricochet
{
/// What of a coupled plate can be chosen.
struct CoupledPlateOptions
{
  CouplingParameters coupling;                          // how points and elements are tied
  Quadrature quadrature        = Quadrature::one_point; // of elements with the material's moduli
  double hourglass_coefficient = 1.;                    // see FiniteElementBody::Options
  int coarsening_levels        = 0;     // the largest cubes have 2^levels times the edge of a cell
  bool absorbing_edges         = false; // dashpots at the side faces, along x and y
  Zone::Cells fine_region{};            // cubes have the size of cells here, and two cells around
};

/// Layers of the zone that a method needs, for the constructor of Zone.
Zone make_zone(const std::array<int, 3> &n_cells, const Stencil &stencil,
               const CouplingParameters &coupling);

class CoupledPlate : public Body
{
public:
  /// At rest. `points` must have been built with `zone`. Collective. Throws InputError if the plate
  /// cannot be divided into cubes.
  CoupledPlate(MPI_Comm communicator, std::unique_ptr<Zone> zone,
               std::unique_ptr<PeridynamicBody> points, const CoupledPlateOptions &options);
  CoupledPlate(const CoupledPlate &)            = delete;
  CoupledPlate &operator=(const CoupledPlate &) = delete;

  double multiplicity() const override { return points_->multiplicity(); }

  /// Slaved points take over the nodes' motion; call after every change of it that is not
  /// advance()'s, before update_ghosts(). Collective.
  void interpolate_to_slaved_points();
  void update_ghosts() override { points_->update_ghosts(); }
  void break_bonds() override { points_->break_bonds(); }
  void book_fracture(const double dt) override { points_->book_fracture(dt); }
  void compute_internal_forces(const ForceRequest &request) override;
  /// The nodes' forces get what acts on slaved points.
  void distribute_slaved_forces();
  void complete_forces() override;
  void start_relaxation(double dt) override;
  bool relaxes() const override { return points_->relaxes(); }
  void advance(double kick, double drift) override;

  /// Everything at rest in the reference configuration, without forces. Collective.
  void rest();

  Energies energies(double dt) const override;
  Momenta momenta() const override;
  std::unique_ptr<Vibration> vibration() override;
  /// The zone too, if it has grown since, with the tensors that have been found.
  void exchange_state(StateArchive &archive) override;
  std::string first_not_finite() const override;

  /// The cells become part of the zone, with the present motion of the elements there; the
  /// interface is set up anew. Returns whether anything changed. Collective.
  bool convert(const std::vector<Zone::Cells> &cells);

  /// If the zone has grown so that some rank has too much of it, the points are shared anew; the
  /// elements stay where they are. Call between steps. Returns whether they were. Collective.
  bool rebalance();

  /// What the points feel that follow elements: means of the elements around each node, between
  /// which they interpolate; per point of the lattice, zero for all others. For pictures, see
  /// element_stress(). Collective.
  std::vector<StressState> slaved_stress();

  const Zone &zone() const { return *zone_; }                // which part is points
  PeridynamicBody &points() { return *points_; }             // in and around the zone
  const PeridynamicBody &points() const { return *points_; } // likewise
  FiniteElementBody &elements()
  {
    return elements_;
  } // of the whole plate, those in the zone not active
  const FiniteElementBody &elements() const { return elements_; } // likewise
  /// With relaxation the worse of the two parts, each in units of its own M.
  CalibrationReport calibration() const;
  const CoupledPlateOptions &options() const { return options_; } // as given
  MPI_Comm communicator() const { return communicator_; }         // of all ranks that have a share

private:
  void exchange_zone(StateArchive &archive);
  std::vector<std::uint8_t> layers() const; // of all cells of the zone
  /// After the zone has grown from these layers.
  void follow_zone(const std::vector<std::uint8_t> &before);
  void share_planes(const std::vector<int> &plane_starts);
  void build_interface();
  void correct_mass_of_pad();
  void find_bond_shares();
  void find_slaved_nodes();
  std::vector<ElementStiffness> calibrated_stiffness();
  std::vector<ElementStiffness> blended_stiffness() const;
  void blend_forces();
  /// Histories of the elements, as means at the nodes: three components each of two fields per
  /// branch, 11, 22, 33 and 23, 13, 12. Collective.
  std::vector<std::vector<double>> nodal_histories() const;

  MPI_Comm communicator_;
  std::unique_ptr<Zone> zone_;
  std::unique_ptr<PeridynamicBody> points_;
  CoupledPlateOptions options_;
  FiniteElementBody elements_;
  SlavedPoints slaved_;
  Calibration calibration_;                        // of all, with relaxation of what is left
  std::unique_ptr<Calibration> shear_calibration_; // of the part that relaxes
  std::vector<double> bond_share_; // of the force of each owned node; force_blend only [-]
  std::vector<double> bond_force_; // workspace [N]
};
} // namespace ricochet
