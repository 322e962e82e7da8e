// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/forces/debris_pairs.h"

#include "ricochet/discretization/exchange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ricochet
{
namespace
{
// How far a point may get: so many steps at its present speed, and a little for those that rest.
constexpr double steps_ahead = 16.;
constexpr double least_reach = 0.1; // [spacings]

// So many points are searched one by one; beyond, searching all is cheaper.
constexpr int most_strays = 64;

// So many entries of a field are looked at together.
constexpr std::ptrdiff_t chunk = 8 * Lattice::block_size;

// Sound points so many lattice steps around damage are searched like damaged ones: cracks grow
// there.
constexpr int fringe = 2;

double largest_spacing(const Bodies &bodies)
{
  double spacing = 0.;
  for (const auto &body : bodies)
    spacing = std::max(spacing, body->lattice().box().spacing);
  return spacing;
}

Vector3 vector(const double (&x)[3])
{
  return {x[0], x[1], x[2]};
}

/// Coarse cells of space, marked where something is. They repeat after 32 cells along each axis:
/// what is marked elsewhere too is looked at in vain, nothing is overlooked.
class CoarseCells
{
public:
  explicit CoarseCells(const double size) : size_(size), marked_(period * period * period, 0) {}

  void mark(const Vector3 &x, const double margin)
  {
    const double low[3]  = {x[0] - margin, x[1] - margin, x[2] - margin},
                 high[3] = {x[0] + margin, x[1] + margin, x[2] + margin};
    for_each(low, high,
             [&](char &marked)
             {
               marked = 1;
               return false;
             });
  }
  bool any_marked(const double (&low)[3], const double (&high)[3])
  {
    return for_each(low, high, [](const char marked) { return marked != 0; });
  }
  /// What any rank has marked is marked on all. Collective.
  void join(const MPI_Comm communicator)
  {
    MPI_Allreduce(MPI_IN_PLACE, marked_.data(), static_cast<int>(marked_.size()), MPI_CHAR, MPI_MAX,
                  communicator);
  }

private:
  static constexpr int period = 32;

  /// Visits the cells of a box until visit() is true, and says whether it was. A box that is empty
  /// or not a number has none.
  template <class Visitor>
  bool for_each(const double (&low)[3], const double (&high)[3], Visitor &&visit)
  {
    std::int64_t first[3], n[3];
    for (int d = 0; d < 3; ++d)
    {
      const double from = std::floor(low[d] / size_), to = std::floor(high[d] / size_);
      if (!(to >= from))
        return false;
      n[d]     = to - from < period ? static_cast<std::int64_t>(to - from) + 1 : period;
      first[d] = std::abs(from) < 1e15 ? static_cast<std::int64_t>(from) : 0;
      if (std::abs(from) >= 1e15)
        n[d] = period;
    }
    for (std::int64_t i = 0; i < n[0]; ++i)
      for (std::int64_t j = 0; j < n[1]; ++j)
        for (std::int64_t k = 0; k < n[2]; ++k)
          if (visit(marked_[(
                  (((first[0] + i) & (period - 1)) * period + ((first[1] + j) & (period - 1))) *
                      period +
                  ((first[2] + k) & (period - 1)))]))
            return true;
    return false;
  }

  double size_; // [m]
  std::vector<char> marked_;
};
} // namespace

DebrisPairs::DebrisPairs(const MPI_Comm communicator, const Bodies &bodies, const bool mirrored,
                         const std::string &search) :
  communicator_(communicator),
  bodies_(bodies), mirrored_(mirrored), numbering_(bodies), spacing_(largest_spacing(bodies)),
  range_(1.35 * spacing_),
  search_(make_contact_search(search, {communicator, spacing_, range_, &numbering_})),
  journeys_(bodies.size()), bond_pairs_(bodies.size())
{
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &n_ranks_);
}

DebrisPairs::~DebrisPairs() = default;

double DebrisPairs::contact_distance(const double reference_distance, const double spacing) const
{
  return std::min(0.9 * reference_distance, 1.35 * spacing);
}

void DebrisPairs::update(const double dt)
{
  list_pairs(dt);
  update_watched();
}

/// Sees to it that all pairs that touch are listed.
void DebrisPairs::list_pairs(const double dt)
{
  std::vector<ContactPoint> astray;
  int n_astray = most_strays + 1;
  if (n_searches_ > 0 && !bodies_changed_)
  {
    astray   = strays(dt);
    n_astray = static_cast<int>(std::min<std::size_t>(astray.size(), most_strays + 1));
    MPI_Allreduce(MPI_IN_PLACE, &n_astray, 1, MPI_INT, MPI_SUM, communicator_);
  }
  if (n_astray > most_strays)
    search_all(dt);
  else
  {
    append_broken();
    if (n_astray > 0)
      search_again(astray);
  }
}

/// Points of this rank that have left their reach, or broken a bond though they were not active.
/// They get a new reach and are active from now on.
std::vector<ContactPoint> DebrisPairs::strays(const double dt)
{
  std::vector<ContactPoint> found;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &body         = *bodies_[i];
    const Lattice &l         = body.lattice();
    const std::ptrdiff_t low = l.owned_begin();
    auto &journey            = journeys_[i];
    const auto renew         = [&](const std::ptrdiff_t p)
    {
      start_journey(i, p, dt);
      // Also a sound point: it may have come near another body.
      journey.active[p - low] = 1;
      found.push_back(contact_point(i, p, l.coordinates(p)));
    };

    const double *x[3], *start[3], *const reach = journey.reach.data();
    for (int d = 0; d < 3; ++d)
    {
      x[d]     = body.state().arrays.position[d] + low;
      start[d] = journey.start[d].data();
    }
    const auto has_left = [&](const std::ptrdiff_t p)
    {
      const double dx = x[0][p] - start[0][p], dy = x[1][p] - start[1][p],
                   dz = x[2][p] - start[2][p];
      return dx * dx + dy * dy + dz * dz > reach[p] * reach[p];
    };
    // Counted first: this runs over all points at every step, and a sum needs no branches.
    const auto n = static_cast<std::ptrdiff_t>(journey.reach.size());
    for (const std::ptrdiff_t first : journey.occupied)
    {
      const std::ptrdiff_t last = std::min(n, first + chunk);
      int n_left                = 0;
      for (std::ptrdiff_t p = first; p < last; ++p)
        n_left += has_left(p);
      for (std::ptrdiff_t p = first; p < last && n_left > 0; ++p)
        if (has_left(p))
          renew(low + p);
    }

    for (std::size_t k = 0; k < body.n_broken_entries(); ++k)
    {
      const auto &entry = body.broken()[k];
      const auto shift  = l.shift(l.stencil().offsets[entry.offset]);
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((entry.points >> lane) & 1)
          for (const std::ptrdiff_t p :
               {entry.block * Lattice::block_size + lane + std::ptrdiff_t(0),
                entry.block * Lattice::block_size + lane + shift})
            if (p < l.owned_end() && l.owned(p) && !journey.active[p - low])
              renew(p);
    }
  }
  return found;
}

void DebrisPairs::append_broken()
{
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &body    = *bodies_[i];
    const auto &stencil = body.lattice().stencil();
    for (std::size_t n = 0; n < body.n_broken_entries(); ++n)
    {
      const auto &entry  = body.broken()[n];
      const auto &offset = stencil.offsets[entry.offset];
      const auto shift   = body.lattice().shift(offset);
      const double d     = contact_distance(offset.length, stencil.spacing);
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((entry.points >> lane) & 1)
        {
          const std::int32_t p = entry.block * Lattice::block_size + lane;
          bond_pairs_[i].push_back({p, static_cast<std::int32_t>(p + shift), d});
        }
    }
  }
}

void DebrisPairs::search_all(const double dt)
{
  ++n_searches_;
  bodies_changed_ = false;
  for (auto &pairs : bond_pairs_)
    pairs.clear();
  foreign_pairs_.clear();
  watched_points_.clear();
  watched_numbers_.clear();
  followers_.clear();

  begin_journeys(dt);
  ContactCandidates candidates;
  add_own_points(candidates);
  if (mirrored_)
    add_images(candidates);
  candidates.n_local = candidates.points.size();
  search_->find(candidates);
  for (const auto &pair : candidates.pairs)
    add(candidates.points[pair.first], candidates.points[pair.second]);
  watch();
}

/// Adds the pairs of a few points of this and other ranks. Collective.
void DebrisPairs::search_again(const std::vector<ContactPoint> &strays)
{
  n_single_searches_ += static_cast<long>(strays.size());
  std::vector<std::vector<NewPair>> home(n_ranks_);
  const auto add_or_send = [&](const ContactPoint &own, const ContactPoint &other)
  {
    if (own.rank == rank_)
      add(own, other);
    else
      home[own.rank].push_back({own, other});
  };
  const std::vector<std::vector<ContactPoint>> to_all(n_ranks_, strays);
  for (const auto &stray : joined(exchange_lists(communicator_, to_all)))
  {
    for (const auto &partner : points_near(stray))
    {
      add(partner, stray);
      if (stray.rank != rank_)
        home[stray.rank].push_back({stray, partner});
    }
    if (!mirrored_)
      continue;
    // What meets the stray's image; and the same in the mirror.
    const ContactPoint image = image_of(stray);
    for (const auto &partner : points_near(image))
    {
      add(partner, image);
      if (partner.id != stray.id)
        add_or_send(stray, image_of(partner));
    }
  }
  for (const auto &pair : joined(exchange_lists(communicator_, home)))
    add(pair.own, pair.other);
  watch();
}

/// The points of this rank that may touch a point before either leaves its reach, without the point
/// itself.
std::vector<ContactPoint> DebrisPairs::points_near(const ContactPoint &point) const
{
  std::vector<ContactPoint> found;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &journey = journeys_[i];
    const Lattice &l    = bodies_[i]->lattice();
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
          const auto partner =
              contact_point(i, l.owned_begin() + p, l.coordinates(l.owned_begin() + p));
          if (partner.id != point.id)
            found.push_back(partner);
        }
    }
  }
  return found;
}

/// A point may get so far from here before it is searched again.
void DebrisPairs::start_journey(const std::size_t body, const std::ptrdiff_t p, const double dt)
{
  const auto &a           = bodies_[body]->state().arrays;
  const std::ptrdiff_t at = p - bodies_[body]->lattice().owned_begin();
  auto &journey           = journeys_[body];
  auto &box               = journey.boxes[at / chunk];
  const Vector3 v(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]);
  const double reach = std::min(ContactSearch::largest_reach * spacing_,
                                least_reach * spacing_ + steps_ahead * dt * v.norm());
  journey.reach[at]  = reach;
  for (int d = 0; d < 3; ++d)
  {
    const double x       = a.position[d][p];
    journey.start[d][at] = x;
    box.low[d]           = std::min(box.low[d], x - reach);
    box.high[d]          = std::max(box.high[d], x + reach);
  }
}

void DebrisPairs::begin_journeys(const double dt)
{
  constexpr double largest = std::numeric_limits<double>::max();
  const Box nowhere{{largest, largest, largest}, {-largest, -largest, -largest}};
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const Lattice &l       = bodies_[i]->lattice();
    const std::ptrdiff_t n = l.owned_end() - l.owned_begin();
    auto &journey          = journeys_[i];
    // What is not a number is neither near anything nor astray.
    for (auto &start : journey.start)
      start.assign(n, std::numeric_limits<double>::quiet_NaN());
    journey.reach.assign(n, 0.);
    journey.boxes.assign((n + chunk - 1) / chunk, nowhere);
    l.for_each_owned([&](const std::ptrdiff_t p) { start_journey(i, p, dt); });
    journey.occupied.clear();
    for (std::size_t c = 0; c < journey.boxes.size(); ++c)
      if (journey.boxes[c].low[0] <= journey.boxes[c].high[0])
        journey.occupied.push_back(static_cast<std::ptrdiff_t>(c) * chunk);
    mark_active_near_damage(i);
  }
  if (bodies_.size() == 1)
    return;

  // The lower corner of the box in which each body stays, and minus the upper one.
  std::vector<double> corners(6 * bodies_.size(), largest);
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

/// Damaged points of a body, and those a few lattice steps around them.
void DebrisPairs::mark_active_near_damage(const std::size_t body)
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
    for (std::ptrdiff_t shift = stride; shift <= fringe * stride; shift += stride)
      for (std::ptrdiff_t p = 0; p < l.size() - shift; ++p)
      {
        near[p + shift] |= before[p];
        near[p] |= before[p + shift];
      }
  }
  journeys_[body].active.assign(near.begin() + l.owned_begin(), near.begin() + l.owned_end());
}

/// Points of a body that may touch something in a box, given by its lower and minus its upper
/// corner.
void DebrisPairs::mark_active_in_box(const std::size_t body, const double *const corner)
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

ContactPoint DebrisPairs::contact_point(const std::size_t body, const std::ptrdiff_t p,
                                        const std::array<int, 3> &place) const
{
  const auto &journey     = journeys_[body];
  const std::ptrdiff_t at = p - bodies_[body]->lattice().owned_begin();
  return {{journey.start[0][at], journey.start[1][at], journey.start[2][at]},
          journey.reach[at],
          numbering_.id(static_cast<int>(body), place),
          rank_,
          static_cast<std::int32_t>(p),
          -1,
          bodies_[body]->is_damaged(p),
          false,
          journey.active[at] != 0};
}

/// The image of a point, or the point of an image.
ContactPoint DebrisPairs::image_of(ContactPoint point) const
{
  auto place       = numbering_.place(point.id);
  place.lattice[1] = -1 - place.lattice[1];
  point.id         = numbering_.id(place.body, place.lattice);
  point.position[1] *= -1.;
  point.image = !point.image;
  return point;
}

/// Own points that are active or may come near an active one.
void DebrisPairs::add_own_points(ContactCandidates &candidates) const
{
  CoarseCells cells(4. * spacing_);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    bodies_[i]->lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto &journey     = journeys_[i];
          const std::ptrdiff_t at = p - bodies_[i]->lattice().owned_begin();
          if (!journey.active[at])
            return;
          const double margin = range_ + journey.reach[at];
          Vector3 x(journey.start[0][at], journey.start[1][at], journey.start[2][at]);
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
          const std::ptrdiff_t at = p - l.owned_begin();
          if (!worth_a_look[at / chunk])
            return;
          if (!journey.active[at])
          {
            double low[3], high[3];
            for (int d = 0; d < 3; ++d)
            {
              low[d]  = journey.start[d][at] - journey.reach[at];
              high[d] = journey.start[d][at] + journey.reach[at];
            }
            if (!cells.any_marked(low, high))
              return;
          }
          candidates.points.push_back(contact_point(i, p, l.coordinates(p)));
          candidates.points.back().number = static_cast<std::int32_t>(candidates.points.size() - 1);
        });
  }
  candidates.n_own = candidates.points.size();
}

/// Images of those points that may touch a point of any rank.
void DebrisPairs::add_images(ContactCandidates &candidates) const
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

/// Lists a pair, at least one of this rank, if it may touch. It may be listed already.
void DebrisPairs::add(const ContactPoint &one, const ContactPoint &other)
{
  const bool in_order       = one.id < other.id;
  const ContactPoint &lower = in_order ? one : other, &higher = in_order ? other : one;
  const int offset = numbering_.offset(lower.id, higher.id);
  // Most are neighbours in sound material.
  if (offset >= 0 && !lower.damaged && !higher.damaged)
    return;
  const double limit = range_ + lower.reach + higher.reach;
  if ((vector(lower.position) - vector(higher.position)).squaredNorm() >= limit * limit)
    return;
  if (offset >= 0)
    add_bond_pair(lower, higher, offset);
  else
    add_foreign_pair(lower, higher);
}

void DebrisPairs::add_bond_pair(const ContactPoint &lower, const ContactPoint &higher,
                                const int offset)
{
  const int number             = numbering_.place(lower.id).body;
  const PeridynamicForce &body = *bodies_[number];
  const auto &stencil          = body.lattice().stencil();
  const std::ptrdiff_t shift   = body.lattice().shift(stencil.offsets[offset]);
  const bool lower_is_own      = lower.rank == rank_ && !lower.image;
  const std::ptrdiff_t p       = lower_is_own ? lower.flat : higher.flat - shift;
  const std::uint8_t bonds =
      body.state().arrays.bonds[p / Lattice::block_size * stencil.offsets.size() + offset];
  if ((bonds >> (p % Lattice::block_size)) & 1)
    return;
  bond_pairs_[number].push_back(
      {static_cast<std::int32_t>(p), static_cast<std::int32_t>(p + shift),
       contact_distance(stencil.offsets[offset].length, stencil.spacing)});
}

void DebrisPairs::add_foreign_pair(const ContactPoint &lower, const ContactPoint &higher)
{
  const auto place = numbering_.place(lower.id), other = numbering_.place(higher.id);
  const Lattice &l = bodies_[place.body]->lattice(), &m = bodies_[other.body]->lattice();
  const bool one_body = place.body == other.body;
  const double d      = contact_distance(
           (l.reference_position(place.lattice) - m.reference_position(other.lattice)).norm(),
      one_body ? l.box().spacing : 0.5 * (l.box().spacing + m.box().spacing));
  const double limit = d + lower.reach + higher.reach;
  if ((vector(lower.position) - vector(higher.position)).squaredNorm() < limit * limit)
    foreign_pairs_.push_back({number_of(lower), number_of(higher), one_body, d});
}

/// Number of a point in watched_, a new one if need be.
std::int32_t DebrisPairs::number_of(const ContactPoint &point)
{
  const auto [entry, is_new] =
      watched_numbers_.emplace(point.id, static_cast<std::int32_t>(watched_points_.size()));
  if (is_new)
    watched_points_.push_back(point);
  return entry->second;
}

/// Tells the other ranks which of their points are in foreign pairs of this one. Collective.
void DebrisPairs::watch()
{
  std::vector<std::vector<Follower>> asked(n_ranks_);
  watched_of_.assign(n_ranks_, {});
  followers_.clear();
  for (std::size_t i = 0; i < watched_points_.size(); ++i)
  {
    const ContactPoint &point = watched_points_[i];
    Follower follower{point.flat, static_cast<std::int16_t>(numbering_.place(point.id).body),
                      point.image};
    if (point.rank != rank_)
    {
      asked[point.rank].push_back(follower);
      watched_of_[point.rank].push_back(static_cast<std::int32_t>(i));
      follower.flat = -1;
    }
    followers_.push_back(follower);
  }
  watched_by_ = exchange_lists(communicator_, asked);
  watched_.resize(watched_points_.size());
}

DebrisPairs::Watched DebrisPairs::look_at(const Follower &follower) const
{
  const auto &body = *bodies_[follower.body];
  const auto &a    = body.state().arrays;
  const auto p     = follower.flat;
  const double y   = follower.image ? -1. : 1.;
  return {{a.position[0][p], y * a.position[1][p], a.position[2][p]},
          body.is_damaged(p) ? 1. : 0.,
          {a.velocity[0][p], y * a.velocity[1][p], a.velocity[2][p]}};
}

void DebrisPairs::update_watched()
{
  for (std::size_t i = 0; i < followers_.size(); ++i)
    if (followers_[i].flat >= 0)
      watched_[i] = look_at(followers_[i]);

  constexpr int numbers = sizeof(Watched) / sizeof(double);
  std::vector<MPI_Request> requests;
  std::vector<std::vector<Watched>> in(n_ranks_), out(n_ranks_);
  for (int r = 0; r < n_ranks_; ++r)
    if (!watched_of_[r].empty())
    {
      in[r].resize(watched_of_[r].size());
      MPI_Irecv(in[r][0].position, numbers * static_cast<int>(in[r].size()), MPI_DOUBLE, r, 1000,
                communicator_, &requests.emplace_back());
    }
  for (int r = 0; r < n_ranks_; ++r)
    if (!watched_by_[r].empty())
    {
      for (const auto &follower : watched_by_[r])
        out[r].push_back(look_at(follower));
      MPI_Isend(out[r][0].position, numbers * static_cast<int>(out[r].size()), MPI_DOUBLE, r, 1000,
                communicator_, &requests.emplace_back());
    }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (int r = 0; r < n_ranks_; ++r)
    for (std::size_t i = 0; i < in[r].size(); ++i)
      watched_[watched_of_[r][i]] = in[r][i];
}
} // namespace ricochet
