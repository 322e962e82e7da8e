// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_pairs.h"

#include "contact_distance.h"
#include "ricochet/base/exchange.h"

#include <algorithm>
#include <tuple>

namespace ricochet
{
namespace
{
// So many points, of all ranks, are searched one by one; beyond, all are searched. One alone costs
// a look at each chunk of points, all together some tens of those: an estimate that no measurement
// backs. It shares out the cost only.
constexpr int most_single_searches = 64;

double largest_spacing(const Bodies &bodies)
{
  double spacing = 0.;
  for (const auto &body : bodies)
    spacing = std::max(spacing, body->lattice().box().spacing);
  return spacing;
}
} // namespace

ContactPairs::ContactPairs(const MPI_Comm communicator, const Bodies &bodies, const bool mirrored,
                           const std::string &search) :
  communicator_(communicator),
  bodies_(bodies), mirrored_(mirrored), numbering_(bodies), spacing_(largest_spacing(bodies)),
  range_(largest_contact_distance(spacing_)),
  search_(make_candidate_search(search, {communicator, spacing_, range_, &numbering_})),
  skin_(communicator, bodies, numbering_, mirrored, spacing_, range_),
  ghosts_(communicator, bodies, numbering_)
{
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &n_ranks_);
  for (const auto &body : bodies)
    broken_bond_pairs_.emplace_back(*body);
}

void ContactPairs::update(const double dt)
{
  std::vector<ContactPoint> out_of_skin;
  int n_out = most_single_searches + 1;
  if (n_searches_ > 0 && !bodies_changed_)
  {
    out_of_skin = skin_.points_out_of_skin(dt);
    n_out = static_cast<int>(std::min<std::size_t>(out_of_skin.size(), most_single_searches + 1));
    MPI_Allreduce(MPI_IN_PLACE, &n_out, 1, MPI_INT, MPI_SUM, communicator_);
  }
  if (n_out > most_single_searches)
    search_all(dt);
  else
  {
    for (auto &pairs : broken_bond_pairs_)
      pairs.add_newly_parted();
    if (n_out > 0)
      search_single(out_of_skin);
  }
  ghosts_.update();
}

void ContactPairs::search_all(const double dt)
{
  ++n_searches_;
  bodies_changed_ = false;
  non_bonded_pairs_.pairs.clear();
  ghosts_.clear();

  skin_.reset(dt);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    broken_bond_pairs_[i].list(skin_.thickness(i));
  auto candidates = skin_.candidates();
  search_->find(candidates);
  for (const auto &pair : candidates.pairs)
  {
    const ContactPoint &one    = candidates.points[pair.first],
                       &other  = candidates.points[pair.second];
    const auto [lower, higher] = one.id < other.id ? std::tie(one, other) : std::tie(other, one);
    if (numbering_.offset(lower.id, higher.id) < 0)
      add_non_bonded_pair(lower, higher);
  }
  sort_non_bonded_pairs();
  ghosts_.set_up_exchange();
}

/// Ascending by the ids of their points, each once.
void ContactPairs::sort_non_bonded_pairs()
{
  auto &pairs           = non_bonded_pairs_.pairs;
  const auto new_number = ghosts_.sort();
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
  non_bonded_pairs_.n_sorted = pairs.size();
}

/// Adds the pairs of a few points of this and other ranks. Collective.
void ContactPairs::search_single(const std::vector<ContactPoint> &points)
{
  n_single_searches_ += static_cast<long>(points.size());
  std::vector<std::vector<NewPair>> home(n_ranks_);
  const auto add_or_send = [&](const ContactPoint &own, const ContactPoint &other)
  {
    if (own.rank == rank_)
      add(own, other);
    else
      home[own.rank].push_back({own, other});
  };
  const std::vector<std::vector<ContactPoint>> to_all(n_ranks_, points);
  for (const auto &point : joined(exchange_lists(communicator_, to_all)))
  {
    for (const auto &partner : skin_.points_near(point))
    {
      add(partner, point);
      if (point.rank != rank_)
        home[point.rank].push_back({point, partner});
    }
    if (!mirrored_)
      continue;
    // What meets the point's image; and the same in the mirror.
    const ContactPoint image = skin_.image_of(point);
    for (const auto &partner : skin_.points_near(image))
    {
      add(partner, image);
      if (partner.id != point.id)
        add_or_send(point, skin_.image_of(partner));
    }
  }
  for (const auto &pair : joined(exchange_lists(communicator_, home)))
    add(pair.own, pair.other);
  ghosts_.set_up_exchange();
}

/// Lists a pair, at least one of this rank, if it may touch. It may be listed already.
void ContactPairs::add(const ContactPoint &one, const ContactPoint &other)
{
  const bool in_order       = one.id < other.id;
  const ContactPoint &lower = in_order ? one : other, &higher = in_order ? other : one;
  const int offset = numbering_.offset(lower.id, higher.id);
  if (offset < 0)
  {
    add_non_bonded_pair(lower, higher);
    return;
  }
  const int body          = numbering_.place(lower.id).body;
  const Lattice &l        = bodies_[body]->lattice();
  const bool lower_is_own = lower.rank == rank_ && !lower.image;
  broken_bond_pairs_[body].add(
      lower_is_own ? lower.flat : higher.flat - l.shift(l.stencil().offsets[offset]), offset);
}

void ContactPairs::add_non_bonded_pair(const ContactPoint &lower, const ContactPoint &higher)
{
  const double squared  = (position_of(lower) - position_of(higher)).squaredNorm();
  const auto is_further = [&](const double distance)
  {
    const double limit = distance + lower.skin + higher.skin;
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
    non_bonded_pairs_.pairs.push_back(
        {ghosts_.number_of(lower), ghosts_.number_of(higher), one_body, d});
}
} // namespace ricochet
