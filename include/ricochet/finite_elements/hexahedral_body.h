// SPDX-License-Identifier: LGPL-2.1-or-later
// A free elastic body of hexahedra of any shape, for projectiles: a few thousand elements that
// every rank computes whole, so that nothing has to be sent and the result is the same on any
// number of ranks. See kernels/general_hex_kernel.h for the equations. Owns mesh and state.
#pragma once

#include "ricochet/bodies/rigid_body.h"
#include "ricochet/finite_elements/finite_element_body.h"
#include "ricochet/geometry/hex_solid.h"
#include "ricochet/kernels/general_hex_kernel.h"

namespace ricochet
{
class HexahedralBody : public Body
{
public:
  /// How elements are computed.
  struct Options
  {
    /// In units of the stiffness with which a cube bends exactly, see FiniteElementBody::Options.
    double hourglass_coefficient = 1.;
    const char *instruction_set  = nullptr; // as in hex_kernel()
    /// Per cell, how much of its strain energy counts; none: all of it. Mass and hourglass control
    /// stay whole [-].
    std::vector<double> shares   = {};
  };

  /// At rest in the reference configuration `solid`. `mirrored`: nodes at y = 0 stay there. Throws
  /// InputError if the processor lacks the instruction set or a cell is folded.
  HexahedralBody(const HexSolid &solid, const FiniteElementMaterial &material, bool mirrored,
                 const Options &options);
  /// With the default options.
  HexahedralBody(const HexSolid &solid, const FiniteElementMaterial &material, bool mirrored);
  HexahedralBody(const HexahedralBody &)            = delete;
  HexahedralBody &operator=(const HexahedralBody &) = delete;

  /// Puts the body into a rigid motion: its centroid, orientation and spin. Stress free.
  void set_motion(const RigidBody::Motion &motion);
  /// Rests in the reference configuration, all forces zero.
  void rest();

  double multiplicity() const override { return mirrored_ ? 2. : 1.; }
  void compute_internal_forces(const ForceRequest &request) override;
  void advance(double kick, double drift) override;
  Energies energies(double dt) const override;
  Momenta momenta() const override;
  std::unique_ptr<Vibration> vibration() override;
  void exchange_state(StateArchive &archive) override;
  std::string first_not_finite() const override;
  double mass() const { return total_mass_; } // as computed [kg]

  /// The rigid motion that the body's is closest to, mass-weighted; with a mirror plane that of
  /// both halves: centroid, its velocity, the rotation that takes the reference configuration
  /// nearest to the present one, and the spin with the present angular momentum; velocities are
  /// those after `kick` [s].
  RigidBody::Motion rigid_motion(double kick = 0.) const;
  /// Velocities after a kick of the present forces [s], three numbers per node [m/s].
  std::vector<double> velocity_after(double kick) const;

  /// Of one cell at the reference configuration: forces are minus this times small displacements,
  /// entry 3 corner + component [N/m].
  Eigen::Matrix<double, 24, 24> stiffness(int cell) const;

  const HexSolid &solid() const { return solid_; }                    // the reference configuration
  const FiniteElementMaterial &material() const { return material_; } // of all cells
  bool mirrored() const { return mirrored_; }                         // see the constructor
  const GeneralHexKernel &kernel() const { return *kernel_; }         // in use
  int n_nodes() const { return static_cast<int>(solid_.nodes.size()); } // of this half
  double node_mass(const int node) const { return mass_[node]; }        // [kg]
  /// Of component i = 3 node + d; 0 where it is held [1/kg].
  double inverse_mass(const int i) const { return inverse_mass_[i]; }

  // Three numbers per node.
  std::vector<double> &position() { return position_; }             // [m]
  const std::vector<double> &position() const { return position_; } // [m]
  std::vector<double> &velocity() { return velocity_; }             // at the half step [m/s]
  const std::vector<double> &velocity() const { return velocity_; } // at the half step [m/s]
  std::vector<double> &force() { return force_; }                   // [N]
  const std::vector<double> &force() const { return force_; }       // [N]

private:
  void build_blocks();
  double share(const int cell) const { return shares_.empty() ? 1. : shares_[cell]; }

  HexSolid solid_;
  FiniteElementMaterial material_;
  bool mirrored_;
  const GeneralHexKernel *kernel_;
  double hourglass_stiffness_; // [Pa]
  std::vector<double> shares_; // see Options
  std::vector<GeneralHexBlock> blocks_;
  std::vector<double> position_, velocity_, force_;
  std::vector<double> mass_, inverse_mass_; // per node, per component
  std::vector<double> strain_energy_, hourglass_energy_;
  double total_mass_ = 0.;
  Vector3 centroid_; // of the lumped masses in the reference configuration, both halves [m]
};
} // namespace ricochet
