// SPDX-License-Identifier: LGPL-2.1-or-later
// Interface of a search for all pairs of points closer than a radius, and the menu of methods. All
// methods find exactly the same pairs: |x_a - x_b|^2 < radius^2 in double precision.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/search/families.h"

#include <memory>
#include <string>
#include <vector>

namespace ricochet
{
/// What a search knows of its points.
struct SearchPoints
{
  const std::vector<Vector3> &position; // [m]
  const std::vector<char> &active;      // as in PairSearch::find()
  const Families &families;             // likewise
};

/// Part number `part` of `n_parts` parts of the work, which together find every pair once. Each
/// needs all points.
struct SearchShare
{
  int part    = 0; // counted from 0
  int n_parts = 1; // in all
};

class PairSearch
{
public:
  virtual ~PairSearch() = default;

  /**
   * All pairs of points closer than the radius, each once, in no particular order.
   *
   * @param points   Positions [m], fewer than 2^31. One that is not finite is close to none.
   * @param active   One entry per point: pairs of two points that are both not active are of no
   *                 interest. Empty: all are active.
   * @param radius   > 0 [m]; a pair exactly that far apart is none.
   * @param pairs    Is overwritten; what it has allocated is used again.
   * @param share    Only this part of the pairs.
   * @param families Pairs within one are left out.
   */
  void find(const std::vector<Vector3> &points, const std::vector<char> &active, double radius,
            std::vector<PointPair> &pairs, SearchShare share = {},
            const Families &families = {}) const;

private:
  virtual void search(const SearchPoints &points, double radius, SearchShare share,
                      std::vector<PointPair> &pairs) const = 0;
};

/// One line of the menu.
struct PairSearchEntry
{
  const char *name;                      // in parameter files
  std::unique_ptr<PairSearch> (*make)(); // a new one
};

/// The menu, the fastest first.
const std::vector<PairSearchEntry> &pair_searches();

/// The method of that name. Throws InputError for an unknown one.
std::unique_ptr<PairSearch> make_pair_search(const std::string &name);

/// Compares every point with every other one. `instruction_set` as in pair_loops(); throws
/// InputError if the processor lacks it.
std::unique_ptr<PairSearch> make_brute_force(const char *instruction_set = nullptr);
/// Compares points in neighbouring cells of a grid, see search/cell_grid.h. Likewise.
std::unique_ptr<PairSearch> make_linked_cells(const char *instruction_set = nullptr);
/// Asks a KD-tree (nanoflann) for the neighbours of each point. Points are sorted into cells first:
/// then tree and queries walk through memory in order.
std::unique_ptr<PairSearch> make_kd_tree();
} // namespace ricochet
