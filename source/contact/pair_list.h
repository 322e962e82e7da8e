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

/// Finds the listed pairs that touch: returns how many, their numbers stand at the beginning of
/// `touching`, ascending and each pair once, whenever it was listed. `touch(pair)` says whether it
/// does, `before(pair, pair)` orders them.
template <class Pair, class Touch, class Before>
std::ptrdiff_t find_touching(const PairList<Pair> &list, Touch &&touch, Before &&before,
                             std::vector<std::int32_t> &touching)
{
  const auto &pairs = list.pairs;
  if (touching.size() < pairs.size())
    touching.resize(pairs.size());
  std::ptrdiff_t n = 0;
  const auto find  = [&](const std::size_t first, const std::size_t last)
  {
    // Few touch: written down in any case, and over it if not, so that nothing branches.
    for (std::size_t i = first; i < last; ++i)
    {
      touching[n] = static_cast<std::int32_t>(i);
      n += touch(pairs[i]);
    }
  };
  find(0, list.n_sorted);
  const auto begin = touching.begin(), middle = begin + n;
  find(list.n_sorted, pairs.size());
  const auto end = begin + n;

  const auto less = [&](const std::int32_t i, const std::int32_t j)
  { return before(pairs[i], pairs[j]); };
  std::sort(middle, end, less);
  std::inplace_merge(begin, middle, end, less);
  return std::unique(begin, end,
                     [&](const std::int32_t i, const std::int32_t j) { return !less(i, j); }) -
         begin;
}
} // namespace ricochet
