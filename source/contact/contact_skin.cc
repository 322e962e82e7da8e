// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/contact_skin.h"

#include "ricochet/search/coarse_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ricochet
{
namespace
{
// How far a point may get: so many steps at its present speed, and a little for those that rest.
constexpr double steps_ahead = 12.;
constexpr double least_reach = 0.1; // [spacings]

// So many entries of a field are looked at together.
constexpr std::ptrdiff_t chunk = 8 * Lattice::block_size;

// Sound points so many lattice steps around damage are searched like damaged ones: cracks grow
// there.
constexpr int band = 2;
} // namespace

ContactSkin::ContactSkin(const MPI_Comm communicator, const Bodies &bodies,
                         const ContactNumbering &numbering, const bool mirrored,
                         const double spacing, const double range) :
  communicator_(communicator),
  bodies_(bodies), numbering_(numbering), mirrored_(mirrored), spacing_(spacing), range_(range),
  journeys_(bodies.size())
{
  MPI_Comm_rank(communicator, &rank_);
}

void ContactSkin::begin(const double dt)
{
  constexpr double largest = std::numeric_limits<double>::max();
  const Box nowhere{{largest, largest, largest}, {-largest, -largest, -largest}};
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const Lattice &l       = bodies_[i]->lattice();
    const std::ptrdiff_t n = l.size();
    auto &journey          = journeys_[i];
    // What is not a number is neither near anything nor astray.
    for (auto &start : journey.start)
      start.assign(n, std::numeric_limits<double>::quiet_NaN());
    journey.reach.assign(n, 0.);
    journey.boxes.assign((n + chunk - 1) / chunk, nowhere);
    for (const auto &range : l.existing_ranges())
      for (std::ptrdiff_t p = range.first * Lattice::block_size;
           p < range.last * Lattice::block_size; ++p)
        journey.reach[p] = reach_of(i, p, dt);
    l.for_each_owned([&](const std::ptrdiff_t p) { start(i, p); });
    journey.occupied.clear();
    for (std::size_t c = 0; c < journey.boxes.size(); ++c)
      if (journey.boxes[c].low[0] <= journey.boxes[c].high[0])
        journey.occupied.push_back(static_cast<std::ptrdiff_t>(c) * chunk);
    mark_active_near_damage(i);
  }
  if (bodies_.size() > 1)
    mark_active_near_other_bodies();
}

double ContactSkin::reach_of(const std::size_t body, const std::ptrdiff_t p, const double dt) const
{
  const auto &a = bodies_[body]->state().arrays;
  const Vector3 v(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]);
  return std::min(ContactSearch::largest_reach * spacing_,
                  least_reach * spacing_ + steps_ahead * dt * v.norm());
}

/// A point is here and may get as far as its reach.
void ContactSkin::start(const std::size_t body, const std::ptrdiff_t p)
{
  const auto &a      = bodies_[body]->state().arrays;
  auto &journey      = journeys_[body];
  auto &box          = journey.boxes[p / chunk];
  const double reach = journey.reach[p];
  for (int d = 0; d < 3; ++d)
  {
    const double x      = a.position[d][p];
    journey.start[d][p] = x;
    box.low[d]          = std::min(box.low[d], x - reach);
    box.high[d]         = std::max(box.high[d], x + reach);
  }
}

std::vector<ContactPoint> ContactSkin::strays(const double dt)
{
  std::vector<ContactPoint> found;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &body = *bodies_[i];
    const Lattice &l = body.lattice();
    auto &journey    = journeys_[i];
    const auto renew = [&](const std::ptrdiff_t p)
    {
      journey.reach[p] = reach_of(i, p, dt);
      start(i, p);
      // Also a sound point: it may have come near another body.
      journey.active[p] = 1;
      found.push_back(contact_point(i, p));
    };

    const double *const *const x = body.state().arrays.position;
    const double *start[3], *const reach = journey.reach.data();
    for (int d = 0; d < 3; ++d)
      start[d] = journey.start[d].data();
    const auto has_left = [&](const std::ptrdiff_t p)
    {
      const double dx = x[0][p] - start[0][p], dy = x[1][p] - start[1][p],
                   dz = x[2][p] - start[2][p];
      return dx * dx + dy * dy + dz * dz > reach[p] * reach[p];
    };
    // Counted first: this runs over all points at every step, and a sum needs no branches.
    for (const std::ptrdiff_t first : journey.occupied)
    {
      const std::ptrdiff_t last = std::min(l.size(), first + chunk);
      int n_left                = 0;
      for (std::ptrdiff_t p = first; p < last; ++p)
        n_left += has_left(p);
      for (std::ptrdiff_t p = first; p < last && n_left > 0; ++p)
        if (has_left(p))
          renew(p);
    }

    body.for_each_newly_broken_bond(
        [&](const std::ptrdiff_t p, const std::ptrdiff_t q, std::size_t)
        {
          for (const std::ptrdiff_t end : {p, q})
            if (end < l.owned_end() && l.owned(end) && !journey.active[end])
              renew(end);
        });
  }
  return found;
}

/// Damaged points of a body, and those a few lattice steps around them.
void ContactSkin::mark_active_near_damage(const std::size_t body)
{
  const Lattice &l = bodies_[body]->lattice();
  std::vector<char> near(l.size()), before;
  for (std::ptrdiff_t p = 0; p < l.size(); ++p)
    near[p] = bodies_[body]->is_damaged(p);
  // One axis after the other. Steps across the end of a row mark a few points too many.
  for (const std::ptrdiff_t stride :
       {std::ptrdiff_t(1), l.index(0, 0, 1) - l.index(0, 0, 0), l.plane_stride()})
  {
    before = near;
    for (std::ptrdiff_t shift = stride; shift <= band * stride; shift += stride)
      for (std::ptrdiff_t p = 0; p < l.size() - shift; ++p)
      {
        near[p + shift] |= before[p];
        near[p] |= before[p + shift];
      }
  }
  journeys_[body].active = std::move(near);
}

void ContactSkin::mark_active_near_other_bodies()
{
  // The lower corner of the box in which each body stays, and minus the upper one.
  std::vector<double> corners(6 * bodies_.size(), std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    for (const auto &box : journeys_[i].boxes)
      for (int d = 0; d < 3; ++d)
      {
        corners[6 * i + d]     = std::min(corners[6 * i + d], box.low[d]);
        corners[6 * i + 3 + d] = std::min(corners[6 * i + 3 + d], -box.high[d]);
      }
  MPI_Allreduce(MPI_IN_PLACE, corners.data(), static_cast<int>(corners.size()), MPI_DOUBLE, MPI_MIN,
                communicator_);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    for (std::size_t j = 0; j < bodies_.size(); ++j)
      if (j != i)
        mark_active_in_box(i, corners.data() + 6 * j);
}

/// Points of a body that may touch something in a box, given by its lower and minus its upper
/// corner.
void ContactSkin::mark_active_in_box(const std::size_t body, const double *const corner)
{
  auto &journey = journeys_[body];
  for (std::size_t p = 0; p < journey.reach.size(); ++p)
  {
    const double margin = range_ + journey.reach[p];
    bool inside         = true;
    for (int d = 0; d < 3; ++d)
    {
      double low = corner[d], high = -corner[3 + d];
      if (mirrored_ && d == 1)
        std::tie(low, high) = std::make_tuple(std::min(low, -high), std::max(high, -low));
      inside = inside && journey.start[d][p] > low - margin && journey.start[d][p] < high + margin;
    }
    journey.active[p] |= inside;
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

void ContactSkin::add_own_points(ContactCandidates &candidates) const
{
  CoarseCells cells(4. * spacing_);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    bodies_[i]->lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto &journey = journeys_[i];
          if (!journey.active[p])
            return;
          const double margin = range_ + journey.reach[p];
          Vector3 x(journey.start[0][p], journey.start[1][p], journey.start[2][p]);
          cells.mark(x, margin);
          x.y() *= -1.;
          if (mirrored_)
            cells.mark(x, margin);
        });
  cells.join(communicator_);

  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &journey = journeys_[i];
    const Lattice &l    = bodies_[i]->lattice();
    std::vector<char> worth_a_look(journey.boxes.size());
    for (std::size_t c = 0; c < journey.boxes.size(); ++c)
      worth_a_look[c] = cells.any_marked(journey.boxes[c].low, journey.boxes[c].high);
    l.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (!worth_a_look[p / chunk])
            return;
          if (!journey.active[p])
          {
            double low[3], high[3];
            for (int d = 0; d < 3; ++d)
            {
              low[d]  = journey.start[d][p] - journey.reach[p];
              high[d] = journey.start[d][p] + journey.reach[p];
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
    lowest = std::min(lowest, point.position[1] - point.reach);
  MPI_Allreduce(MPI_IN_PLACE, &lowest, 1, MPI_DOUBLE, MPI_MIN, communicator_);
  for (std::size_t i = 0; i < candidates.n_own; ++i)
    if (lowest + candidates.points[i].position[1] - candidates.points[i].reach < range_)
    {
      candidates.points.push_back(image_of(candidates.points[i]));
      candidates.points.back().number = static_cast<std::int32_t>(candidates.points.size() - 1);
    }
}

std::vector<ContactPoint> ContactSkin::points_near(const ContactPoint &point) const
{
  std::vector<ContactPoint> found;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &journey = journeys_[i];
    const double *start[3], *const reach = journey.reach.data();
    for (int d = 0; d < 3; ++d)
      start[d] = journey.start[d].data();
    const double x = point.position[0], y = point.position[1], z = point.position[2],
                 range   = range_ + point.reach;
    const auto may_touch = [=](const std::ptrdiff_t p)
    {
      const double dx = start[0][p] - x, dy = start[1][p] - y, dz = start[2][p] - z,
                   limit = range + reach[p];
      return dx * dx + dy * dy + dz * dz < limit * limit;
    };
    const auto n = static_cast<std::ptrdiff_t>(journey.reach.size());
    for (std::ptrdiff_t first = 0; first < n; first += chunk)
    {
      const Box &box = journey.boxes[first / chunk];
      if (x + range < box.low[0] || x - range > box.high[0] || y + range < box.low[1] ||
          y - range > box.high[1] || z + range < box.low[2] || z - range > box.high[2])
        continue;
      for (std::ptrdiff_t p = first; p < std::min(n, first + chunk); ++p)
        if (may_touch(p) && (point.active || journey.active[p]))
        {
          const auto partner = contact_point(i, p);
          if (partner.id != point.id)
            found.push_back(partner);
        }
    }
  }
  return found;
}

ContactPoint ContactSkin::contact_point(const std::size_t body, const std::ptrdiff_t p) const
{
  const auto &journey = journeys_[body];
  return {{journey.start[0][p], journey.start[1][p], journey.start[2][p]},
          journey.reach[p],
          numbering_.id(static_cast<int>(body), bodies_[body]->lattice().coordinates(p)),
          rank_,
          static_cast<std::int32_t>(p),
          -1,
          bodies_[body]->is_damaged(p),
          false,
          journey.active[p] != 0};
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
