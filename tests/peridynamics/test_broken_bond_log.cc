// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <vector>

namespace ricochet::tests
{
namespace
{
using Bond = std::tuple<std::ptrdiff_t, std::size_t, std::ptrdiff_t, std::ptrdiff_t>;

/// Block, offset, points.
std::vector<Bond> logged(const BrokenBondLog &log)
{
  std::vector<Bond> bonds;
  log.for_each([&](const std::ptrdiff_t p, const std::ptrdiff_t q, const std::size_t k)
               { bonds.emplace_back(p / Lattice::block_size, k, p, q); });
  return bonds;
}

TEST(BrokenBondLog, HoldsEachBondThatWasIntactBeforeAndIsNotNow)
{
  for (const char *set_name : {"baseline", "avx2", "avx512"})
  {
    if (lattice_kernel(0, set_name) == nullptr)
      continue;
    BodySample sample;
    sample.n                = {9, 7, 8};
    sample.critical_stretch = 0.04;
    sample.instruction_set  = set_name;
    const auto body         = make_body(sample);
    const auto &stencil     = body->lattice().stencil();
    Random random(11);
    for (int step = 0; step < 2; ++step)
    {
      const auto all_intact = [&]
      {
        std::vector<Bond> bonds;
        for (std::ptrdiff_t p = 0; p < body->lattice().owned_end(); ++p)
          for (std::size_t k = 0; k < stencil.offsets.size(); ++k)
            if (is_intact(*body, p, k))
              bonds.emplace_back(p / Lattice::block_size, k, p,
                                 p + body->lattice().shift(stencil.offsets[k]));
        std::sort(bonds.begin(), bonds.end());
        return bonds;
      };
      const auto before = all_intact();
      deform(
          *body, [&](const Vector3 &X) -> Vector3 { return X + 0.03e-3 * random.vector(); },
          /*breaking=*/true);
      const auto after = all_intact();
      std::vector<Bond> gone;
      std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                          std::back_inserter(gone));
      EXPECT_GT(gone.size(), 50u);
      auto found = logged(body->bond_damage().log());
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, gone) << set_name << ", step " << step;
    }
  }
}

TEST(BrokenBondLog, IsEmptyAgainWhenNothingBreaks)
{
  BodySample sample;
  sample.n                = {2, 1, 1};
  sample.family           = {bond_law_samples[0], InfluenceFunction::constant, 1.};
  sample.critical_stretch = 0.01;
  const auto body         = make_body(sample);
  const auto p = body->lattice().index(0, 0, 0), q = body->lattice().index(1, 0, 0);
  const auto stretched = [](const double s)
  { return [s](const Vector3 &X) -> Vector3 { return (1. + s) * X; }; };
  deform(*body, stretched(0.02), /*breaking=*/true);
  const auto bonds = logged(body->bond_damage().log());
  ASSERT_EQ(bonds.size(), 1u);
  EXPECT_EQ(std::get<2>(bonds[0]), p);
  EXPECT_EQ(std::get<3>(bonds[0]), q);
  deform(*body, stretched(0.03), /*breaking=*/true);
  EXPECT_TRUE(body->bond_damage().log().empty());
  EXPECT_TRUE(logged(body->bond_damage().log()).empty());
}
} // namespace
} // namespace ricochet::tests
