// SPDX-License-Identifier: LGPL-2.1-or-later
#include "candidate_search.h"

#include "hybrid_candidate_search.h"
#include "local_candidate_search.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/contact/contact_search.h"
#include "search_levels.h"

namespace ricochet
{
namespace
{
constexpr const char *hybrid = "hybrid";
}

std::vector<std::string> contact_search_names()
{
  std::vector<std::string> names;
  for (const auto &search : pair_searches())
    names.push_back(search.name);
  names.push_back(hybrid);
  return names;
}

std::unique_ptr<CandidateSearch>
make_candidate_search(const std::string &name, const CandidateSearch::Parameters &parameters)
{
  if (name == hybrid)
    return std::make_unique<HybridCandidateSearch>(parameters);
  const auto names = contact_search_names();
  if (std::find(names.begin(), names.end(), name) != names.end())
    return std::make_unique<LocalCandidateSearch>(name, parameters);
  std::string known;
  for (const auto &one : names)
    known += (known.empty() ? "" : ", ") + one;
  throw InputError("There is no contact search '" + name + "'; choose one of: " + known + ".");
}

LevelPoints points_up_to_level(const std::vector<ContactPoint> &points, const std::size_t n_points,
                               const int level, const double spacing)
{
  LevelPoints result;
  result.number.reserve(n_points);
  result.position.reserve(n_points);
  result.active.reserve(n_points);
  result.id.reserve(n_points);
  for (std::size_t i = 0; i < n_points; ++i)
    if (points[i].skin <= level_limits[level] * spacing)
    {
      result.number.push_back(static_cast<std::int32_t>(i));
      result.position.push_back(position_of(points[i]));
      result.id.push_back(points[i].id);
      result.active.push_back(level > 0 ? is_of_level(points[i], level, spacing)
                                        : points[i].active);
    }
  return result;
}
} // namespace ricochet
