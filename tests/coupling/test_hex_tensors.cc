// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coupling/hex_tensors.h"
#include "support/element_body.h"

#include "ricochet/base/voigt.h"

#include <gtest/gtest.h>

#include <numeric>

namespace ricochet::tests
{
namespace
{
constexpr std::array<int, 8> corners{0, 1, 2, 3, 4, 5, 6, 7};

GaussPointTensors random_tensors(const unsigned int seed)
{
  Random random(seed);
  GaussPointTensors tensors;
  for (auto &tensor : tensors)
    tensor = packed(random_tensor(random, 1.));
  return tensors;
}

TEST(HexTensors, PackingLosesNothing)
{
  Random random(5);
  const Matrix6 m = random_tensor(random, 1.);
  EXPECT_EQ(unpacked(packed(m)), m);
  StiffnessTensor y = packed(m);
  add(-1., packed(m), y);
  for (const double value : y)
    EXPECT_EQ(value, 0.);
}

TEST(HexTensors, UniformStressPullsAtCornersByAQuarterOfEachFace)
{
  // f = -sigma s/4 in units of M h^2, s = +-1 the side of the corner.
  const ElasticModuli moduli{3.7e9, 1.2e9};
  const Matrix6 C = cubic_stiffness(moduli, {1.1, 0.9});
  GaussPointTensors tensors;
  tensors.fill(packed(C));
  NodalForces forces(8);
  add_cube_forces(tensors, corners, forces);
  EXPECT_NEAR(cubic_stiffness(moduli, {})(0, 0), 1., 1e-15); // M
  EXPECT_NEAR(C(0, 0) - C(0, 1), 2.2 * 1.2e9 / 5.3e9, 1e-15);
  EXPECT_NEAR(C(5, 5), 0.9 * 1.2e9 / 5.3e9, 1e-15);
  for (int a = 0; a < 8; ++a)
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < n_unit_strains; ++k)
      {
        double expected = 0.;
        for (int d = 0; d < 3; ++d)
          expected -= ((a >> d) & 1 ? 0.25 : -0.25) * C(voigt::number[c][d], k);
        EXPECT_NEAR(forces[a][c][k], expected, 1e-15) << a << c << k;
      }
}

TEST(HexTensors, DescentIsMinusTheTransposeOfTheForces)
{
  // f . A(C) = -descent(f) . C for any forces and tensors.
  const auto tensors = random_tensors(7);
  NodalForces image(8), forces(8);
  add_cube_forces(tensors, corners, image);
  Random random(8);
  for (auto &force : forces)
    for (auto &lanes : force)
      for (int k = 0; k < n_unit_strains; ++k)
        lanes[k] = random.uniform();
  double on_nodes = 0., on_tensors = 0.;
  for (int a = 0; a < 8; ++a)
    for (int c = 0; c < 3; ++c)
      on_nodes += (forces[a][c] * image[a][c]).sum();
  const auto slope = descent(forces, corners);
  for (int g = 0; g < 8; ++g)
    on_tensors += std::inner_product(slope[g].begin(), slope[g].end(), tensors[g].begin(), 0.);
  EXPECT_NEAR(on_nodes, -on_tensors, 1e-13 * std::abs(on_nodes));
  EXPECT_GT(std::abs(on_nodes), 1e-3);
}
} // namespace
} // namespace ricochet::tests
