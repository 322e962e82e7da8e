// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/body.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace ricochet::tests
{
namespace
{
TEST(BondDamage, PointTornOutLosesItsFamilyAndItsNeighboursOneBondEach)
{
  BodySample sample;
  sample.n                = {7, 7, 7};
  sample.critical_stretch = 0.5;
  const auto body         = make_body(sample);
  const auto &damage      = body->bond_damage();
  const auto &lattice     = body->lattice();
  const auto center       = lattice.index(3, 3, 3);
  const double n          = damage.count_intact(MPI_COMM_SELF);
  EXPECT_EQ(damage.count_sound(MPI_COMM_SELF), n);
  const Vector3 X = reference(*body, center);
  deform(
      *body,
      [&](const Vector3 &Y) -> Vector3 { return Y == X ? Vector3(Y + Vector3(0., 0., 1.)) : Y; },
      /*breaking=*/true);

  std::set<std::pair<std::ptrdiff_t, std::size_t>> gone;
  damage.for_each_broken_bond(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const std::size_t k)
      {
        EXPECT_TRUE(p == center || q == center);
        EXPECT_EQ(q - p, lattice.shift(lattice.stencil().offsets[k]));
        EXPECT_TRUE((damage.broken_bonds(p / 8, k) >> (p % 8)) & 1);
        EXPECT_TRUE(gone.insert({p, k}).second);
      });
  const std::size_t family = 2 * lattice.stencil().offsets.size();
  EXPECT_EQ(gone.size(), family); // the center is far from all surfaces
  EXPECT_EQ(damage.count_intact(MPI_COMM_SELF), n - double(family));
  EXPECT_EQ(damage.count_sound(MPI_COMM_SELF), n);

  EXPECT_EQ(damage.damage(center), 1.);
  int n_damaged = 0;
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   const double distance = (reference(*body, p) - X).norm();
                   const bool is_near    = distance < 2.9 * sample.spacing; // the cone ends at 3
                   EXPECT_EQ(damage.is_damaged(p), is_near);
                   n_damaged += is_near;
                   if (p == center)
                     return;
                   EXPECT_EQ(damage.damage(p) > 0., is_near);
                 });
  EXPECT_EQ(n_damaged, int(family) + 1);
  // A neighbour whose own family is whole loses one of all.
  EXPECT_NEAR(damage.damage(lattice.index(3, 3, 4)), 1. / double(family), 1e-15);
}

TEST(BondDamage, GrowingZoneAddsSoundBondsAndHealsNone)
{
  const auto stencil = make_stencil(1e-3, 3., InfluenceFunction::cone);
  const Lattice::Box box{Vector3::Zero(), 1e-3, {24, 16, 8}, false};
  const Zone::Cells first{{1, 2, 0}, {4, 6, 4}}, more{{4, 2, 0}, {7, 6, 4}};
  Zone zone({12, 8, 4}, stencil.reach);
  zone.grow({first});
  Lattice lattice(box, stencil, 0, 1, {}, &zone);
  LatticeState state(lattice);
  const auto &kernel = *lattice_kernel(0);
  BondDamage damage(lattice, state, kernel);
  const auto before = damage.sound_bonds();

  // One bond of each block breaks, by hand.
  std::set<std::pair<std::ptrdiff_t, std::size_t>> broken;
  const std::size_t n = stencil.offsets.size();
  for (std::size_t i = 5; i < before.size(); i += n)
    if (before[i] != 0)
    {
      const std::uint8_t lowest = before[i] & -before[i];
      state.arrays.bonds[i] &= static_cast<std::uint8_t>(~lowest);
      broken.insert({i / n, lowest});
    }
  ASSERT_GT(broken.size(), 20u);
  const auto all_broken = [&]
  {
    std::set<std::pair<std::ptrdiff_t, std::size_t>> found;
    damage.for_each_broken_bond(
        [&](const std::ptrdiff_t p, std::ptrdiff_t, const std::size_t k)
        {
          EXPECT_EQ(k, 5u);
          found.insert({p / 8, std::size_t(1) << (p % 8)});
        });
    return found;
  };
  EXPECT_EQ(all_broken(), broken);

  ASSERT_TRUE(zone.grow({more}));
  lattice.follow_zone(0, 24);
  state.follow_zone(lattice, 0, 24);
  const auto appeared = damage.follow_zone(0, 24, state);
  EXPECT_EQ(all_broken(), broken);
  const Lattice grown(box, stencil, 0, 1, {}, &zone);
  EXPECT_EQ(damage.sound_bonds(), grown.intact_bonds());
  std::size_t n_appeared = 0;
  ASSERT_EQ(appeared.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    ASSERT_EQ(appeared[i], damage.sound_bonds()[i] & ~before[i]);
    ASSERT_EQ(appeared[i] & ~state.arrays.bonds[i], 0) << "new bonds are intact";
    n_appeared += appeared[i] != 0;
  }
  EXPECT_GT(n_appeared, 1000u);
}
} // namespace
} // namespace ricochet::tests
