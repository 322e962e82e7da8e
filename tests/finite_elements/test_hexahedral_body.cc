// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/hexahedra.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});

TEST(HexahedralBody, RefusesFoldedCells)
{
  HexSolid cube = block({1, 1, 1}, 2.);
  cube.nodes[7] = Vector3(-1., -1., -1.);
  std::swap(cube.nodes[0], cube.nodes[1]);
  ASSERT_LT(scaled_jacobian(cube, 0), 0.);
  EXPECT_THROW(HexahedralBody(cube, steel(), false), InputError);
}

TEST(HexahedralBody, SpinningProjectileKeepsEnergyAndMomenta)
{
  HexahedralBody body(revolved_hexes(core, 1), steel(), false);
  const double dt = 0.8 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, body).squared_frequency);
  RigidBody::Motion start;
  start.position    = Vector3(0.1, -0.2, 0.05);
  start.orientation = Eigen::AngleAxisd(0.6, Vector3(1., 1., 0.5).normalized());
  start.velocity    = Vector3(600., 50., -300.);
  start.spin        = Vector3(3000., -2e4, 1e4); // tail at 300 m/s
  body.set_motion(start);
  double e_low = 1e300, e_high = 0.;
  auto first = body.momenta(), last = first;
  for (int step = 0; step < 10000; ++step)
  {
    body.compute_internal_forces({step % 10 == 0});
    if (step > 0 && step % 10 == 0)
    {
      const auto e       = body.energies(dt);
      const double total = e.kinetic + e.strain + e.hourglass;
      e_low              = std::min(e_low, total);
      e_high             = std::max(e_high, total);
    }
    last = body.momenta();
    if (step == 1)
      first = last;
    body.advance(step == 0 ? 0.5 * dt : dt, dt);
  }
  EXPECT_GT(e_low, 0.);
  verify_at_most("V3", "energy of a spinning projectile of elements", (e_high - e_low) / e_high,
                 1e-5);
  verify_at_most("V3", "linear momentum of a spinning projectile of elements",
                 (last.linear - first.linear).norm() / first.linear.norm(), 1e-12);
  verify_at_most("V3", "angular momentum of a spinning projectile of elements",
                 (last.angular - first.angular).norm() / first.angular.norm(), 1e-10);
}

TEST(HexahedralBody, NearestRigidMotionIsTheOneItWasPutInto)
{
  for (const bool mirrored : {false, true})
  {
    HexSolid solid = revolved_hexes(core, 2);
    if (mirrored)
      solid = upper_half(solid, 1e-9);
    HexahedralBody body(solid, steel(), mirrored);
    RigidBody::Motion start;
    start.position    = Vector3(0.03, mirrored ? 0. : 0.01, 0.02);
    start.orientation = Eigen::AngleAxisd(0.5, Vector3::UnitY());
    start.velocity    = Vector3(600., mirrored ? 0. : 50., -300.);
    start.spin        = mirrored ? Vector3(0., -4000., 0.) : Vector3(500., -4000., 300.);
    if (!mirrored)
      start.orientation = Eigen::AngleAxisd(0.7, Vector3::UnitX()) * start.orientation;
    body.set_motion(start);
    const auto found = body.rigid_motion();
    EXPECT_LT((found.position - start.position).norm(), 1e-15);
    EXPECT_LT((found.velocity - start.velocity).norm(), 1e-11);
    EXPECT_LT((found.spin - start.spin).norm(), 1e-8);
    EXPECT_LT(found.orientation.angularDistance(start.orientation), 1e-7); // sqrt of rounding
    EXPECT_NEAR(body.mass(), 7850. * core.volume() / (mirrored ? 2. : 1.), 1e-3 * body.mass());
  }
}

TEST(HexahedralBody, FreeBarRingsAtTheFrequencyOfItsLength)
{
  // A free steel bar of length L: the first longitudinal mode is cos(pi x/L), f = c_0/(2 L) with
  // c_0 = sqrt(E/rho) = 5073 m/s; Rayleigh's correction for the width, nu^2 pi^2 (a^2/6) / (2 L^2)
  // for a square a x a, is 4e-5 here.
  const double h = 1e-3;
  const int n    = 40;
  HexahedralBody body(block({n, 2, 2}, h, 0.15), steel(), false);
  const double dt = 0.8 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, body).squared_frequency);
  const double length = n * h;
  for (int node = 0; node < body.n_nodes(); ++node)
    body.velocity()[3 * node] = 0.1 * std::cos(M_PI * body.solid().nodes[node].x() / length);
  // The velocity of one end crosses zero twice a period.
  int crossings = 0;
  double first = 0., last = 0., before = 0.1;
  for (int step = 0; crossings < 9; ++step)
  {
    body.compute_internal_forces({false});
    body.advance(step == 0 ? 0.5 * dt : dt, dt);
    double v = 0., m = 0.; // amplitude of the mode, mass weighted
    for (int node = 0; node < body.n_nodes(); ++node)
    {
      const double shape = std::cos(M_PI * body.solid().nodes[node].x() / length);
      v += body.node_mass(node) * shape * body.velocity()[3 * node];
      m += body.node_mass(node) * shape * shape;
    }
    v /= m;
    if (v * before < 0.)
    {
      const double t = (step + 0.5 + before / (before - v) - 1.) * dt;
      first          = crossings == 0 ? t : first;
      last           = t;
      ++crossings;
    }
    before = v;
    ASSERT_LT(step, 100000);
  }
  const double frequency = 0.5 * (crossings - 1) / (last - first);
  const double exact     = std::sqrt(202e9 / 7850.) / (2. * length);
  EXPECT_NEAR(frequency, exact, 2e-3 * exact); // dispersion of 80 elements a wave: (pi/80)^2/6
}

TEST(HexahedralBody, StepFromTheFrequencyBoundIsStableAndALongerOneIsNot)
{
  for (const double share : {1., 1.05})
  {
    HexahedralBody body(revolved_hexes(core, 2), steel(), false);
    const double dt =
        share * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, body).squared_frequency);
    Random random(17);
    for (double &v : body.velocity())
      v = 1e-6 * random.uniform();
    double kinetic = 0.;
    for (int step = 0; step < 2000; ++step)
    {
      body.compute_internal_forces({false});
      body.advance(dt, dt);
    }
    for (int node = 0; node < body.n_nodes(); ++node)
      kinetic += body.node_mass(node) * node_of(body.velocity(), node).squaredNorm();
    const bool grew = !(kinetic < 1e-9);
    EXPECT_EQ(grew, share > 1.) << kinetic;
  }
}
} // namespace
} // namespace ricochet::tests
