// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/contact_pairs.h"

#include "ricochet/base/exchange.h"

#include <algorithm>
#include <tuple>

namespace ricochet
{
namespace
{
// So many points are searched one by one; beyond, searching all is cheaper.
constexpr int most_strays = 64;

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
} // namespace

ContactPairs::ContactPairs(const MPI_Comm communicator, const Bodies &bodies, const bool mirrored,
                           const std::string &search) :
  communicator_(communicator),
  bodies_(bodies), mirrored_(mirrored), numbering_(bodies), spacing_(largest_spacing(bodies)),
  range_(1.35 * spacing_),
  search_(make_contact_search(search, {communicator, spacing_, range_, &numbering_})),
  journeys_(communicator, bodies, numbering_, mirrored, spacing_, range_),
  watched_(communicator, bodies, numbering_)
{
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &n_ranks_);
  for (const auto &body : bodies)
    former_neighbours_.emplace_back(*body);
}

void ContactPairs::update(const double dt)
{
  std::vector<ContactPoint> strays;
  int n_strays = most_strays + 1;
  if (n_searches_ > 0 && !bodies_changed_)
  {
    strays   = journeys_.strays(dt);
    n_strays = static_cast<int>(std::min<std::size_t>(strays.size(), most_strays + 1));
    MPI_Allreduce(MPI_IN_PLACE, &n_strays, 1, MPI_INT, MPI_SUM, communicator_);
  }
  if (n_strays > most_strays)
    search_all(dt);
  else
  {
    for (auto &pairs : former_neighbours_)
      pairs.add_newly_broken();
    if (n_strays > 0)
      search_again(strays);
  }
  watched_.update();
}

void ContactPairs::search_all(const double dt)
{
  ++n_searches_;
  bodies_changed_ = false;
  foreign_pairs_.pairs.clear();
  watched_.clear();

  journeys_.begin(dt);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    former_neighbours_[i].list(journeys_.reach(i));
  auto candidates = journeys_.candidates();
  search_->find(candidates);
  for (const auto &pair : candidates.pairs)
  {
    const ContactPoint &one    = candidates.points[pair.first],
                       &other  = candidates.points[pair.second];
    const auto [lower, higher] = one.id < other.id ? std::tie(one, other) : std::tie(other, one);
    if (numbering_.offset(lower.id, higher.id) < 0)
      add_foreign_pair(lower, higher);
  }
  sort_foreign_pairs();
  watched_.watch();
}

/// Ascending by the ids of their points, each once.
void ContactPairs::sort_foreign_pairs()
{
  auto &pairs           = foreign_pairs_.pairs;
  const auto new_number = watched_.sort();
  for (auto &pair : pairs)
  {
    pair.a = new_number[pair.a];
    pair.b = new_number[pair.b];
  }
  const auto key = [](const NonBondedPair &pair) { return std::tie(pair.a, pair.b); };
  std::sort(pairs.begin(), pairs.end(),
            [&](const NonBondedPair &x, const NonBondedPair &y) { return key(x) < key(y); });
  pairs.erase(std::unique(pairs.begin(), pairs.end(),
                          [&](const NonBondedPair &x, const NonBondedPair &y)
                          { return key(x) == key(y); }),
              pairs.end());
  foreign_pairs_.n_sorted = pairs.size();
}

/// Adds the pairs of a few points of this and other ranks. Collective.
void ContactPairs::search_again(const std::vector<ContactPoint> &strays)
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
    for (const auto &partner : journeys_.points_near(stray))
    {
      add(partner, stray);
      if (stray.rank != rank_)
        home[stray.rank].push_back({stray, partner});
    }
    if (!mirrored_)
      continue;
    // What meets the stray's image; and the same in the mirror.
    const ContactPoint image = journeys_.image_of(stray);
    for (const auto &partner : journeys_.points_near(image))
    {
      add(partner, image);
      if (partner.id != stray.id)
        add_or_send(stray, journeys_.image_of(partner));
    }
  }
  for (const auto &pair : joined(exchange_lists(communicator_, home)))
    add(pair.own, pair.other);
  watched_.watch();
}

/// Lists a pair, at least one of this rank, if it may touch. It may be listed already.
void ContactPairs::add(const ContactPoint &one, const ContactPoint &other)
{
  const bool in_order       = one.id < other.id;
  const ContactPoint &lower = in_order ? one : other, &higher = in_order ? other : one;
  const int offset = numbering_.offset(lower.id, higher.id);
  if (offset < 0)
  {
    add_foreign_pair(lower, higher);
    return;
  }
  const int body          = numbering_.place(lower.id).body;
  const Lattice &l        = bodies_[body]->lattice();
  const bool lower_is_own = lower.rank == rank_ && !lower.image;
  former_neighbours_[body].add(
      lower_is_own ? lower.flat : higher.flat - l.shift(l.stencil().offsets[offset]), offset);
}

void ContactPairs::add_foreign_pair(const ContactPoint &lower, const ContactPoint &higher)
{
  const double squared  = (vector(lower.position) - vector(higher.position)).squaredNorm();
  const auto is_further = [&](const double distance)
  {
    const double limit = distance + lower.reach + higher.reach;
    return squared >= limit * limit;
  };
  if (is_further(range_)) // most; where they came from need not be worked out
    return;
  const auto place = numbering_.place(lower.id), other = numbering_.place(higher.id);
  const Lattice &l = bodies_[place.body]->lattice(), &m = bodies_[other.body]->lattice();
  const bool one_body = place.body == other.body;
  const double d      = contact_distance(
           (l.reference_position(place.lattice) - m.reference_position(other.lattice)).norm(),
      one_body ? l.box().spacing : 0.5 * (l.box().spacing + m.box().spacing));
  if (!is_further(d))
    foreign_pairs_.pairs.push_back(
        {watched_.number_of(lower), watched_.number_of(higher), one_body, d});
}
} // namespace ricochet
