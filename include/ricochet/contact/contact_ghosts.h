// SPDX-License-Identifier: LGPL-2.1-or-later
// The points that this rank's points may touch, as they are now, on whichever rank they live.
#pragma once

#include "ricochet/contact/contact_search.h"

#include <unordered_map>

namespace ricochet
{
class ContactGhosts
{
public:
  /// Where a point's numbers come from.
  struct Follower
  {
    std::int32_t flat; // index in the body's lattice; < 0: a point of another rank
    std::int16_t body;
    bool image; // across y = 0
  };
  struct Watched
  {
    double position[3]; // [m]
    double damaged;     // 0 or 1
    double velocity[3]; // half a step ago [m/s]
  };

  /// The bodies and their numbering must outlive this object.
  ContactGhosts(MPI_Comm communicator, const Bodies &bodies, const ContactNumbering &numbering);

  void clear();
  /// Number of a point, a new one if need be.
  std::int32_t number_of(const ContactPoint &point);
  /// Numbers the points in the order of their ids; returns the new number of each old one.
  std::vector<std::int32_t> sort();
  /// Tells the other ranks which of their points are watched. Collective.
  void watch();
  /// Brings the points up to date. Collective.
  void update();

  const Watched &operator[](const std::int32_t number) const { return watched_[number]; }
  const Follower &follower(const std::int32_t number) const { return followers_[number]; }
  /// In ContactNumbering.
  std::int64_t id(const std::int32_t number) const { return points_[number].id; }

private:
  Watched look_at(const Follower &follower) const;

  MPI_Comm communicator_;
  int rank_, n_ranks_;
  const Bodies &bodies_;
  const ContactNumbering &numbering_;
  std::vector<ContactPoint> points_;                       // as they were when found
  std::unordered_map<std::int64_t, std::int32_t> numbers_; // by id
  std::vector<Watched> watched_;
  std::vector<Follower> followers_;                   // what watched_ follows
  std::vector<std::vector<std::int32_t>> watched_of_; // other ranks' points, per rank
  std::vector<std::vector<Follower>> watched_by_;     // this rank's points, per rank
};
} // namespace ricochet
