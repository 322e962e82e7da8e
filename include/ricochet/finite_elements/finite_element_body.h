// SPDX-License-Identifier: LGPL-2.1-or-later
// One body of explicit finite elements, see kernels/hex_kernel.h for the equations. Owns the body's
// mesh and state. Mass is lumped to the nodes; hanging nodes carry none, they follow their masters
// and hand their force and mass on to them. Its parts: element_groups (forces and history of the
// elements), consistent_mass, absorbing_boundary; here is what nodes do with their forces.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/finite_elements/element_stiffness.h"
#include "ricochet/finite_elements/hex_mesh.h"
#include "ricochet/finite_elements/lumped_mass.h"
#include "ricochet/materials/finite_element_material.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace ricochet
{
class AbsorbingBoundary;
class ConsistentMass;
class ElementGroups;

class FiniteElementBody : public Body
{
public:
  /// How elements are computed, and which of them.
  struct Options
  {
    Quadrature quadrature                       = Quadrature::one_point;
    /// 1: a cube in pure bending stores its exact energy E kappa^2 I / 2, which one point in the
    /// middle does not see at all: k = E h/48 for the vectors st, rt, rs and, by the same formula
    /// for a strain that also varies along the third axis, E h/144 for rst. Both follow from the
    /// integral of (E/2) (2 q st / 8 h)^2 over the cube. [-]
    double hourglass_coefficient                = 1.;
    /// Elements for whose centre this is false carry neither force nor mass; empty: all do.
    std::function<bool(const Vector3 &)> active = {};
    /// As in hex_kernel().
    const char *instruction_set                 = nullptr;
  };

  /// At rest in the reference configuration; nodes on a mirror plane have u_y = 0. Collective.
  /// Throws InputError if the processor lacks the instruction set or the mesh is impossible.
  FiniteElementBody(MPI_Comm communicator, const HexMesh::Box &box,
                    const FiniteElementMaterial &material, const Options &options);
  /// With the default options.
  FiniteElementBody(MPI_Comm communicator, const HexMesh::Box &box,
                    const FiniteElementMaterial &material);
  ~FiniteElementBody() override;
  FiniteElementBody(const FiniteElementBody &)            = delete;
  FiniteElementBody &operator=(const FiniteElementBody &) = delete;

  /// Gives these elements their own tensors, with full quadrature; all others have the material's
  /// moduli, whatever was set before. Elements that are not active are left out. History stays; an
  /// element that changes its Gauss points spreads it or takes the mean. Collective.
  void set_stiffness(const std::vector<ElementStiffness> &stiffness);

  /// From now on the shear stiffness relaxes as the material says, from no history, and
  /// compute_internal_forces() must be called once per time step of that length [s]: it moves the
  /// history on. Hourglass stiffness stays elastic with the instantaneous modulus: it stands for
  /// bending within an element, whose waves last a few steps, and a softer one would let go of the
  /// modes that it has to hold. Throws InputError for an impossible series. History is kept in
  /// double precision.
  void start_relaxation(double dt) override;
  bool relaxes() const override; // since start_relaxation(), if the material does
  /// E_b,k, the strain that the dashpots of a branch have taken over; mean of the Gauss points [-].
  Eigen::Matrix3d back_strain(int element, int branch) const;
  /// What bonds take over from an element before the next step, see BondViscosity::take_over().
  Eigen::Matrix3d history(int element, int branch) const;
  /// Elements for whose centre this is false carry neither force nor mass from now on; all others
  /// do, with the material's moduli until set_stiffness(). Masses are lumped anew, and none is
  /// consistent until set_consistent_mass(). Collective.
  void set_active(const std::function<bool(const Vector3 &)> &active);

  /// The mass of these elements acts as if it sat in the centres of their sub-cubes, so many along
  /// an edge, and not in the corners, to first order: correct_mass() adds M_L^-1 (f - M_C a) to a =
  /// M_L^-1 f. The sum of all forces stays as it is, because the rows of both mass matrices have
  /// the same sums. Collective.
  void set_consistent_mass(const std::vector<int> &elements, int points_per_edge);
  /// Nodes take over these velocities, three numbers per local node of which those of owned nodes
  /// count, and the momentum that belongs to them; update_ghosts() is due. Throws RunError if the
  /// momentum under the consistent mass is not found. Collective.
  void set_velocity(const std::vector<double> &velocity);
  /// At rest in the reference configuration, without forces. Collective.
  void rest();

  /// The node keeps its velocity along this axis, zero unless set otherwise; its force is then the
  /// reaction, also after set_active(). `node` is local; on ranks that do not own it the call does
  /// nothing.
  void fix(int node, int component);

  /// Waves leave through these faces of the box, -x, +x, -y, +y, -z, +z: dashpots pull back with
  /// rho c_P v_n and rho c_S v_t per area, which absorbs plane waves at normal incidence altogether
  /// (Lysmer and Kuhlemeyer 1969); at 60 degrees 6 % of the energy of P waves returns, 11 % of S
  /// waves. Constant loads push the body away: nothing holds it there. The faces must keep their
  /// elements, without consistent mass. Collective.
  void absorb_at(const std::array<bool, 6> &faces);

  double multiplicity() const override { return mesh_.box().mirror_y ? 2. : 1.; }

  /// Also hanging nodes follow their masters.
  void update_ghosts() override;
  /// On owned nodes; with energies also each element's.
  void compute_internal_forces(const ForceRequest &request) override;
  void complete_forces() override { correct_mass(); }
  /// Call when all forces are there and before advance(). Collective.
  void correct_mass();
  /// Of the owned nodes.
  void advance(double kick, double drift) override;

  Energies energies(double dt) const override;
  /// With what dashpots have carried off.
  Momenta momenta() const override;

  std::unique_ptr<Vibration> vibration() override;
  /// Which elements are active, and their tensors, must be as they were.
  void exchange_state(StateArchive &archive) override;
  std::string first_not_finite() const override;
  /// Lumped mass of all nodes [kg]. Collective.
  double total_mass() const;

  const HexMesh &mesh() const { return mesh_; }                       // as built
  const FiniteElementMaterial &material() const { return material_; } // as given
  const HexKernel &kernel() const { return *kernel_; }                // in use
  // Three numbers per local node, see HexMesh.
  std::vector<double> &position() { return position_; }             // [m]
  const std::vector<double> &position() const { return position_; } // [m]
  const std::vector<double> &velocity() const { return velocity_; } // at the half step [m/s]
  std::vector<double> &force() { return force_; }                   // [N]
  const std::vector<double> &force() const { return force_; }       // [N]
  /// Of an owned node; zero for hanging nodes and where no active element is [kg].
  double mass(const int node) const { return mass_.mass[node]; }
  /// 1/m; zero where a component is not integrated [1/kg].
  double inverse_mass(const int node, const int component) const
  {
    return mass_.inverse[3 * node + component];
  }

  /// Of an owned node, before correct_mass() [N].
  Vector3 uncorrected_force(int node) const;
  /// f M_eff^-1 f over this rank's nodes, after correct_mass() [N^2/kg].
  double squared_force() const;

  bool is_active(int element) const; // carries force and mass
  /// At the last compute_internal_forces() with energies; zero if not active [J].
  double strain_energy(int element) const;
  double hourglass_energy(int element) const; // likewise [J]
  /// F in the middle of an element [-].
  Eigen::Matrix3d deformation_gradient(int element) const;
  /// Second Piola-Kirchhoff stress at the deformation of the middle, by the mean of the Gauss
  /// points' tensors; zero if not active [Pa].
  Eigen::Matrix3d stress(int element) const;

private:
  MPI_Comm communicator_;
  HexMesh mesh_;
  FiniteElementMaterial material_;
  const HexKernel *kernel_;
  std::unique_ptr<ElementGroups> elements_;
  std::vector<double> position_, velocity_, force_;
  LumpedMass mass_;
  std::vector<int> fixed_;                          // components that fix() holds
  std::unique_ptr<ConsistentMass> consistent_mass_; // null on all ranks: all mass is lumped
  std::unique_ptr<AbsorbingBoundary> boundary_;     // null: waves are reflected
};
} // namespace ricochet
