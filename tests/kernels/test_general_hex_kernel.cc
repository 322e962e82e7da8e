// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/hexahedra.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
class GeneralHexKernelOn : public testing::TestWithParam<const char *>
{
protected:
  void SetUp() override
  {
    if (general_hex_kernel(GetParam()) == nullptr)
      GTEST_SKIP() << "this processor has no " << GetParam();
    options_.instruction_set = GetParam();
  }
  HexahedralBody::Options options_;
};

INSTANTIATE_TEST_SUITE_P(Sets, GeneralHexKernelOn, testing::Values("baseline", "avx2", "avx512"),
                         [](const auto &info) { return std::string(info.param); });

double largest(const HexahedralBody &body)
{
  double force = 0.;
  for (int node = 0; node < body.n_nodes(); ++node)
    force = std::max(force, node_of(body.force(), node).norm());
  return force;
}

const Eigen::Matrix3d stretched =
    (Eigen::Matrix3d() << 1.01, 0.004, -0.002, 0.003, 0.995, 0.006, 0.001, -0.005, 1.004)
        .finished();

TEST_P(GeneralHexKernelOn, LinearMotionOfDistortedElementsHasExactEnergyAndNoHourglass)
{
  // The patch test: with 19 x ... cells the last block is not full.
  const auto solid = distorted_block({3, 3, 3}, 1e-3, 0.2);
  HexahedralBody body(solid, steel(), false, options_);
  deform(body, [&](const Vector3 &X) -> Vector3 { return stretched * X + Vector3(0.1, 0.2, 0.3); });
  const double mu = steel().shear_modulus, lambda = steel().bulk_modulus - mu / 1.5;
  const Eigen::Matrix3d E = 0.5 * (stretched.transpose() * stretched - Eigen::Matrix3d::Identity());
  const double density    = 0.5 * lambda * E.trace() * E.trace() + mu * (E * E).trace(); // [J/m^3]
  const auto energies     = body.energies(0.);
  EXPECT_NEAR(energies.strain, density * volume(solid), 1e-10 * density * volume(solid));
  EXPECT_LT(energies.hourglass, 1e-20 * energies.strain);
}

TEST_P(GeneralHexKernelOn, LinearMotionLeavesInnerNodesWithoutForce)
{
  HexahedralBody body(distorted_block({4, 3, 3}, 1e-3, 0.2), steel(), false, options_);
  deform(body, [&](const Vector3 &X) -> Vector3 { return stretched * X; });
  const double typical = largest(body);
  int n_inner          = 0;
  const auto plain     = block({4, 3, 3}, 1e-3);
  for (int node = 0; node < body.n_nodes(); ++node)
  {
    const Vector3 c = plain.nodes[node] / 1e-3;
    if (c.x() > 0.5 && c.x() < 3.5 && c.y() > 0.5 && c.y() < 2.5 && c.z() > 0.5 && c.z() < 2.5)
    {
      ++n_inner;
      EXPECT_LT(node_of(body.force(), node).norm(), 1e-11 * typical);
    }
  }
  EXPECT_EQ(n_inner, 12);
}

TEST_P(GeneralHexKernelOn, RotatedBodyHasNoForce)
{
  HexahedralBody body(distorted_block({3, 2, 3}, 1e-3, 0.2), steel(), false, options_);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.1, Vector3(1., 2., -1.).normalized()));
  deform(body, [&](const Vector3 &X) -> Vector3 { return turn * X; });
  // Rounding of F, 1e-16, times E times the area of a face.
  EXPECT_LT(largest(body), 1e-14 * 202e9 * 1e-6);
}

TEST_P(GeneralHexKernelOn, ForceIsMinusTheGradientOfTheEnergyAndHasNoNetMoment)
{
  HexahedralBody body(distorted_block({2, 3, 2}, 1e-3, 0.2), steel(), false, options_);
  Random random(3);
  for (double &x : body.position())
    x += 0.02e-3 * random.uniform();
  const auto energy = [&]
  {
    body.compute_internal_forces({true});
    const auto e = body.energies(0.);
    return e.strain + e.hourglass;
  };
  energy();
  const auto force = body.force();
  Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
  double total = 0.;
  for (int node = 0; node < body.n_nodes(); ++node)
  {
    sum += node_of(force, node);
    moment += node_of(body.position(), node).cross(node_of(force, node));
    total += node_of(force, node).norm();
  }
  EXPECT_LT(sum.norm(), 1e-13 * total);
  EXPECT_LT(moment.norm(), 1e-13 * total * 3e-3);
  const double h = 1e-9;
  for (std::size_t i = 0; i < force.size(); i += 5)
  {
    const double x     = body.position()[i];
    body.position()[i] = x + h;
    const double up    = energy();
    body.position()[i] = x - h;
    const double down  = energy();
    body.position()[i] = x;
    EXPECT_NEAR(force[i], -(up - down) / (2. * h), 1e-5 * total / body.n_nodes());
  }
}

TEST_P(GeneralHexKernelOn, IsTheOnePointElementOnCubes)
{
  // E h/48 and E h/144 are the hourglass coefficients of finite_elements/finite_element_body.h.
  const double h = 1e-3, E = 202e9;
  HexahedralBody body(block({1, 1, 1}, h), steel(), false, options_);
  Random random(5);
  for (double &x : body.position())
    x += 0.05 * h * random.uniform();
  body.compute_internal_forces({true});

  HexBlock cube{};
  for (int lane = 0; lane < 8; ++lane)
  {
    for (int a = 0; a < 8; ++a)
      cube.entry[a][lane] = 3 * body.solid().cells[0][a];
    cube.edge[lane] = h;
  }
  std::vector<double> force(24, 0.);
  double strain, hourglass;
  const double mu = steel().shear_modulus, lambda = steel().bulk_modulus - mu / 1.5;
  hex_kernel(GetParam())
      ->one_point_and_energy({body.position().data(), force.data(), &strain, &hourglass},
                             {&cube, nullptr, 1, lambda, mu, mu, E / 48., E / 144.});
  const auto e = body.energies(0.);
  EXPECT_NEAR(e.strain, strain, 1e-12 * strain);
  EXPECT_NEAR(e.hourglass, hourglass, 1e-12 * hourglass);
  const double typical = largest(body);
  for (int i = 0; i < 24; ++i)
    EXPECT_NEAR(body.force()[i], force[i], 1e-12 * typical);
}

TEST_P(GeneralHexKernelOn, BendsLikeTheFullyIntegratedElementWithoutItsLocking)
{
  // Pure bending of parallelepipeds: u_x = kappa x z, u_z = -kappa x^2/2. The hourglass stiffness
  // is made so that a cube stores exactly E kappa^2 I/2; the full element, which cannot contract
  // across nor bend its faces, stores lambda + 2 mu (= E (1 - nu)/(1 + nu)/(1 - 2 nu)) plus mu
  // instead of E.
  const double h = 1e-3, kappa = 0.1, E = 202e9, nu = 0.3;
  HexSolid solid   = block({1, 1, 1}, h, 0., Vector3::Constant(-h / 2.));
  const auto shear = (Eigen::Matrix3d() << 1., 0.2, 0., 0., 1., 0.1, 0., 0., 1.).finished();
  for (const bool sheared : {false, true})
  {
    if (sheared)
      for (auto &x : solid.nodes)
        x = shear * x;
    HexahedralBody body(solid, elastic(E, nu, 7850.), false, options_);
    const auto bend = [&](const Vector3 &X) -> Vector3
    { return X + kappa * Vector3(X.x() * X.z(), 0., -0.5 * X.x() * X.x()); };
    deform(body, bend);
    Eigen::Matrix<double, 3, 8> X, x;
    for (int a = 0; a < 8; ++a)
    {
      X.col(a) = solid.nodes[solid.cells[0][a]];
      x.col(a) = bend(X.col(a));
    }
    const double mu = E / 2. / (1. + nu), lambda = E * nu / (1. + nu) / (1. - 2. * nu);
    const auto e       = body.energies(0.);
    const double exact = 0.5 * E * kappa * kappa * std::pow(h, 5) / 12.;
    const double full  = FullyIntegrated(X, x, lambda, mu).energy;
    if (!sheared)
    {
      EXPECT_NEAR(e.strain + e.hourglass, exact, 1e-4 * exact);
      EXPECT_NEAR(full, (lambda + 3. * mu) / E * exact, 1e-3 * exact);
    }
    // On a sheared element the same numbers within what its shape changes.
    EXPECT_NEAR(e.strain + e.hourglass, exact, 0.2 * exact);
    EXPECT_GT(full, e.strain + e.hourglass);
  }
}

TEST_P(GeneralHexKernelOn, ApproachesTheFullyIntegratedElementsOfASmoothMotion)
{
  // Energies of a smooth motion of distorted meshes agree to second order in h.
  double difference[2];
  for (int level = 0; level < 2; ++level)
  {
    const int n      = level == 0 ? 4 : 8;
    const double h   = 8e-3 / n;
    const auto solid = block({n, n, n}, h, 0.15);
    HexahedralBody body(solid, steel(), false, options_);
    const auto wave = [](const Vector3 &X) -> Vector3
    {
      return X + 1e-6 * Vector3(std::sin(300. * X.y()), std::cos(250. * X.z()),
                                std::sin(200. * X.x() + 150. * X.y()));
    };
    deform(body, wave);
    double full     = 0.;
    const double mu = steel().shear_modulus, lambda = steel().bulk_modulus - mu / 1.5;
    for (const auto &cell : solid.cells)
    {
      Eigen::Matrix<double, 3, 8> X, x;
      for (int a = 0; a < 8; ++a)
      {
        X.col(a) = solid.nodes[cell[a]];
        x.col(a) = wave(X.col(a));
      }
      full += FullyIntegrated(X, x, lambda, mu).energy;
    }
    const auto e      = body.energies(0.);
    difference[level] = std::abs(e.strain + e.hourglass - full) / full;
  }
  EXPECT_LT(difference[0], 0.1);
  EXPECT_LT(difference[1], 0.35 * difference[0]);
}
} // namespace
} // namespace ricochet::tests
