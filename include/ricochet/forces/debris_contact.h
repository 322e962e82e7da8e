// SPDX-License-Identifier: LGPL-2.1-or-later
// Short-range repulsion of points that no bond connects (Macek and Silling 2007): debris does not
// interpenetrate, and bodies touch. Per pair
//   f = k (d - r) for r < d,   d = min(0.9 |X_j - X_i|, 1.35 dx),   k = factor 18 K V^2 / (pi
//   delta^5)
// Two kinds of pairs: those whose bond is broken are known from the lattice, from the moment of
// breaking; all others (foreign points) are found by a cell search among damaged and surface
// points, refreshed before any point can have crossed the skin.
#pragma once

#include "ricochet/discretization/plane_sums.h"
#include "ricochet/forces/peridynamic_force.h"

#include <memory>

namespace ricochet
{
class DebrisContact
{
public:
  /// `factor` 0 switches the contact off. The bodies must outlive this object. `mirrored`: y = 0 is
  /// a symmetry plane.
  DebrisContact(MPI_Comm communicator, const std::vector<std::unique_ptr<PeridynamicForce>> &bodies,
                double factor, bool mirrored);
  ~DebrisContact();

  /// Adds repulsion to the bodies' forces. `dt`: the coming step [s], which tells when the pairs
  /// must be searched again. Collective.
  void evaluate(double dt);

  /// Energy stored in the repulsion, both halves [J]. Collective.
  double energy() const;

  /// Upper bound of the squared frequency which this contact adds to a point of the body [1/s^2].
  double squared_frequency(const PeridynamicForce &body) const;

private:
  struct Cloud; // the points which take part in the search

  /// A pair of former neighbours: flat indices of one body.
  struct BondPair
  {
    std::int32_t p, q;
    double distance; // d [m]
  };
  struct ForeignPair
  {
    std::int32_t a, b; // numbers in the cloud
    double distance;   // [m]
    double stiffness;  // [N/m]
  };

  double contact_distance(double reference_distance, double spacing) const; // d [m]
  void refresh();
  void append_broken();
  void update_cloud();
  void search();
  template <class Visitor>
  void for_each_contact(Visitor &&visit) const;

  MPI_Comm communicator_;
  const std::vector<std::unique_ptr<PeridynamicForce>> &bodies_;
  double factor_;
  std::vector<double> stiffness_; // k of each body [N/m]
  bool mirrored_;
  double skin_;           // [m]
  double travelled_ = 0.; // since the last search, of the fastest pair [m]
  bool searched_    = false;
  std::vector<std::vector<BondPair>> bond_pairs_; // per body
  std::vector<ForeignPair> foreign_pairs_;
  std::unique_ptr<Cloud> cloud_;
};
} // namespace ricochet
