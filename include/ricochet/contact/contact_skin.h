// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the points of all bodies were when they were last searched, and how far they may get before
// they must be searched again: each point has a reach of its own, as far as its speed suggests. So
// fast fragments do not make the others' lists long or short-lived.
#pragma once

#include "ricochet/contact/contact_search.h"

namespace ricochet
{
class ContactSkin
{
public:
  /// The bodies and their numbering must outlive this object. `mirrored`: y = 0 is a symmetry
  /// plane. `spacing`: the largest of all bodies; `range`: the largest distance at which two points
  /// touch [m].
  ContactSkin(MPI_Comm communicator, const Bodies &bodies, const ContactNumbering &numbering,
              bool mirrored, double spacing, double range);

  /// All points start from where they are. `dt`: the coming step [s]. Collective.
  void begin(double dt);
  /// Points of this rank that have left their reach, or broken a bond though they were not active.
  /// They get a new reach and are active from now on.
  std::vector<ContactPoint> strays(double dt);

  /// The reach of each point of a body's lattice [m]; of ghosts and images as of the last begin().
  const std::vector<double> &reach(const std::size_t body) const { return journeys_[body].reach; }

  /// This rank's points that are active or may come near an active one of any rank, and their
  /// images. Collective.
  ContactCandidates candidates() const;
  /// The points of this rank that may touch a point before either leaves its reach, without the
  /// point itself.
  std::vector<ContactPoint> points_near(const ContactPoint &point) const;
  /// The image of a point, or the point of an image.
  ContactPoint image_of(ContactPoint point) const;

private:
  struct Box
  {
    double low[3], high[3]; // [m]
  };
  /// Of a body's points, per entry of its lattice's fields. Active are those all of whose pairs are
  /// known; of the others only those with active points.
  struct Journey
  {
    std::vector<double> start[3]; // [m]; NaN where there is no point of this rank
    std::vector<double> reach;    // [m]
    std::vector<char> active;
    std::vector<Box> boxes;               // of `chunk` entries each: the points in them stay inside
    std::vector<std::ptrdiff_t> occupied; // first entries of the chunks with any point
  };

  double reach_of(std::size_t body, std::ptrdiff_t p, double dt) const;
  void start(std::size_t body, std::ptrdiff_t p);
  void mark_active_near_damage(std::size_t body);
  void mark_active_near_other_bodies();
  void mark_active_in_box(std::size_t body, const double *corner);
  void add_own_points(ContactCandidates &candidates) const;
  void add_images(ContactCandidates &candidates) const;
  ContactPoint contact_point(std::size_t body, std::ptrdiff_t p) const;

  MPI_Comm communicator_;
  int rank_;
  const Bodies &bodies_;
  const ContactNumbering &numbering_;
  bool mirrored_;
  double spacing_, range_;
  std::vector<Journey> journeys_; // per body
};
} // namespace ricochet
