// SPDX-License-Identifier: LGPL-2.1-or-later
// Copies of the points that this rank's points may touch, as they are now, on whichever rank they
// live.
#pragma once

#include "candidate_search.h"

#include <unordered_map>

namespace ricochet
{
class ContactGhosts
{
public:
  /// Where a ghost's numbers come from.
  struct Source
  {
    std::int32_t flat; // index in the body's lattice; < 0: a point of another rank
    std::int16_t body;
    bool image; // across y = 0
  };
  struct Ghost
  {
    double position[3]; // [m]
    double open;        // 0 or 1
    double velocity[3]; // half a step ago [m/s]
  };

  /// The bodies and their numbering must outlive this object.
  ContactGhosts(MPI_Comm communicator, const Bodies &bodies, const ContactNumbering &numbering);

  void clear();
  /// Number of a point's ghost, a new one if need be.
  std::int32_t number_of(const ContactPoint &point);
  /// Numbers the ghosts in the order of their ids; returns the new number of each old one.
  std::vector<std::int32_t> sort();
  /// Tells the other ranks of which of their points this one has ghosts. Collective.
  void set_up_exchange();
  /// Brings the ghosts up to date. Collective.
  void update();

  const Ghost &operator[](const std::int32_t number) const { return ghosts_[number]; }
  const Source &source(const std::int32_t number) const { return sources_[number]; }
  /// In ContactNumbering.
  std::int64_t id(const std::int32_t number) const { return points_[number].id; }

private:
  Ghost ghost_of(const Source &source) const;

  MPI_Comm communicator_;
  int rank_, n_ranks_;
  const Bodies &bodies_;
  const ContactNumbering &numbering_;
  std::vector<ContactPoint> points_;                       // as they were when found
  std::unordered_map<std::int64_t, std::int32_t> numbers_; // by id
  std::vector<Ghost> ghosts_;
  std::vector<Source> sources_;                     // of ghosts_
  std::vector<std::vector<std::int32_t>> received_; // numbers of ghosts, per rank they come from
  std::vector<std::vector<Source>> sent_;           // this rank's points, per rank they go to
};
} // namespace ricochet
