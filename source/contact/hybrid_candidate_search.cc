// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid_candidate_search.h"

#include "ricochet/base/exchange.h"
#include "search_levels.h"

namespace ricochet
{
HybridCandidateSearch::HybridCandidateSearch(const Parameters &parameters) :
  CandidateSearch(parameters), search_(parameters.communicator)
{
  MPI_Comm_rank(parameters.communicator, &rank_);
  MPI_Comm_size(parameters.communicator, &n_ranks_);
}

void HybridCandidateSearch::find(ContactCandidates &candidates)
{
  candidates.pairs.clear();
  std::unordered_map<std::int64_t, std::int32_t> others; // their numbers by id
  for (int level = 0; level < n_levels; ++level)
  {
    int any = level_has_points(candidates.points, level, parameters_.spacing);
    MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, parameters_.communicator);
    if (any == 0)
      continue;
    for (const auto &partner : partners_of_level(candidates, level))
      candidates.pairs.push_back({partner.number, number_of(partner.point, candidates, others)});
  }
}

std::vector<HybridCandidateSearch::Partner>
HybridCandidateSearch::partners_of_level(const ContactCandidates &candidates, const int level)
{
  const auto points =
      points_up_to_level(candidates.points, candidates.n_local, level, parameters_.spacing);
  std::vector<ContactPoint> own;
  std::vector<std::int64_t> ids;
  for (const auto i : points.number)
  {
    own.push_back(candidates.points[i]);
    ids.push_back((std::int64_t(rank_) << 32) | i);
  }
  search_.find(points.position, points.active, ids, radius_of_level(level, parameters_));
  const auto all = search_.distribute(own);

  std::vector<std::vector<Partner>> home(n_ranks_);
  for (const auto &pair : search_.pairs())
  {
    const ContactPoint &a = all[pair.first], &b = all[pair.second];
    if (!may_touch(a, b))
      continue;
    if (!a.image)
      home[a.rank].push_back({a.number, b});
    if (!b.image && (a.image || a.rank != b.rank))
      home[b.rank].push_back({b.number, a});
  }
  return joined(exchange_lists(parameters_.communicator, home));
}

bool HybridCandidateSearch::may_touch(const ContactPoint &a, const ContactPoint &b) const
{
  if (!a.active && !b.active)
    return false;
  const auto [lower, higher] = std::minmax(a.id, b.id);
  if (parameters_.numbering->offset(lower, higher) >= 0)
    return false;
  const double limit = parameters_.range + a.skin + b.skin;
  return (position_of(a) - position_of(b)).squaredNorm() < limit * limit;
}

std::int32_t
HybridCandidateSearch::number_of(const ContactPoint &point, ContactCandidates &candidates,
                                 std::unordered_map<std::int64_t, std::int32_t> &others) const
{
  if (point.rank == rank_)
    return point.number;
  const auto [entry, is_new] =
      others.emplace(point.id, static_cast<std::int32_t>(candidates.points.size()));
  if (is_new)
    candidates.points.push_back(point);
  return entry->second;
}
} // namespace ricochet
