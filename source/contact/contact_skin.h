// SPDX-License-Identifier: LGPL-2.1-or-later
// The skins of all bodies' points (body_skin.h), and what the search gets to see of them.
#pragma once

#include "body_skin.h"
#include "candidate_search.h"

namespace ricochet
{
class CoarseCells;

class ContactSkin
{
public:
  /// The bodies and their numbering must outlive this object. `mirrored`: y = 0 is a symmetry
  /// plane. `spacing`: the largest of all bodies; `range`: the largest distance at which two points
  /// touch [m].
  ContactSkin(MPI_Comm communicator, const Bodies &bodies, const ContactNumbering &numbering,
              bool mirrored, double spacing, double range);

  /// All points start from where they are. `dt`: the coming step [s]. Collective.
  void reset(double dt);
  /// Points of this rank that have left their skin, or broken a bond though they were not active.
  /// They get a new skin and are active from now on.
  std::vector<ContactPoint> points_out_of_skin(double dt);

  /// The skin of each point of a body's lattice [m]; of ghosts and images as of the last reset().
  const std::vector<double> &thickness(const std::size_t body) const
  {
    return skins_[body].thickness();
  }

  /// This rank's points that are active or may come near an active one of any rank, and their
  /// images. Collective.
  ContactCandidates candidates() const;
  /// The points of this rank that may touch a point before either leaves its skin, without the
  /// point itself.
  std::vector<ContactPoint> points_near(const ContactPoint &point) const;
  /// The image of a point, or the point of an image.
  ContactPoint image_of(ContactPoint point) const;

private:
  void mark_active_near_other_bodies();
  CoarseCells cells_near_active_points() const;
  void add_own_points(ContactCandidates &candidates) const;
  void add_images(ContactCandidates &candidates) const;
  ContactPoint contact_point(std::size_t body, std::ptrdiff_t p) const;

  MPI_Comm communicator_;
  int rank_;
  const Bodies &bodies_;
  const ContactNumbering &numbering_;
  bool mirrored_;
  double spacing_, range_;
  std::vector<BodySkin> skins_; // per body
};
} // namespace ricochet
