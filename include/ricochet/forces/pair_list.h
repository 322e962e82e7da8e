// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs that may touch, and those of them that do, in one order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ricochet
{
/// The first n_sorted pairs ascend, each stands there once; those behind them have been added
/// since, and may stand there twice.
template <class Pair>
struct PairList
{
  std::vector<Pair> pairs;
  std::size_t n_sorted = 0;
};

/// Numbers of the listed pairs that touch, ascending and each pair once, whenever it was listed.
/// `touch(pair)` says whether it does, `before(pair, pair)` orders them.
template <class Pair, class Touch, class Before>
void find_touching(const PairList<Pair> &list, Touch &&touch, Before &&before,
                   std::vector<std::int32_t> &touching)
{
  const auto &pairs = list.pairs;
  touching.resize(pairs.size());
  std::size_t n   = 0;
  const auto find = [&](const std::size_t first, const std::size_t last)
  {
    // Few touch: written down in any case, and over it if not, so that nothing branches.
    for (std::size_t i = first; i < last; ++i)
    {
      touching[n] = static_cast<std::int32_t>(i);
      n += touch(pairs[i]);
    }
  };
  find(0, list.n_sorted);
  const auto n_sorted = static_cast<std::ptrdiff_t>(n);
  find(list.n_sorted, pairs.size());
  touching.resize(n);

  const auto less = [&](const std::int32_t i, const std::int32_t j)
  { return before(pairs[i], pairs[j]); };
  const auto middle = touching.begin() + n_sorted;
  std::sort(middle, touching.end(), less);
  std::inplace_merge(touching.begin(), middle, touching.end(), less);
  touching.erase(std::unique(touching.begin(), touching.end(),
                             [&](const std::int32_t i, const std::int32_t j)
                             { return !less(i, j); }),
                 touching.end());
}
} // namespace ricochet
