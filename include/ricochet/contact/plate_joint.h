// SPDX-License-Identifier: LGPL-2.1-or-later
// Two plates that lie on each other and are joined, by something that may be weaker than they are:
// glue, a cold weld, the matrix between plies.
//
// It is a layer one spacing dx thick, half of either material: P wave modulus M and shear modulus
// mu are the harmonic means of both sides'. A site is a point of the upper plate's lowest layer
// and what is below it: springs to the point opposite and to that one's four neighbours, of
// stiffness
//   k_diagonal = mu dx,   k_opposite = M dx - n_diagonal k_diagonal / 2
// so that an opening w takes the tension M w/dx at every site, and a sliding the shear stress mu
// w/dx where no edge is near. Forces are central, hence energy does not know rotations, and both
// momenta are kept. With the sum of a site's spring forces on dx^2, split into tension t along the
// way to the point opposite and shear s across it, the site breaks, for ever and in one, as soon as
//   (max(t, 0)/tension)^2 + (s/shear)^2 >= 1
// the quadratic criterion of delamination (Brewer and Lagace 1988). What its springs hold is
// released, as the time step's own form k e_n e_(n-1)/2: under tension about tension^2 dx/(2 M) for
// each area. What has come apart may touch again, by
// ShortRangeContact.
#pragma once

#include "ricochet/bodies/interaction.h"
#include "ricochet/peridynamics/peridynamic_body.h"

#include <vector>

namespace ricochet
{
class PlateJoint : public Interaction
{
public:
  /// At which it breaks, above 0.
  struct Strength
  {
    double tension; // [Pa]
    double shear;   // [Pa]
  };

  /// Both bodies must outlive this object, be peridynamic throughout, have the same spacing and
  /// numbers of points along x and y, and lie on each other; throws InputError otherwise.
  PlateJoint(MPI_Comm communicator, PeridynamicBody &above, PeridynamicBody &below,
             const Strength &strength);

  /// Breaks sites, too.
  void add_forces(double dt) override;
  void record_work(double) override {}
  void exchange_state(StateArchive &archive) override;
  double energy() const override { return whole(stored_); }
  double friction_work() const override { return 0.; }

  /// By what has broken so far, both halves [J]. Collective.
  double released_energy() const { return whole(released_); }
  /// Of all sites [-]. Collective.
  double broken_share() const;
  /// Upper bound of the squared frequency that this adds to a point of one of the two [1/s^2].
  double squared_frequency(const PeridynamicBody &body) const;

private:
  struct Spring
  {
    std::ptrdiff_t below; // flat index in the lower body
    double stiffness;     // [N/m]
    double length;        // at rest [m]
  };
  struct Site
  {
    std::ptrdiff_t above;    // flat index in the upper body
    std::size_t first, last; // of its springs, that to the point opposite first
    bool broken = false;
  };

  void check() const;
  void find_sites();
  void add_site(const std::array<int, 3> &coordinates);
  /// Whether the tensions of its springs are too much for a site.
  bool fails(const Site &site) const;
  /// A site that holds so far, after a step dt long [s].
  void act(Site &site, double dt);
  /// Half of a spring's energy for each of its ends that this rank owns.
  void book(const Site &site, const Spring &spring, double energy, PlaneSums<1> &sums) const;
  double whole(const PlaneSums<1> &sums) const;

  /// Of a spring of the site.
  Vector3 apart(const Site &site, const Spring &spring) const;

  MPI_Comm communicator_;
  PeridynamicBody &above_, &below_;
  Strength strength_;
  double modulus_, shear_modulus_; // of the layer: M, mu [Pa]
  std::vector<Spring> springs_;
  std::vector<Site> sites_;        // all with an end that this rank owns, in the order of x, y
  PlaneSums<1> stored_, released_; // by the plane of the end [J]
};
} // namespace ricochet
