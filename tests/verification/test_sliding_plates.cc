// SPDX-License-Identifier: LGPL-2.1-or-later
// A block slides on a bed of the same lattice under a load of about 50 MPa. Coulomb stops it after
// v^2/(2 mu g). Two lattices of points are rough by themselves: rattling over each other they lose
// as much as with a coefficient of 0.07 to 0.15 (measured with several speeds, loads and shifts
// across); friction comes on top of that.
#include "ricochet/contact/constant_friction.h"
#include "ricochet/contact/short_range_contact.h"
#include "support/body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3, speed = 200., weight = 2e7, dt = 1e-7; // m, m/s, m/s^2, s

/// How far the block slides until its centre stops, or in 200 us [m].
double stopping_distance(const double mu)
{
  BodySample bed, block;
  bed.n        = {60, 12, 3};
  bed.corner   = {0., -6. * dx, -3. * dx};
  block.n      = {8, 8, 3};
  block.corner = {0., -4. * dx, 0.};
  block.number = 1;
  std::vector<std::unique_ptr<PeridynamicBody>> bodies;
  bodies.push_back(make_body(bed));
  bodies.push_back(make_body(block));
  auto &sliding = *bodies[1];
  auto &a       = sliding.state().arrays;
  // Away from the place where it has grown: points that have always been opposite touch later.
  for_each_point(
      sliding, [&](const std::ptrdiff_t p)
      { set(a.position, p, reference(sliding, p) + Vector3(20.5 * dx, 0.5 * dx, 0.2 * dx)); });
  const ConstantFriction law({mu});
  ShortRangeContact contact(MPI_COMM_SELF, bodies, 15., false, "linked cells",
                            {&law, 1., 0.02 * speed});

  const int settled = 400, n_points = 8 * 8 * 3;
  double start = 0., x = 0.;
  for (int step = 0; step < settled + 2000; ++step)
  {
    for (const auto &body : bodies)
    {
      body->update_ghosts();
      body->evaluate(/*breaking=*/false, /*energy=*/false);
    }
    contact.evaluate(dt);
    double v = 0.;
    x        = 0.;
    for_each_point(sliding,
                   [&](const std::ptrdiff_t p)
                   {
                     a.velocity[0][p] += step == settled ? speed : 0.;
                     a.force[2][p] -= weight * sliding.point_mass();
                     if (step < settled)
                       a.force[0][p] = 0.;
                     x += a.position[0][p] / n_points;
                     v += a.velocity[0][p] / n_points;
                   });
    if (step == settled)
      start = x;
    if (step > settled && v <= 0.)
      break;
    for_each_point(*bodies[0], [&](const std::ptrdiff_t p)
                   { set(bodies[0]->state().arrays.force, p, Vector3::Zero()); });
    for (const auto &body : bodies)
      body->advance(dt, dt);
  }
  return x - start;
}

TEST(SlidingPlates, FrictionComesOnTopOfTheLatticesRoughness)
{
  const auto coefficient = [](const double distance)
  { return speed * speed / (2. * weight * distance); };
  const double roughness = coefficient(stopping_distance(0.));
  EXPECT_GT(roughness, 0.05);
  EXPECT_LT(roughness, 0.15);
  for (const double mu : {0.1, 0.2})
  {
    const double total = coefficient(stopping_distance(mu));
    EXPECT_GT(total, mu + 0.05) << mu;
    EXPECT_LT(total, mu + 0.15) << mu;
  }
}
} // namespace
} // namespace ricochet::tests
