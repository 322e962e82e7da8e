// SPDX-License-Identifier: LGPL-2.1-or-later
#include "broken_bond_pairs.h"

#include "contact_distance.h"

#include <numeric>

namespace ricochet
{
BrokenBondPairs::BrokenBondPairs(const PeridynamicBody &body) : body_(body)
{
  const auto &stencil = body.lattice().stencil();
  for (const auto &offset : stencil.offsets)
    distance_.push_back(contact_distance(offset.length, stencil.spacing));
  offsets_.resize(stencil.offsets.size());
  std::iota(offsets_.begin(), offsets_.end(), 0);
  const auto shift = [&](const std::size_t k) { return body.lattice().shift(stencil.offsets[k]); };
  std::sort(offsets_.begin(), offsets_.end(),
            [&](const std::size_t k, const std::size_t l) { return shift(k) < shift(l); });
}

void BrokenBondPairs::list(const std::vector<double> &skin)
{
  constexpr int width          = Lattice::block_size;
  const Lattice &l             = body_.lattice();
  const double *const *const x = body_.state().arrays.position;
  std::vector<Pair> of_lane[width];
  list_.pairs.clear();
  for (const auto &range : l.existing_ranges())
    for (std::int64_t block = range.first;
         block < std::min<std::int64_t>(range.last, l.owned_end() / width); ++block)
    {
      const std::ptrdiff_t p = block * width;
      for (const std::size_t k : offsets_)
      {
        const unsigned int parted = body_.parted_bonds(block, k);
        if (parted == 0)
          continue;
        const std::ptrdiff_t q = p + l.shift(l.stencil().offsets[k]);
        // All eight together, without branches.
        double excess[width];
        for (int lane = 0; lane < width; ++lane)
        {
          const double dx = x[0][q + lane] - x[0][p + lane], dy = x[1][q + lane] - x[1][p + lane],
                       dz    = x[2][q + lane] - x[2][p + lane],
                       limit = distance_[k] + skin[p + lane] + skin[q + lane];
          excess[lane]       = dx * dx + dy * dy + dz * dz - limit * limit;
        }
        for (int lane = 0; lane < width; ++lane)
          if ((parted >> lane) & 1 && excess[lane] < 0.)
            of_lane[lane].push_back({static_cast<std::int32_t>(p + lane),
                                     static_cast<std::int32_t>(q + lane), distance_[k]});
      }
      for (auto &pairs : of_lane)
      {
        list_.pairs.insert(list_.pairs.end(), pairs.begin(), pairs.end());
        pairs.clear();
      }
    }
  list_.n_sorted = list_.pairs.size();
}

void BrokenBondPairs::add_newly_parted()
{
  body_.for_each_newly_parted_bond(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const std::size_t k)
      {
        list_.pairs.push_back(
            {static_cast<std::int32_t>(p), static_cast<std::int32_t>(q), distance_[k]});
      });
}

void BrokenBondPairs::add(const std::ptrdiff_t p, const std::size_t offset)
{
  if ((body_.parted_bonds(p / Lattice::block_size, offset) >> (p % Lattice::block_size)) & 1)
    list_.pairs.push_back(
        {static_cast<std::int32_t>(p),
         static_cast<std::int32_t>(
             p + body_.lattice().shift(body_.lattice().stencil().offsets[offset])),
         distance_[offset]});
}
} // namespace ricochet
