// SPDX-License-Identifier: LGPL-2.1-or-later
// A free elastic body of peridynamic points that do not break, with general hexahedra instead of
// them behind a plane across its axis, or without. For projectiles: small, in the reference
// configuration a body of revolution about x, computed whole wherever it is asked for.
//
// Where points end, two cells of the lattice (pad and halo, peridynamics/zone.h) overlap the
// elements: these points follow the nodes, x_p = sum N_a x_a with N_a the mean of the shape
// functions over the point's cube, which may be larger than an element, and hand their forces on by
// the transpose. The elements there keep a share s_e of their strain energy, found by least squares
// such that under an axial pull the forces on the nodes are those of the body of elements alone.
// One potential energy stands behind all of it: momenta and energy are conserved.
//
// A body this slim is all surface, and points at a surface lack neighbours: without a remedy the
// body would be softer than its material says and reflect waves. Therefore the energy of a point
// counts as often as it takes for a pull along the axis (with the contraction of a bar)
// to store in every point what it stores in the bulk: a surface correction by energies, compare Le
// and Bobaru 2018 (Computational Mechanics 61, 499-518).
#pragma once

#include "ricochet/finite_elements/hexahedral_body.h"
#include "ricochet/geometry/body_of_revolution.h"
#include "ricochet/peridynamics/peridynamic_body.h"

#include <memory>

namespace ricochet
{
class CoupledProjectileBody : public Body
{
public:
  /// What the body is made of.
  struct Parameters
  {
    double spacing; // of the points, dx [m]
    double mass;    // of all that is computed [kg]
    const BondLaw *law;
    double bulk_modulus, shear_modulus; // [Pa]
    bool mirrored;                      // the half y > 0 of a body symmetric about y = 0
    /// Cells of the mesh whose centre is farther than this from the tip are elements [m]; infinite:
    /// all is points.
    double points_length;
    bool correct_surface        = true; // false to see what it does
    double horizon_ratio        = 3.;   // of the points, delta/dx [-]
    InfluenceFunction influence = InfluenceFunction::cone;
  };

  /// What has mass: a free point or a node. Pointers to its three numbers each.
  struct MassPoint
  {
    Vector3 reference; // [m]
    double mass;       // [kg]
    Vector3 mobility;  // 1/mass, 0 for a component that is held [1/kg]
    std::array<double *, 3> position, velocity, force;
  };

  /// A point of the lattice as a weighted mean of mass points: itself, or the nodes it follows.
  struct Point
  {
    Vector3 reference; // [m]
    std::vector<std::pair<int, double>> follows;
  };

  /// Where points follow elements.
  struct Overlap
  {
    double length  = 0.; // of pad and halo along the axis [m]
    int n_elements = 0;  // with a share
    double ghost   = 0.; // largest force left at a node there under a pull, in units of E e h^2 [-]
  };

  /// At rest in the reference configuration. `mesh` of the same shape, its half if mirrored. Throws
  /// InputError if the spacing is too coarse, the elements leave no room for the overlap, or a
  /// point in the overlap lies far from all of them.
  CoupledProjectileBody(const BodyOfRevolution &shape, const HexSolid &mesh,
                        const Parameters &parameters);
  ~CoupledProjectileBody() override;
  CoupledProjectileBody(const CoupledProjectileBody &)            = delete;
  CoupledProjectileBody &operator=(const CoupledProjectileBody &) = delete;

  /// Points that follow nodes take their places; call after a change of the motion that is not
  /// advance()'s.
  void interpolate_to_slaved_points();
  /// Everything at rest in the reference configuration, without forces.
  void rest();

  double multiplicity() const override { return peridynamic_->multiplicity(); }
  void update_ghosts() override { peridynamic_->update_ghosts(); }
  void compute_internal_forces(const ForceRequest &request) override;
  void advance(double kick, double drift) override;
  /// Strain energy with that of hourglass modes.
  Energies energies(double dt) const override;
  Momenta momenta() const override;
  std::unique_ptr<Vibration> vibration() override;
  void exchange_state(StateArchive &archive) override;
  std::string first_not_finite() const override;

  const std::vector<MassPoint> &mass_points() const { return mass_points_; } // points, then nodes
  const std::vector<Point> &points() const
  {
    return points_;
  } // all of the lattice, slaved ones too
  /// The mass point that is this node of the mesh; -1 if no element has it.
  int mass_point_of(const int node) const { return node_[node]; }
  /// Behind the points; 0 if all is points.
  int n_elements() const
  {
    return elements_ ? static_cast<int>(elements_->solid().cells.size()) : 0;
  }
  double spacing() const { return peridynamic_->lattice().box().spacing; } // [m]
  double mass() const { return mass_; }                                    // [kg]
  /// Axial position where elements end and free points begin; the base without elements [m].
  double interface() const { return interface_; }
  const Overlap &overlap() const { return overlap_; } // how well points and elements fit
  const HexahedralBody *elements() const { return elements_.get(); } // null if there are none

private:
  /// Of the mesh: what stays elements.
  struct Division
  {
    HexSolid elements;
    double volume = 0., volume_of_points = 0.; // of all and of what becomes points [m^3]
  };

  Division divide(const HexSolid &mesh, const BodyOfRevolution &shape,
                  const Parameters &parameters);
  /// `behind`: layers of cells behind the interface.
  Lattice::Box lattice_box(const BodyOfRevolution &shape, const Parameters &parameters, int behind);
  void place_points(const BodyOfRevolution &shape, const Parameters &parameters, double volume);
  void distribute_slaved_forces();
  void list_points();
  void make_elements(const HexSolid &mesh, const Division &division, const Parameters &parameters);
  std::vector<char> find_slaved_points(const Division &division, const Parameters &parameters);
  static void strain(PeridynamicBody &points);
  void correct_surface(PeridynamicBody &&whole);
  std::vector<double> shares_of(const HexSolid &mesh, const HexSolid &elements,
                                const std::vector<char> &overlaps, const Parameters &parameters);

  double mass_, interface_;
  std::unique_ptr<Zone> zone_;
  std::unique_ptr<PeridynamicBody> peridynamic_;
  std::unique_ptr<HexahedralBody> elements_;
  std::vector<MassPoint> mass_points_;
  std::vector<Point> points_;
  std::vector<int> node_, slaved_;    // mass points of the mesh's nodes; points that follow nodes
  std::vector<std::ptrdiff_t> index_; // of points_ in the lattice
  Overlap overlap_;
  double stored_ = 0.; // at the last compute_internal_forces() with energies [J]
};
} // namespace ricochet
