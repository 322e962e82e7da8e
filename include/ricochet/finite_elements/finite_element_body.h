// SPDX-License-Identifier: LGPL-2.1-or-later
// The internal force of one body of explicit finite elements, see kernels/hex_kernel.h for the
// equations. Owns the body's mesh and state. Mass is lumped to the nodes; hanging nodes carry none,
// they follow their masters and hand their force and mass on to them.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/finite_elements/hex_mesh.h"
#include "ricochet/kernels/hex_kernel.h"
#include "ricochet/materials/relaxation.h"

#include <array>
#include <functional>
#include <vector>

namespace ricochet
{
struct FiniteElementMaterial
{
  double density;       // [kg/m^3]
  double bulk_modulus;  // [Pa]
  double shear_modulus; // [Pa], the instantaneous one
  // Of the shear modulus; takes effect by start_relaxation().
  RelaxationSeries relaxation = {};
};

/// How an element integrates its energy. `one_point` takes about half the time and bends as freely
/// as a beam; `full` (2 x 2 x 2 points) is the reference: it has no hourglass modes, but locks in
/// bending: the curvature of a cube costs E/(1 - nu^2) + mu instead of E, which stiffens a plate of
/// n cubes by (1/(1 - nu^2) + 1/(2 (1 + nu)) - 1)/n^2.
enum class Quadrature
{
  one_point,
  full
};

/// An element's own symmetric stiffness tensor at each Gauss point [Pa], as in HexTensors. The
/// eigenvalues must not be negative, or the body is unstable.
struct ElementStiffness
{
  int element; // number in mesh().elements()
  std::array<std::array<double, HexTensors::n_entries>, 8> tensors;
  /// The part of them that relaxes with the material, C_mu; zero: they stay elastic. Neither C_mu
  /// nor C - C_mu may have negative eigenvalues.
  std::array<std::array<double, HexTensors::n_entries>, 8> shear = {};
};

class FiniteElementBody : public Body
{
public:
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
  FiniteElementBody(MPI_Comm communicator, const HexMesh::Box &box,
                    const FiniteElementMaterial &material);
  FiniteElementBody(const FiniteElementBody &)            = delete;
  FiniteElementBody &operator=(const FiniteElementBody &) = delete;

  /// Gives these elements their own tensors, with full quadrature; all others have the material's
  /// moduli, whatever was set before. Elements that are not active are left out. History stays; an
  /// element that changes its Gauss points spreads it or takes the mean.
  void set_stiffness(const std::vector<ElementStiffness> &stiffness);

  /// From now on the shear stiffness relaxes as the material says, from no history, and
  /// compute_internal_forces() must be called once per time step of that length [s]: it moves the
  /// history on. Hourglass stiffness stays elastic with the instantaneous modulus: it stands for
  /// bending within an element, whose waves last a few steps, and a softer one would let go of the
  /// modes that it has to hold. Throws InputError for an impossible series. History is kept in
  /// double precision.
  void start_relaxation(double dt) override;
  bool relaxes() const override { return !branches_.empty(); }
  /// E_b,k, the strain that the dashpots of a branch have taken over; mean of the Gauss points [-].
  Eigen::Matrix3d back_strain(int element, int branch) const;
  /// What bonds take over from an element before the next step, see BondViscosity::take_over().
  Eigen::Matrix3d history(int element, int branch) const;
  /// Sets E_b,k at all Gauss points of an element, for bodies that take over from others; as of the
  /// last step.
  void set_back_strain(int element, int branch, const Eigen::Matrix3d &E_b);

  /// Elements for whose centre this is false carry neither force nor mass from now on; all others
  /// do, with the material's moduli until set_stiffness(). Masses are lumped anew. Collective.
  void set_active(const std::function<bool(const Vector3 &)> &active);

  /// The mass of these elements acts as if it sat in the centres of their sub-cubes, so many along
  /// an edge, and not in the corners, to first order: correct_mass() adds M_L^-1 (f - M_C a) to a =
  /// M_L^-1 f. The sum of all forces stays as it is, because the rows of both mass matrices have
  /// the same sums. Collective.
  void set_consistent_mass(const std::vector<int> &elements, int points_per_edge);
  /// Call after velocity() was set from outside: the momentum that belongs to it under the
  /// consistent mass is kept, too. Collective.
  void velocity_changed();

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

  /// Ranks change them by rounding only.
  Energies energies(double dt) const override;
  /// With what dashpots have carried off; likewise.
  Momenta momenta() const override;

  /// Everything at rest in the reference configuration, without forces; ghosts are not touched.
  void rest();
  std::unique_ptr<Vibration> vibration() override;
  std::string first_not_finite() const override;
  /// Lumped mass of all nodes [kg]. Collective.
  double total_mass() const;

  const HexMesh &mesh() const { return mesh_; }
  const FiniteElementMaterial &material() const { return material_; }
  const HexKernel &kernel() const { return *kernel_; }
  // Three numbers per local node, see HexMesh.
  std::vector<double> &position() { return position_; } // [m]
  const std::vector<double> &position() const { return position_; }
  std::vector<double> &velocity() { return velocity_; } // at the half step [m/s]
  const std::vector<double> &velocity() const { return velocity_; }
  std::vector<double> &force() { return force_; } // [N]
  const std::vector<double> &force() const { return force_; }
  /// Of an owned node; zero for hanging nodes and where no active element is [kg].
  double mass(const int node) const { return mass_[node]; }
  /// 1/m; zero where a component is not integrated [1/kg].
  double inverse_mass(const int node, const int component) const
  {
    return inverse_mass_[3 * node + component];
  }

  /// f M_eff^-1 f over this rank's nodes, after correct_mass() [N^2/kg].
  double squared_force() const;

  bool is_active(const int element) const { return place_[element].group >= 0; }
  /// At the last compute_internal_forces() with energies; zero if not active [J].
  double strain_energy(int element) const;
  double hourglass_energy(int element) const;
  /// F in the middle of an element [-].
  Eigen::Matrix3d deformation_gradient(int element) const;
  /// Second Piola-Kirchhoff stress at the deformation of the middle, by the mean of the Gauss
  /// points' tensors; zero if not active [Pa].
  Eigen::Matrix3d stress(int element) const;

private:
  struct Group
  {
    std::vector<int> elements;
    std::vector<HexBlock> blocks;
    std::vector<HexTensors> tensors;
    std::vector<HexTensors> shear;
    std::vector<double> strain_energy, hourglass_energy; // per entry of elements
    int n_points;                                        // Gauss points
    std::vector<double> history, dissipated;             // see HexRelaxation
  };
  struct Place
  {
    int group, index; // group -1: not active
  };

  struct Dashpot
  {
    int entry;          // component of an owned node
    double coefficient; // [kg/s]
  };
  /// Of a dashpot's node, with half the dashpot's force at either end of the step [N].
  double damped_force(const Dashpot &dashpot, double dt) const;

  void lump_mass();
  void add_mass_difference(const std::vector<double> &acceleration,
                           std::vector<double> &force) const;
  void find_spread_momentum();
  void fill(Group &group) const;
  HexGroup view(const Group &group) const;
  std::size_t row(const Group &group, int index, int point, int branch) const;
  /// Per element: 2 E and 2 (E - E_b,k) of every Gauss point, and what it has dissipated.
  struct Memory
  {
    std::vector<std::vector<double>> points;
    double dissipated = 0.;
  };
  std::vector<Memory> memories() const;
  void restore(const std::vector<Memory> &memories);

  MPI_Comm communicator_;
  HexMesh mesh_;
  FiniteElementMaterial material_;
  Options options_;
  const HexKernel *kernel_;
  std::array<Group, 2> groups_;       // shared moduli, own tensors
  std::vector<Place> place_;          // of each element
  std::vector<MaxwellStep> branches_; // none: elastic
  std::vector<Memory> past_;          // of elements that may get their tensors back
  double dissipated_elsewhere_ = 0.;  // by elements that are not active any more [J]
  std::vector<char> active_;
  std::vector<double> position_, velocity_, force_;
  std::vector<Dashpot> dashpots_;
  double absorbed_ = 0.;          // by them, up to the step before [J]
  Momenta carried_off_;           // by them, at this rank's nodes
  bool spreads_mass_   = false;   // the same on all ranks
  double spread_share_ = 0.;      // of an edge's mass that an end has of itself [-]
  std::vector<int> spread_;       // elements of consistent mass
  std::vector<int> spread_nodes_; // owned nodes among their corners
  // Per component of spread_nodes_: the force before its correction [N], and M_eff v, where
  // M_eff^-1 is the corrected inverse: what the forces have added up to [kg m/s].
  std::vector<double> spread_force_, spread_momentum_;
  std::vector<double> acceleration_; // workspace
  std::vector<double> mass_;         // per owned node
  std::vector<double> inverse_mass_; // per component of owned nodes
  std::vector<int> fixed_;           // entries of inverse_mass_ that fix() has made zero
};
} // namespace ricochet
