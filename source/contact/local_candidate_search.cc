// SPDX-License-Identifier: LGPL-2.1-or-later
#include "local_candidate_search.h"

#include "ricochet/base/exchange.h"
#include "ricochet/search/near_points.h"
#include "search_levels.h"

namespace ricochet
{
LocalCandidateSearch::LocalCandidateSearch(const std::string &name, const Parameters &parameters) :
  CandidateSearch(parameters), search_(make_pair_search(name))
{
}

void LocalCandidateSearch::find(ContactCandidates &candidates)
{
  add_points_of_other_ranks(candidates);
  candidates.pairs.clear();
  for (int level = 0; level < n_levels; ++level)
  {
    if (!level_has_points(candidates.points, level, parameters_.spacing))
      continue;
    const auto points =
        points_up_to_level(candidates.points, candidates.points.size(), level, parameters_.spacing);
    search_->find(points.position, points.active, radius_of_level(level, parameters_), found_, {},
                  parameters_.numbering->families(points.id));
    for (const auto &pair : found_)
    {
      const std::int32_t a = points.number[pair.first], b = points.number[pair.second];
      if (static_cast<std::size_t>(std::min(a, b)) < candidates.n_own &&
          (candidates.points[a].active || candidates.points[b].active))
        candidates.pairs.push_back({a, b});
    }
  }
}

void LocalCandidateSearch::add_points_of_other_ranks(ContactCandidates &candidates) const
{
  std::vector<Vector3> centres;
  std::vector<double> radii;
  int n_ranks;
  MPI_Comm_size(parameters_.communicator, &n_ranks);
  if (n_ranks == 1)
    return;
  for (const auto &point : candidates.points)
  {
    centres.push_back(position_of(point));
    radii.push_back(point.skin + 0.5 * parameters_.range);
  }
  const auto numbers = balls_near_other_ranks(parameters_.communicator, centres, radii,
                                              candidates.n_own, coarse_cell * parameters_.spacing);
  const auto others =
      joined(exchange_lists(parameters_.communicator, chosen(candidates.points, numbers)));
  candidates.points.insert(candidates.points.end(), others.begin(), others.end());
}
} // namespace ricochet
