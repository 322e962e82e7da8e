// SPDX-License-Identifier: LGPL-2.1-or-later
// Free bodies keep energy, momentum and angular momentum.
#include "support/element_body.h"
#include "support/verification.h"

#include "ricochet/dynamics/largest_frequency.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
class FreeFlight : public testing::TestWithParam<Quadrature>
{
};
INSTANTIATE_TEST_SUITE_P(Both, FreeFlight, testing::Values(Quadrature::one_point, Quadrature::full),
                         [](const auto &info)
                         { return info.param == Quadrature::one_point ? "OnePoint" : "Full"; });

std::unique_ptr<FiniteElementBody> make_body(const Quadrature quadrature)
{
  FiniteElementBody::Options options;
  options.quadrature = quadrature;
  return std::make_unique<FiniteElementBody>(MPI_COMM_SELF, refined_box(), pmma(), options);
}

double total(const Energies &e)
{
  return e.kinetic + e.strain + e.hourglass;
}

TEST_P(FreeFlight, SpinningAndMovingBodyKeepsEnergyAndMomenta)
{
  // 1e5 steps, rim speed 0.02 c_P; with hanging nodes.
  const auto body      = make_body(GetParam());
  const double c       = p_wave_speed(pmma());
  const Vector3 centre = Vector3(-2e-3, 0., 1e-3) + 1e-3 * Vector3(2.5, 2., 1.5);
  const double radius  = 1e-3 * Vector3(2.5, 2., 1.5).norm();
  const Vector3 spin   = 0.02 * c / radius * Vector3(1., 2., 3.).normalized();
  const Vector3 flight(3., -2., 1.); // [m/s]
  const double dt = 0.9 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, *body).squared_frequency);
  auto velocity   = body->velocity();
  for (int node = 0; node < body->mesh().n_owned_nodes(); ++node)
    set(velocity, node, flight + spin.cross(body->mesh().reference_position(node) - centre));
  body->set_velocity(velocity);

  const int n_steps = 100000;
  double e_start = 0., e_low = 0., e_high = 0., largest_hourglass = 0.;
  Momenta start;
  double turn = 0.;
  for (int step = 0; step <= n_steps; ++step)
  {
    body->update_ghosts();
    body->compute_internal_forces({step % 10 == 0});
    if (step == 1)
      start = body->momenta(); // after the first half kick
    if (step % 10 == 0 && step > 0)
    {
      const auto e = body->energies(dt);
      if (e_start == 0.)
        e_start = e_low = e_high = total(e);
      e_low             = std::min(e_low, total(e));
      e_high            = std::max(e_high, total(e));
      largest_hourglass = std::max(largest_hourglass, e.hourglass / total(e));
    }
    body->advance(step == 0 ? 0.5 * dt : dt, dt);
    turn += spin.norm() * dt / (2. * M_PI);
  }
  const auto end = body->momenta();
  EXPECT_GT(turn, 15.);
  verify_at_most("V3", "energy of a spinning body of elements, 100 000 steps",
                 (e_high - e_low) / e_start, 1e-5);
  verify_at_most("V3", "linear momentum of a spinning body of elements, 100 000 steps",
                 (end.linear - start.linear).norm() / start.linear.norm(), 1e-12);
  verify_at_most("V3", "angular momentum of a spinning body of elements, 100 000 steps",
                 (end.angular - start.angular).norm() / start.angular.norm(), 1e-10);
  EXPECT_EQ(largest_hourglass > 0., GetParam() == Quadrature::one_point);
}

TEST_P(FreeFlight, NoiseKeepsTheLeapfrogEnergy)
{
  // V4 without the coupling, 2e4 steps: small white noise is a linear system, for which 1/2 m v- .
  // v+ + W is conserved and nothing may grow. What remains are the rounding of positions (4e-19 of
  // displacements of 1e-7 * 0.25 mm: 2e-8) and strains squared (1e-7 and less).
  const auto body = make_body(GetParam());
  const double dt = 0.9 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, *body).squared_frequency);
  const double speed = 1e-7 * p_wave_speed(pmma());
  auto velocity      = body->velocity();
  for (int node = 0; node < body->mesh().n_owned_nodes(); ++node)
    set(velocity, node, speed * noise_at(body->mesh().reference_position(node), 1e-3));
  body->set_velocity(velocity);
  double e_start = 0., e_low = 0., e_high = 0.;
  for (int step = 0; step <= 20000; ++step)
  {
    body->update_ghosts();
    body->compute_internal_forces({true});
    if (step > 0)
    {
      const double e = total(body->energies(dt));
      if (step == 1)
        e_start = e_low = e_high = e;
      e_low  = std::min(e_low, e);
      e_high = std::max(e_high, e);
    }
    body->advance(step == 0 ? 0.5 * dt : dt, dt);
  }
  EXPECT_GT(e_start, 0.);
  verify_at_most("V4", "discrete energy of elements under white noise, 20 000 steps",
                 (e_high - e_low) / e_start, 1e-7);
}
} // namespace
} // namespace ricochet::tests
