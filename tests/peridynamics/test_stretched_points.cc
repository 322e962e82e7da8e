// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace ricochet::tests
{
namespace
{
TEST(StretchedPoints, AreThoseWithAnOutgoingBondBeyondTheStretch)
{
  BodySample sample;
  sample.n                = {9, 8, 7};
  sample.critical_stretch = 0.2; // nothing breaks
  const auto body         = make_body(sample);
  const auto &lattice     = body->lattice();
  const auto &offsets     = lattice.stencil().offsets;
  Random random(19);
  deform(*body, [&](const Vector3 &X) -> Vector3 { return X + 0.03e-3 * random.vector(); });
  const auto &a = body->state().arrays;
  const std::vector<std::uint8_t> bonds(a.bonds, a.bonds + lattice.size() / 8 * offsets.size());
  const std::vector<double> theta(a.theta, a.theta + lattice.size());

  // Only the middle third of the blocks is asked for.
  const std::int64_t n_blocks = lattice.size() / Lattice::block_size;
  const Lattice::BlockRange middle{n_blocks / 3, 2 * n_blocks / 3};
  for (const double stretch : {0.03, 0.04, 1.})
  {
    std::set<std::ptrdiff_t> expected;
    for (auto p = middle.first * Lattice::block_size; p < middle.last * Lattice::block_size; ++p)
      for (std::size_t k = 0; k < offsets.size(); ++k)
        if (is_intact(*body, p, k))
        {
          const auto q = p + lattice.shift(offsets[k]);
          if ((position(*body, q) - position(*body, p)).norm() > (1. + stretch) * offsets[k].length)
            expected.insert(p);
        }
    const auto found = body->points_stretched(stretch, {middle});
    EXPECT_EQ(std::set<std::ptrdiff_t>(found.begin(), found.end()), expected) << stretch;
    EXPECT_EQ(expected.empty(), stretch == 1.);
  }
  EXPECT_TRUE(std::equal(bonds.begin(), bonds.end(), a.bonds));
  EXPECT_TRUE(std::equal(theta.begin(), theta.end(), a.theta));
  EXPECT_TRUE(body->bond_damage().log().empty());
}
} // namespace
} // namespace ricochet::tests
