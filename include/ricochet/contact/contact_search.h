// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds the points of all bodies that may touch before they have travelled a given way, on all
// ranks and across the symmetry plane.
#pragma once

#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/search/families.h"

#include <memory>
#include <string>
#include <vector>

namespace ricochet
{
using Bodies = std::vector<PeridynamicBody *>;

/// Numbers the points of all bodies and their mirror images, the same on all ranks, in the order
/// body, x, z, y. The difference of two numbers tells whether they have been neighbours.
class ContactNumbering
{
public:
  struct Place
  {
    int body;
    std::array<int, 3> lattice; // x, y, z; y negative for an image
  };

  explicit ContactNumbering(const Bodies &bodies);

  std::int64_t id(int body, const std::array<int, 3> &lattice) const;
  Place place(std::int64_t id) const;
  /// Families of neighbours: of all of them, or some if the bodies differ in their horizon.
  Families families(const std::vector<std::int64_t> &ids) const;
  /// Number in the stencil of the offset from the point with the lower id to the other one; -1 if
  /// they have never been neighbours.
  int offset(const std::int64_t lower, const std::int64_t higher) const
  {
    const auto &numbers           = bodies_[lower >> body_bits].offsets;
    const std::int64_t difference = higher - lower;
    return difference < std::int64_t(numbers.size()) ? numbers[difference] : -1;
  }

private:
  static constexpr int body_bits = 48;

  struct Body
  {
    std::int64_t n_y, n_z;             // numbers for a row, rows for a plane
    int first_y;                       // of the images
    std::vector<std::int16_t> offsets; // per difference of two numbers
  };
  std::vector<Body> bodies_;
  std::vector<int> first_place_; // of each body, along x
  int squared_range_;            // the smallest of all bodies
};

/// A point or an image of one, as the search sees it.
struct ContactPoint
{
  double position[3]; // [m]
  double reach;       // how far it may get before the next search [m]
  std::int64_t id;    // in ContactNumbering
  std::int32_t rank;
  std::int32_t flat;   // of the point or its original, in its body's lattice on that rank
  std::int32_t number; // among the candidates of that rank
  bool damaged, image;
  bool active; // pairs of two points that are not are of no interest
};

struct ContactCandidates
{
  std::vector<ContactPoint> points; // this rank's, their images, then those of other ranks
  std::size_t n_own = 0, n_local = 0;
  // Pairs with at least one point of this rank: all that have never been neighbours and whose
  // distance is less than the range plus both reaches, and more.
  std::vector<PointPair> pairs;
};

class ContactSearch
{
public:
  struct Parameters
  {
    MPI_Comm communicator;
    double spacing;                    // the largest of all bodies [m]
    double range;                      // the largest distance at which two points touch [m]
    const ContactNumbering *numbering; // outlives the search
  };

  static constexpr double largest_reach = 2.25; // of a point [spacings]

  explicit ContactSearch(const Parameters &parameters) : parameters_(parameters) {}
  virtual ~ContactSearch() = default;

  /// Given this rank's points and images, adds those of other ranks and the pairs. Collective.
  virtual void find(ContactCandidates &candidates) = 0;

protected:
  Parameters parameters_;
};

/// Names of the methods: those of search/pair_search.h, used by each rank on its own points and
/// what comes near them, and "hybrid", see search/hybrid_search.h. The fastest first.
std::vector<std::string> contact_search_names();

/// The method of that name. Throws InputError for an unknown one.
std::unique_ptr<ContactSearch> make_contact_search(const std::string &name,
                                                   const ContactSearch::Parameters &parameters);
} // namespace ricochet
