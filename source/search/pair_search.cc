// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/search/pair_search.h"

#include "ricochet/base/exceptions.h"

#include <cassert>

namespace ricochet
{
void PairSearch::find(const std::vector<Vector3> &points, const std::vector<char> &active,
                      const double radius, std::vector<PointPair> &pairs, const SearchShare share,
                      const Families &families) const
{
  assert(radius > 0. && share.part >= 0 && share.part < share.n_parts);
  assert(active.empty() || active.size() == points.size());
  assert(families.place.empty() || families.place.size() == points.size());
  pairs.clear();
  if (points.size() > 1)
    search({points, active, families}, radius, share, pairs);
}

const std::vector<PairSearchEntry> &pair_searches()
{
  static const std::vector<PairSearchEntry> searches{
      {"linked cells", [] { return make_linked_cells(); }},
      {"kd-tree", [] { return make_kd_tree(); }},
      {"brute force", [] { return make_brute_force(); }},
  };
  return searches;
}

std::unique_ptr<PairSearch> make_pair_search(const std::string &name)
{
  std::string known;
  for (const auto &search : pair_searches())
  {
    if (name == search.name)
      return search.make();
    known += (known.empty() ? "" : ", ") + std::string(search.name);
  }
  throw InputError("There is no pair search '" + name + "'; choose one of: " + known + ".");
}
} // namespace ricochet
