// SPDX-License-Identifier: LGPL-2.1-or-later
// A rigid steel ball dropped on a block of PMMA, against Hertz: with d the greatest approach,
//   d = (15 m v^2/(16 E* sqrt R))^(2/5),  F = 4/3 E* sqrt R d^(3/2),  t = 2.943 d/v
// The ball touches the block on a circle of radius sqrt(R d) = 0.96 mm.
#include "ricochet/contact/friction_laws.h"
#include "ricochet/contact/rigid_contact.h"
#include "support/body.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(Hertz, SteelBallOnPmmaHasTheForceDurationAndReturnOfTheory)
{
  constexpr double R = 10e-3, v = 1., dx = 0.25e-3, mass = 7850. * 4. / 3. * M_PI * R * R * R;
  // Half of it is computed; the lower face is held. 14 contact radii wide, 8 deep.
  BodySample sample;
  sample.n         = {56, 28, 32};
  sample.spacing   = dx;
  sample.corner    = {-28 * dx, 0., -32 * dx};
  sample.mirror_y  = true;
  const auto block = make_body(sample);
  const auto &m    = block->material();
  const double E   = youngs_modulus(m);
  const double nu  = E / (2. * m.shear_modulus) - 1.;

  const double E_star   = E / (1. - nu * nu);
  const double approach = std::pow(15. * mass * v * v / (16. * E_star * std::sqrt(R)), 0.4);
  const double force    = 4. / 3. * E_star * std::sqrt(R) * std::pow(approach, 1.5);
  const double duration = 2.943 * approach / v;

  const auto law         = make_friction_law(ConstantFriction::Parameters{0.});
  // Stiff springs: with k = E dx they alone would give way by a twentieth of the approach.
  const double stiffness = 8. * E * dx;
  RigidContact contact(MPI_COMM_SELF, *law, {stiffness, 0., 1.}, true, sample.n[0]);
  RigidBody ball(
      BodyOfRevolution({NoseShape::sphere, 2. * R, 0., 0.}), mass,
      {{0., 0., R + 0.01 * dx}, {0., 0., -v}, Eigen::Quaterniond::Identity(), Vector3::Zero()},
      true);

  // The bonds' largest frequency is about c_P/dx.
  const double squared =
      p_wave_modulus(m) / (m.density * dx * dx) + stiffness / block->point_mass();
  const double dt = 0.7 * 2. / std::sqrt(squared);
  double largest = 0., first = -1., last = 0.;
  for (int step = 0; step * dt < 1.3 * duration; ++step)
  {
    block->update_ghosts();
    block->compute_internal_forces({false});
    const auto reaction = contact.add_forces(ball, *block, dt);
    largest             = std::max(largest, reaction.normal.z());
    if (reaction.n_touching > 0.)
    {
      first = first < 0. ? step * dt : first;
      last  = step * dt;
    }
    for (int x = 0; x < sample.n[0]; ++x)
      for (int y = 0; y < sample.n[1]; ++y)
        set(block->state().arrays.force, block->lattice().index(x, y, 0), Vector3::Zero());
    block->advance(dt, dt);
    ball.advance(reaction.force(), reaction.moment, dt, dt);
  }
  verify_near("V12", "largest force over that of Hertz", largest / force, 1., 0.05);
  verify_near("V12", "contact time over that of Hertz", (last - first) / duration, 1., 0.05);
  verify_at_least("V12", "rebound over v", ball.motion().velocity.z() / v, 0.97);
  EXPECT_LE(ball.motion().velocity.z(), v);
}
} // namespace
} // namespace ricochet::tests
