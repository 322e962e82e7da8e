// SPDX-License-Identifier: LGPL-2.1-or-later
// What waves make of it is in verification/test_absorbing_edges.cc.
#include "finite_elements/absorbing_boundary.h"
#include "support/element_body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double h = 1e-3; // [m]

struct Block
{
  HexMesh mesh{MPI_COMM_SELF, {Vector3::Zero(), h, {3, 2, 4}, false, {}}};
  LumpedMass lumped = lumped_mass(mesh, pmma().density, std::vector<char>(24, 1), {});
  AbsorbingBoundary boundary{mesh, pmma(), {false, true, false, false, false, false}};
  std::vector<double> position = mesh.reference(), velocity, force;

  explicit Block(const Vector3 &v) : velocity(position.size()), force(position.size(), 0.)
  {
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      set(velocity, node, v);
  }
  AbsorbingBoundary::Motion motion() const { return {position, velocity, force, lumped.inverse}; }
  Vector3 sum_of_forces() const
  {
    Vector3 sum = Vector3::Zero();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      sum += at(force, node);
    return sum;
  }
  double absorbed() const // up to now [J]
  {
    ExactSum kinetic, sum;
    boundary.add_energies(motion(), lumped.mass, /*dt=*/0., kinetic, sum);
    return sum.value();
  }
  /// Momentum from entry 0 on, angular momentum from entry 3 on.
  Vector3 carried(const int first) const
  {
    std::array<ExactSum, 6> sums;
    boundary.add_momenta(sums);
    return {sums[first].value(), sums[first + 1].value(), sums[first + 2].value()};
  }
};

TEST(AbsorbingBoundary, PullsBackWithTheImpedanceOfBothWaves)
{
  const auto m      = pmma();
  const double face = 2. * h * 4. * h, c_s = std::sqrt(m.shear_modulus / m.density);
  const Vector3 v(2., -3., 5.);
  Block block(v);
  // So short that the velocity does not change on the way.
  const double dt = 1e-9 * h / p_wave_speed(m);
  block.boundary.damp(block.motion(), dt, block.force);
  const Vector3 expected =
      -m.density * face * Vector3(p_wave_speed(m) * v.x(), c_s * v.y(), c_s * v.z());
  EXPECT_LT((block.sum_of_forces() - expected).norm(), 1e-8 * expected.norm());
  for (int node = 0; node < block.mesh.n_owned_nodes(); ++node)
    if (block.mesh.reference_position(node).x() < 2.9 * h)
    {
      EXPECT_EQ(at(block.force, node), Vector3(Vector3::Zero())) << "not on the face";
    }
  EXPECT_NEAR(block.absorbed(), -dt * expected.dot(v), 1e-8 * block.absorbed());
}

TEST(AbsorbingBoundary, BooksTheMomentumThatItTakes)
{
  Block block(Vector3(2., -3., 5.));
  for (std::size_t i = 0; i < block.force.size(); ++i)
    block.force[i] = std::sin(double(i));
  const Vector3 before = block.sum_of_forces();
  const double dt      = 0.5 * h / p_wave_speed(pmma());
  block.boundary.damp(block.motion(), dt, block.force);
  const Vector3 taken = dt * (before - block.sum_of_forces());
  EXPECT_LT((block.carried(0) - taken).norm(), 1e-13 * taken.norm());
  Vector3 moment = Vector3::Zero();
  for (int node = 0; node < block.mesh.n_owned_nodes(); ++node)
  {
    Vector3 undamped;
    for (int d = 0; d < 3; ++d)
      undamped[d] = std::sin(double(3 * node + d));
    moment += at(block.position, node).cross(dt * (undamped - at(block.force, node)));
  }
  EXPECT_LT((block.carried(3) - moment).norm(), 1e-13 * moment.norm());
}

TEST(AbsorbingBoundary, LosesInAStepWhatTheNodesLose)
{
  // Kinetic energy before and after a kick, and what the dashpots say to have taken.
  Block block(Vector3(2., -3., 5.));
  const double dt    = 3. * h / p_wave_speed(pmma()); // far beyond what an explicit dashpot stands
  const auto kinetic = [&]
  {
    double sum = 0.;
    for (std::size_t i = 0; i < block.velocity.size(); ++i)
      sum += 0.5 * block.lumped.mass[i / 3] * block.velocity[i] * block.velocity[i];
    return sum;
  };
  const double before = kinetic();
  block.boundary.damp(block.motion(), dt, block.force);
  for (std::size_t i = 0; i < block.velocity.size(); ++i)
    block.velocity[i] += dt * block.force[i] * block.lumped.inverse[i];
  EXPECT_LT(kinetic(), before);
  EXPECT_NEAR(before - kinetic(), block.absorbed(), 1e-12 * before);
}
} // namespace
} // namespace ricochet::tests
