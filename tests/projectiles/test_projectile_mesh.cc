// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "ricochet/projectiles/projectile_mesh.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(ProjectileMesh, IsGeneratedOrThatOfTheScene)
{
  Scene scene = deformable(small_scene());
  const BodyOfRevolution body(scene.projectile.shape);
  EXPECT_EQ(given_mesh(scene).cells, revolved_hexes(body, 1).cells);
  scene.projectile.mesh = revolved_hexes(body, 2);
  EXPECT_EQ(given_mesh(scene).cells, scene.projectile.mesh.cells);
  EXPECT_EQ(projectile_mesh(scene).cells, scene.projectile.mesh.cells);
}

TEST(ProjectileMesh, OfASymmetricSceneIsTheSameHalfOfAWholeAndOfAHalf)
{
  Scene scene          = deformable(symmetric(small_scene()));
  const HexSolid whole = revolved_hexes(BodyOfRevolution(scene.projectile.shape), 1);
  EXPECT_FALSE(is_half(given_mesh(scene)));
  const HexSolid computed = projectile_mesh(scene);
  EXPECT_TRUE(is_half(computed));
  EXPECT_NEAR(volume(computed), 0.5 * volume(whole), 1e-12 * volume(whole));
  scene.projectile.mesh = computed;
  EXPECT_TRUE(is_half(given_mesh(scene)));
  const HexSolid again = projectile_mesh(scene);
  EXPECT_EQ(again.cells, computed.cells);
  for (std::size_t node = 0; node < computed.nodes.size(); ++node)
    EXPECT_LT((again.nodes[node] - computed.nodes[node]).norm(), 1e-15);
}

TEST(ProjectileMesh, HalfOfItInAWholeSceneOrTurnedRoundIsRefused)
{
  Scene scene           = deformable(symmetric(small_scene()));
  scene.projectile.mesh = projectile_mesh(scene);
  scene.symmetric       = false;
  EXPECT_THROW(projectile_mesh(scene), InputError);
  scene                 = deformable(small_scene());
  scene.projectile.mesh = revolved_hexes(BodyOfRevolution(scene.projectile.shape), 1);
  for (auto &x : scene.projectile.mesh.nodes)
    x.head<2>() *= -1.;
  EXPECT_THROW(projectile_mesh(scene), InputError);
  scene.symmetric = true;
  EXPECT_THROW(projectile_mesh(scene), InputError);
}
} // namespace
} // namespace ricochet::tests
