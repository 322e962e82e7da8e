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

TEST(BondDamage, SeveredBondsAreDamageThatReleasesNothing)
{
  BodySample sample;
  sample.n           = {8, 7, 7};
  const auto body    = make_body(sample);
  const double n     = body->count_bonds();
  const auto crosses = [](const Vector3 &X, const Vector3 &Y)
  { return (X.x() < 4e-3) != (Y.x() < 4e-3); };
  const double n_ends = body->sever(crosses);
  EXPECT_EQ(body->count_sound_bonds(), n);
  EXPECT_EQ(body->count_bonds(), n - 0.5 * n_ends);
  EXPECT_EQ(body->n_broken_bonds(), 0.);
  // As many planes of points lie before the crack as a bond is long along x.
  double expected = 0.;
  for (const auto &o : body->lattice().stencil().offsets)
    expected += std::abs(o.x) * (7 - std::abs(o.y)) * (7 - std::abs(o.z));
  EXPECT_EQ(0.5 * n_ends, expected);
  const double reach = body->lattice().stencil().reach * sample.spacing;
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   const bool near = std::abs(reference(*body, p).x() - 4e-3) < reach;
                   EXPECT_EQ(body->is_damaged(p), near);
                   EXPECT_EQ(body->is_open(p), near);
                   EXPECT_EQ(body->damage(p) > 0., near);
                 });
  // The two halves part without a force.
  deform(*body,
         [&](const Vector3 &X) -> Vector3
         { return X.x() < 4e-3 ? X : Vector3(X + Vector3(1e-3, 2e-3, 0.)); });
  EXPECT_LT(largest_force(*body), 1e-9 * sample.family.law.bulk_modulus * 1e-6);
  EXPECT_EQ(body->sever(crosses), 0.) << "broken already";
}

TEST(BondDamage, PointsAtTheRimOfAHoleAreOpenAndNotDamaged)
{
  for (const bool half : {false, true})
  {
    BodySample sample;
    sample.mirror_y = half;
    sample.mask     = [half](const int x, const int y, int)
    { return x < 3 || x > 4 || (half ? y > 1 : y < 3 || y > 4); };
    const auto body = make_body(sample);
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     const auto c = body->lattice().coordinates(p);
                     const bool at_rim =
                         c[0] >= 2 && c[0] <= 5 && (half ? c[1] <= 2 : c[1] >= 2 && c[1] <= 5);
                     EXPECT_EQ(body->is_open(p), at_rim) << c[0] << " " << c[1];
                     EXPECT_FALSE(body->is_damaged(p));
                     EXPECT_EQ(body->damage(p), 0.);
                   });
  }
}
} // namespace
} // namespace ricochet::tests
