// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/lattice_state.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cstdint>
#include <cstdlib>
#include <vector>

namespace ricochet::tests
{
namespace
{
Lattice half_plate()
{
  return Lattice({Vector3(0., 2e-3, 0.), 1e-3, {7, 5, 6}, true},
                 make_stencil(1e-3, 3., InfluenceFunction::cone), 0, 1);
}

TEST(LatticeState, StartsAtRestInFieldsOfItsOwn)
{
  const Lattice lattice = half_plate();
  const LatticeState state(lattice);
  const auto &a = state.arrays;
  EXPECT_EQ(a.half_weight, nullptr);
  EXPECT_EQ(a.hold, nullptr);
  std::vector<double *> fields{a.theta, a.theta_before, a.energy};
  for (int d = 0; d < 3; ++d)
    fields.insert(fields.end(), {a.position[d], a.velocity[d], a.force[d]});
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(fields[i]) % 64, 0u) << "kernels load lines";
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(std::abs(fields[i] - fields[j]), lattice.size());
  }
  for (std::ptrdiff_t p = 0; p < lattice.size(); ++p)
  {
    const Vector3 X = lattice.reference_position(lattice.coordinates(p));
    for (int d = 0; d < 3; ++d)
    {
      ASSERT_EQ(a.position[d][p], X[d]);
      ASSERT_EQ(a.velocity[d][p], 0.);
    }
  }
}

TEST(LatticeState, ImagesMoveAsInTheMirror)
{
  const Lattice lattice = half_plate();
  LatticeState state(lattice);
  auto &a = state.arrays;
  Random random(7);
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        for (int d = 0; d < 3; ++d)
        {
          a.position[d][p] = random.uniform();
          a.velocity[d][p] = random.uniform();
        }
        a.theta[p] = random.uniform();
      });
  state.mirror_motion(lattice);
  state.mirror(lattice, a.theta);
  int n = 0;
  for (std::ptrdiff_t p = 0; p < lattice.size(); ++p)
    if (const auto c = lattice.coordinates(p); lattice.exists(p) && c[1] < 0)
    {
      const auto q = lattice.index(c[0], -1 - c[1], c[2]);
      for (int d = 0; d < 3; ++d)
      {
        const double sign = d == 1 ? -1. : 1., plane = d == 1 ? 2e-3 : 0.;
        ASSERT_DOUBLE_EQ(a.position[d][p] - plane, sign * (a.position[d][q] - plane));
        ASSERT_EQ(a.velocity[d][p], sign * a.velocity[d][q]);
      }
      ASSERT_EQ(a.theta[p], a.theta[q]);
      ++n;
    }
  EXPECT_EQ(n, 7 * 2 * 6);
}

TEST(LatticeState, TensorComponentsTurnAsInTheMirror)
{
  // M T M with M = diag(1, -1, 1).
  const Lattice lattice = half_plate();
  const LatticeState state(lattice);
  Eigen::Matrix3d T;
  T << 1., 2., 3., 2., 4., 5., 3., 5., 6.;
  const Eigen::Matrix3d M        = Eigen::Vector3d(1., -1., 1.).asDiagonal();
  const Eigen::Matrix3d mirrored = M * T * M;
  const int row[] = {0, 1, 2, 1, 0, 0}, column[] = {0, 1, 2, 2, 2, 1};
  for (int i = 0; i < 6; ++i)
  {
    std::vector<double> field(lattice.size(), 0.);
    field[lattice.index(3, 1, 2)] = T(row[i], column[i]);
    state.mirror_component(lattice, field.data(), i);
    EXPECT_EQ(field[lattice.index(3, -2, 2)], mirrored(row[i], column[i])) << i;
  }
}

TEST(LatticeState, PointsOfAZoneHaveItsWeights)
{
  const auto stencil = make_stencil(1e-3, 3., InfluenceFunction::cone);
  Zone zone({10, 6, 4}, stencil.reach, BlendFunction::linear, 2);
  zone.grow({{{0, 0, 0}, {3, 6, 4}}});
  Lattice lattice({Vector3::Zero(), 1e-3, {20, 12, 8}, false}, stencil, 0, 1, {}, &zone);
  LatticeState state(lattice);
  const auto expect_weights = [&](const double factor)
  {
    bool has_share = false;
    for (std::ptrdiff_t p = 0; p < lattice.size(); ++p)
      if (lattice.exists(p))
      {
        const auto c   = lattice.coordinates(p);
        const double w = zone.weight(c[0], c[1], c[2]);
        ASSERT_EQ(2. * state.arrays.half_weight[p], factor * w);
        ASSERT_EQ(state.arrays.hold[p] == 0., lattice.kind(p) == PointKind::free);
        has_share = has_share || (w > 0. && w < 1.);
      }
    EXPECT_TRUE(has_share);
  };
  expect_weights(1.);
  state.scale_weights(lattice, std::vector<double>(lattice.size(), 0.25));
  expect_weights(0.25);

  std::vector<double> ones(lattice.size(), 1.);
  state.weigh(lattice, ones.data());
  lattice.for_each_owned([&](const std::ptrdiff_t p)
                         { ASSERT_EQ(ones[p], 2. * state.arrays.half_weight[p]); });

  // Weights depend on the layers of neighbouring cells: all are found anew around what changed.
  zone.grow({{{3, 0, 0}, {4, 6, 4}}});
  lattice.follow_zone(0, 20);
  state.follow_zone(lattice, 0, 20);
  expect_weights(1.);
}
} // namespace
} // namespace ricochet::tests
