// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cell_grid.h"
#include "ricochet/search/pair_search.h"

#include <algorithm>

namespace ricochet
{
namespace
{
void append(void *const target, const PointPair *const pairs, const std::int64_t n)
{
  auto &all = *static_cast<std::vector<PointPair> *>(target);
  all.insert(all.end(), pairs, pairs + n);
}

class LinkedCells : public PairSearch
{
public:
  explicit LinkedCells(const PairLoops &loops) : loops_(loops) {}

private:
  void search(const SearchPoints &points, const double radius, const SearchShare share,
              std::vector<PointPair> &pairs) const override
  {
    const CellGrid grid(points.position, points.active, radius);
    const SortedFamilies families(points.families, grid.order(), grid.order().size());
    SortedPoints sorted = grid.sorted_points();
    families.add_to(sorted);
    const CellTable table = grid.table();
    // Parts have equally many points, not cells.
    const auto first_cell = [&](const int part)
    {
      const auto n_points     = static_cast<std::int64_t>(grid.order().size());
      const auto *const begin = table.begin, *const end = table.begin + grid.n_cells();
      return part == share.n_parts
                 ? grid.n_cells()
                 : std::lower_bound(begin, end, n_points * part / share.n_parts) - begin;
    };
    loops_.cells(sorted, table, first_cell(share.part), first_cell(share.part + 1),
                 {&append, &pairs});
  }

  const PairLoops &loops_;
};
} // namespace

std::unique_ptr<PairSearch> make_linked_cells(const char *instruction_set)
{
  return std::make_unique<LinkedCells>(pair_loops(instruction_set));
}
} // namespace ricochet
