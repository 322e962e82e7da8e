// SPDX-License-Identifier: LGPL-2.1-or-later
#include "peridynamics/point_sums.h"
#include "support/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace ricochet::tests
{
namespace
{
/// Shaken: position, velocity and force of each point from its coordinates.
std::unique_ptr<PeridynamicBody> shaken(const MPI_Comm communicator)
{
  BodySample sample;
  sample.n            = {12, 6, 5};
  sample.communicator = communicator;
  auto body           = make_body(sample);
  auto &a             = body->state().arrays;
  const auto of_place = [&](const std::ptrdiff_t p, const double seed) -> Vector3
  {
    const Vector3 X = reference(*body, p) / sample.spacing;
    return {std::sin(seed + 3. * X.x()), std::cos(seed + 5. * X.y()), std::sin(seed * X.z())};
  };
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   set(a.velocity, p, of_place(p, 1.));
                   set(a.position, p, reference(*body, p) + 1e-5 * of_place(p, 2.));
                 });
  body->update_ghosts();
  body->compute_internal_forces({/*energy=*/true});
  return body;
}

TEST(PointSums, AreTheSameOnAnyNumberOfRanks)
{
  constexpr double dt = 1e-7;
  const auto shared = shaken(MPI_COMM_WORLD), alone = shaken(MPI_COMM_SELF);
  const auto of = [&](const PeridynamicBody &body)
  {
    return point_energies(body.communicator(), body.lattice(), body.state().arrays,
                          body.point_mass(), dt);
  };
  EXPECT_GT(of(*alone).kinetic, 0.);
  EXPECT_GT(of(*alone).strain, 0.);
  EXPECT_EQ(of(*shared).kinetic, of(*alone).kinetic);
  EXPECT_EQ(of(*shared).strain, of(*alone).strain);
  EXPECT_EQ(shared->momenta().linear, alone->momenta().linear);
  EXPECT_EQ(shared->momenta().angular, alone->momenta().angular);
}

TEST(PointSums, KineticEnergyIsTheProductOfTheVelocitiesAroundTheStep)
{
  const double dt = 1e-7;
  const auto body = shaken(MPI_COMM_SELF);
  const double m  = body->point_mass();
  double expected = 0.;
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   const Vector3 before = at(body->state().arrays.velocity, p),
                                 after  = before + dt / m * force(*body, p);
                   expected += 0.5 * m * before.dot(after);
                 });
  const auto energies = point_energies(MPI_COMM_SELF, body->lattice(), body->state().arrays, m, dt);
  EXPECT_NEAR(energies.kinetic / expected, 1., 1e-13);
  EXPECT_NEAR(energies.strain / strain_energy(*body), 1., 1e-13);
}
} // namespace
} // namespace ricochet::tests
