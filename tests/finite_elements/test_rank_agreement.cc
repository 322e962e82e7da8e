// SPDX-License-Identifier: LGPL-2.1-or-later
// Several ranks compute what one rank computes, to the last bit.
#include "support/element_body.h"

#include "ricochet/dynamics/largest_frequency.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
struct RankCase
{
  Quadrature quadrature;
  bool relaxing;
};

class RankAgreement : public testing::TestWithParam<RankCase>
{
};
INSTANTIATE_TEST_SUITE_P(
    Both, RankAgreement,
    testing::Values(RankCase{Quadrature::one_point, false}, RankCase{Quadrature::full, false},
                    RankCase{Quadrature::one_point, true}, RankCase{Quadrature::full, true}),
    [](const auto &info)
    {
      return std::string(info.param.quadrature == Quadrature::one_point ? "OnePoint" : "Full") +
             (info.param.relaxing ? "Relaxing" : "");
    });

TEST_P(RankAgreement, AMovingRefinedBodyWithAMirrorPlane)
{
  FiniteElementBody::Options options;
  options.quadrature = GetParam().quadrature;
  options.active     = [](const Vector3 &X) // a corner is missing
  { return X.x() < 2e-3 || X.y() < 2e-3 || X.z() < 3e-3; };
  auto box      = refined_box();
  box.mirror_y  = true;
  auto material = pmma();
  if (GetParam().relaxing)
    material.relaxation = {{0.3, 3e-6}, {0.3, 0.5e-6}};
  FiniteElementBody together(MPI_COMM_WORLD, box, material, options);
  FiniteElementBody alone(MPI_COMM_SELF, box, material, options);
  const double h = 0.25e-3; // the smallest edge

  const auto frequency = frequency_bound(MPI_COMM_WORLD, together);
  const auto expected  = frequency_bound(MPI_COMM_SELF, alone);
  EXPECT_EQ(frequency.squared_frequency, expected.squared_frequency);
  EXPECT_EQ(together.total_mass(), alone.total_mass());

  const double dt  = 0.7 * 2. / std::sqrt(expected.squared_frequency);
  const auto start = [&](const Vector3 &X) -> Vector3
  {
    const Vector3 noise = noise_at(X, 1e-3);
    return X + 0.05 * h * Vector3(noise.x(), X.y() == 0. ? 0. : noise.y(), noise.z());
  };
  for (auto *body : {&together, &alone})
  {
    // Some elements with their own tensors, chosen by place.
    std::vector<ElementStiffness> stiffness;
    for (std::size_t e = 0; e < body->mesh().elements().size(); ++e)
      if (const Vector3 X = body->mesh().centre(body->mesh().elements()[e]);
          X.x() > 0. && X.x() < 1e-3)
      {
        stiffness.push_back({static_cast<int>(e), {}});
        Random random(30);
        for (auto &tensor : stiffness.back().tensors)
          tensor = upper_triangle(random_tensor(random, 1e8)); // softer than the material
        stiffness.back().shear.fill(upper_triangle(1e6 * Matrix6::Identity()));
      }
    body->set_stiffness(stiffness);
    body->start_relaxation(dt);
    deform(*body, start);
    for (int step = 0; step < 200; ++step)
    {
      body->advance(step == 0 ? 0.5 * dt : dt, dt);
      body->update_ghosts();
      body->compute_internal_forces({step == 199});
    }
  }

  std::map<std::array<long, 3>, int> number;
  const auto key = [&](const Vector3 &X) -> std::array<long, 3> {
    return {std::lround(X.x() / h), std::lround(X.y() / h), std::lround(X.z() / h)};
  };
  for (int node = 0; node < alone.mesh().n_nodes(); ++node)
    number[key(alone.mesh().reference_position(node))] = node;
  double moved = 0.;
  // Ghosts and hanging nodes too: they are what later floors interpolate from.
  for (int node = 0; node < together.mesh().n_nodes(); ++node)
  {
    const Vector3 X = together.mesh().reference_position(node);
    const int other = number.at(key(X));
    EXPECT_EQ(at(together.position(), node), at(alone.position(), other));
    EXPECT_EQ(at(together.velocity(), node), at(alone.velocity(), other));
    moved = std::max(moved, (at(together.position(), node) - start(X)).norm());
  }
  MPI_Allreduce(MPI_IN_PLACE, &moved, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  EXPECT_GT(moved, 0.02 * h);

  const auto e = together.energies(dt), f = alone.energies(dt);
  EXPECT_EQ(e.kinetic, f.kinetic);
  EXPECT_EQ(e.strain, f.strain);
  EXPECT_EQ(e.hourglass, f.hourglass);
  EXPECT_EQ(e.viscous, f.viscous);
  EXPECT_EQ(f.viscous > 0., GetParam().relaxing);
  const auto p = together.momenta(), q = alone.momenta();
  EXPECT_EQ(p.linear, q.linear);
  EXPECT_EQ(p.angular, q.angular);
}
} // namespace
} // namespace ricochet::tests
