// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds the points of all bodies that may touch before either leaves its skin, on all ranks and
// across the symmetry plane.
#pragma once

#include "contact_numbering.h"

#include <memory>
#include <mpi.h>
#include <string>

namespace ricochet
{
/// A point or an image of one, as the search sees it.
struct ContactPoint
{
  double position[3]; // [m]
  double skin;        // how far it may get before the next search [m]
  std::int64_t id;    // in ContactNumbering
  std::int32_t rank;
  std::int32_t flat;   // of the point or its original, in its body's lattice on that rank
  std::int32_t number; // among the candidates of that rank
  bool open, image;
  bool active; // pairs of two points that are not are of no interest
};

inline Vector3 position_of(const ContactPoint &point)
{
  return {point.position[0], point.position[1], point.position[2]};
}

struct ContactCandidates
{
  std::vector<ContactPoint> points; // this rank's, their images, then those of other ranks
  std::size_t n_own = 0, n_local = 0;
  // Pairs with at least one point of this rank: all that have never been neighbours and whose
  // distance is less than the range plus both skins, and more.
  std::vector<PointPair> pairs;
};

class CandidateSearch
{
public:
  struct Parameters
  {
    MPI_Comm communicator;
    double spacing;                    // the largest of all bodies [m]
    double range;                      // the largest distance at which two points touch [m]
    const ContactNumbering *numbering; // outlives the search
  };

  explicit CandidateSearch(const Parameters &parameters) : parameters_(parameters) {}
  virtual ~CandidateSearch() = default;

  /// Given this rank's points and images, adds those of other ranks and the pairs. Collective.
  virtual void find(ContactCandidates &candidates) = 0;

protected:
  Parameters parameters_;
};

/// The method of that name, one of contact_search_names(). Throws InputError for an unknown one.
std::unique_ptr<CandidateSearch> make_candidate_search(const std::string &name,
                                                       const CandidateSearch::Parameters &);
} // namespace ricochet
