// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_skin.h"

#include "ricochet/search/coarse_cells.h"
#include "search_levels.h"

#include <limits>
#include <tuple>

namespace ricochet
{
ContactSkin::ContactSkin(const MPI_Comm communicator, const Bodies &bodies,
                         const ContactNumbering &numbering, const bool mirrored,
                         const double spacing, const double range) :
  communicator_(communicator),
  bodies_(bodies), numbering_(numbering), mirrored_(mirrored), spacing_(spacing), range_(range)
{
  MPI_Comm_rank(communicator, &rank_);
  for (const auto &body : bodies)
    skins_.emplace_back(*body, spacing);
}

void ContactSkin::reset(const double dt)
{
  for (auto &skin : skins_)
    skin.reset(dt);
  if (bodies_.size() > 1)
    mark_active_near_other_bodies();
}

std::vector<ContactPoint> ContactSkin::points_out_of_skin(const double dt)
{
  std::vector<ContactPoint> found;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const Lattice &l = bodies_[i]->lattice();
    auto &skin       = skins_[i];
    const auto renew = [&](const std::ptrdiff_t p)
    {
      skin.renew(p, dt);
      found.push_back(contact_point(i, p));
    };
    skin.for_each_outside(renew);
    bodies_[i]->for_each_newly_broken_bond(
        [&](const std::ptrdiff_t p, const std::ptrdiff_t q, std::size_t)
        {
          for (const std::ptrdiff_t end : {p, q})
            if (end < l.owned_end() && l.owned(end) && !skin.is_active(end))
              renew(end);
        });
  }
  return found;
}

void ContactSkin::mark_active_near_other_bodies()
{
  // The lower corner of the box in which each body stays, and minus the upper one.
  std::vector<double> corners;
  for (const auto &skin : skins_)
  {
    const auto box = skin.bounding_box();
    corners.insert(corners.end(), box.low, box.low + 3);
    for (const double high : box.high)
      corners.push_back(-high);
  }
  MPI_Allreduce(MPI_IN_PLACE, corners.data(), static_cast<int>(corners.size()), MPI_DOUBLE, MPI_MIN,
                communicator_);
  for (std::size_t j = 0; j < skins_.size(); ++j)
  {
    const double *const corner = corners.data() + 6 * j;
    BodySkin::Box box{{corner[0], corner[1], corner[2]}, {-corner[3], -corner[4], -corner[5]}};
    if (mirrored_)
      std::tie(box.low[1], box.high[1]) =
          std::make_tuple(std::min(box.low[1], -box.high[1]), std::max(box.high[1], -box.low[1]));
    for (std::size_t i = 0; i < skins_.size(); ++i)
      if (i != j)
        skins_[i].mark_active_near(box, range_);
  }
}

ContactCandidates ContactSkin::candidates() const
{
  ContactCandidates candidates;
  add_own_points(candidates);
  if (mirrored_)
    add_images(candidates);
  candidates.n_local = candidates.points.size();
  return candidates;
}

/// Cells in which a point may come near an active one of any rank. Collective.
CoarseCells ContactSkin::cells_near_active_points() const
{
  CoarseCells cells(coarse_cell * spacing_);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    bodies_[i]->lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto &skin = skins_[i];
          if (!skin.is_active(p))
            return;
          const double margin = range_ + skin.thickness()[p];
          Vector3 x           = skin.start(p);
          cells.mark(x, margin);
          x.y() *= -1.;
          if (mirrored_)
            cells.mark(x, margin);
        });
  cells.join(communicator_);
  return cells;
}

void ContactSkin::add_own_points(ContactCandidates &candidates) const
{
  CoarseCells cells = cells_near_active_points();
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &skin  = skins_[i];
    const auto &boxes = skin.boxes();
    std::vector<char> worth_a_look(boxes.size());
    for (std::size_t c = 0; c < boxes.size(); ++c)
      worth_a_look[c] = cells.any_marked(boxes[c].low, boxes[c].high);
    bodies_[i]->lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (!worth_a_look[p / BodySkin::chunk])
            return;
          if (!skin.is_active(p))
          {
            const Vector3 x = skin.start(p);
            double low[3], high[3];
            for (int d = 0; d < 3; ++d)
            {
              low[d]  = x[d] - skin.thickness()[p];
              high[d] = x[d] + skin.thickness()[p];
            }
            if (!cells.any_marked(low, high))
              return;
          }
          candidates.points.push_back(contact_point(i, p));
          candidates.points.back().number = static_cast<std::int32_t>(candidates.points.size() - 1);
        });
  }
  candidates.n_own = candidates.points.size();
}

/// Images of those points that may touch a point of any rank.
void ContactSkin::add_images(ContactCandidates &candidates) const
{
  // Debris that has crossed the plane, y < 0, meets images of points far away from it.
  double lowest = std::numeric_limits<double>::max();
  for (const auto &point : candidates.points)
    lowest = std::min(lowest, point.position[1] - point.skin);
  MPI_Allreduce(MPI_IN_PLACE, &lowest, 1, MPI_DOUBLE, MPI_MIN, communicator_);
  for (std::size_t i = 0; i < candidates.n_own; ++i)
    if (lowest + candidates.points[i].position[1] - candidates.points[i].skin < range_)
    {
      candidates.points.push_back(image_of(candidates.points[i]));
      candidates.points.back().number = static_cast<std::int32_t>(candidates.points.size() - 1);
    }
}

std::vector<ContactPoint> ContactSkin::points_near(const ContactPoint &point) const
{
  std::vector<ContactPoint> found;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    skins_[i].for_each_near(point.position, range_ + point.skin,
                            [&](const std::ptrdiff_t p)
                            {
                              if (!point.active && !skins_[i].is_active(p))
                                return;
                              const auto partner = contact_point(i, p);
                              if (partner.id != point.id)
                                found.push_back(partner);
                            });
  return found;
}

ContactPoint ContactSkin::contact_point(const std::size_t body, const std::ptrdiff_t p) const
{
  const auto &skin = skins_[body];
  const Vector3 x  = skin.start(p);
  return {{x[0], x[1], x[2]},
          skin.thickness()[p],
          numbering_.id(static_cast<int>(body), bodies_[body]->lattice().coordinates(p)),
          rank_,
          static_cast<std::int32_t>(p),
          -1,
          bodies_[body]->is_open(p),
          false,
          skin.is_active(p)};
}

ContactPoint ContactSkin::image_of(ContactPoint point) const
{
  auto place       = numbering_.place(point.id);
  place.lattice[1] = -1 - place.lattice[1];
  point.id         = numbering_.id(place.body, place.lattice);
  point.position[1] *= -1.;
  point.image = !point.image;
  return point;
}
} // namespace ricochet
