// SPDX-License-Identifier: LGPL-2.1-or-later
#include "projectiles/skin_stress.h"
#include "support/hexahedra.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(SkinStress, IsThatOfAPulledAndOfATurnedBlock)
{
  // Two fields instead of modes: a pull of strain 1e-3 with its contraction, and a small rotation.
  const HexSolid solid = block({4, 2, 2}, 1e-3, 0.1);
  const HexahedralBody body(solid, steel(), false);
  const Skin skin(solid, false);
  ASSERT_EQ(skin.faces.size(), 40U);
  FreeModes fields;
  fields.squared_frequency = {1., 1.};
  fields.shape.resize(2);
  for (const auto &X : solid.nodes)
  {
    const Vector3 pull(1e-3 * X.x(), -0.3e-3 * X.y(), -0.3e-3 * X.z());
    const Vector3 turn = Vector3(1e-3, 2e-3, -1e-3).cross(X);
    fields.shape[0].insert(fields.shape[0].end(), pull.data(), pull.data() + 3);
    fields.shape[1].insert(fields.shape[1].end(), turn.data(), turn.data() + 3);
  }
  SkinStress stress(body, skin);
  EXPECT_EQ(stress.von_mises(Eigen::VectorXd()).size(), 40U);
  stress.set_modes(body, fields, 2);
  for (const double found : stress.von_mises(Eigen::Vector2d(2., 5.)))
    EXPECT_NEAR(found, 2. * 202e6, 1e-9 * 202e6); // E times the strain
}
} // namespace
} // namespace ricochet::tests
