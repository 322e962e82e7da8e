// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists the pairs of one body's points whose bond has parted and that may touch.
#pragma once

#include "pair_list.h"
#include "ricochet/peridynamics/peridynamic_body.h"

namespace ricochet
{
class BrokenBondPairs
{
public:
  struct Pair
  {
    std::int32_t p, q; // flat indices
    double distance;   // at which they touch [m]
  };

  /// The body must outlive this object.
  explicit BrokenBondPairs(const PeridynamicBody &body);

  /// Lists all that may touch before either has left its skin, anew. `skin`: per entry of the
  /// lattice's fields [m].
  void list(const std::vector<double> &skin);
  /// Adds those whose bond the last evaluation has let part.
  void add_newly_parted();
  /// Adds a point and the one at the end of its bond number `offset`, if that has parted.
  void add(std::ptrdiff_t p, std::size_t offset);

  const PairList<Pair> &pairs() const { return list_; }

private:
  const PeridynamicBody &body_;
  std::vector<double> distance_;     // per offset [m]
  std::vector<std::size_t> offsets_; // in ascending order of their shift
  PairList<Pair> list_;
};
} // namespace ricochet
