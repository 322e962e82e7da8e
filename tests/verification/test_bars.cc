// SPDX-License-Identifier: LGPL-2.1-or-later
// Bars that collide end on (St Venant): the contact lasts until the wave comes back from the free
// end, 2 L/c with the bar's c = sqrt(E/rho), under the stress rho c v (a wall) or rho c v/2 (an
// equal bar), and the bars exchange their velocities.
#include "ricochet/contact/friction_laws.h"
#include "ricochet/contact/surface_contact.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "support/body.h"
#include "support/hexahedra.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
struct Impact
{
  // Between the first and the last moment at which the force is half the plateau's: the springs
  // delay rise and fall alike. [s]
  double contact_time;
  double plateau;      // mean force from a quarter to three quarters of 2 L/c [N]
  double rebound;      // momentum of the striking bar afterwards over that before [-]
  double passed_on;    // momentum of the struck body over that of the bar before [-]
  double energy_error; // of all energies after the impact over the energy before, minus 1 [-]
};

/// A bar of finite elements flies at 10 m/s towards -x against a block of points; `moves` false:
/// the points are held, a rigid wall.
Impact collide(HexahedralBody &bar, PeridynamicBody &target, const bool moves,
               const double stiffness, const double c, const double length, const double plateau,
               const double safety)
{
  const double v = 10., spacing = target.lattice().box().spacing;
  const auto law = make_friction_law(ConstantFriction::Parameters{0.});
  FacetedSurface surface(surface_of(bar.solid()));
  SurfaceContact contact(MPI_COMM_SELF, *law, {stiffness, 0., 5.}, false,
                         target.lattice().box().n[0], std::vector<char>(surface.faces().size(), 0));
  double least = 1.;
  std::vector<double> mobility;
  for (int node = 0; node < bar.n_nodes(); ++node)
  {
    least = std::min(least, bar.node_mass(node));
    mobility.push_back(1. / bar.node_mass(node));
  }
  double squared = frequency_bound(MPI_COMM_SELF, bar).squared_frequency + stiffness / least;
  if (moves)
    squared = std::max(squared, frequency_bound(MPI_COMM_SELF, target).squared_frequency +
                                    stiffness / target.point_mass());
  const double dt = safety * 2. / std::sqrt(squared);

  for (int node = 0; node < bar.n_nodes(); ++node)
    bar.velocity()[3 * node] = -v;
  const double momentum = bar.mass() * v, energy = 0.5 * bar.mass() * v * v;
  Impact result{};
  double first = -1., last = 0., impulse = 0.;
  int n_plateau = 0;
  for (int step = 0; step * dt < 1.5 * 2. * length / c; ++step)
  {
    const double t = step * dt;
    bar.compute_internal_forces({true});
    target.update_ghosts();
    target.compute_internal_forces({true});
    surface.update(bar.position(), 2. * spacing);
    const auto reaction =
        contact.add_forces({bar.position(), bar.velocity(), bar.force(), mobility}, surface,
                           Vector3::Zero(), target, dt);
    if (reaction.normal.x() > 0.5 * plateau)
    {
      first = first < 0. ? t : first;
      last  = t;
    }
    if (first >= 0. && t - first > 0.25 * 2. * length / c && t - first < 0.75 * 2. * length / c)
    {
      impulse += reaction.normal.x();
      ++n_plateau;
    }
    if (first >= 0. && t - first > 1.25 * 2. * length / c && result.energy_error == 0.)
    {
      const auto e = bar.energies(dt);
      double all = e.kinetic + e.strain + e.hourglass + reaction.energy, passed = 0.;
      for_each_point(target,
                     [&](const std::ptrdiff_t p)
                     {
                       const auto &a   = target.state().arrays;
                       const Vector3 w = at(a.velocity, p), f = at(a.force, p);
                       if (!moves)
                         return;
                       all += a.energy[p] +
                              0.5 * target.point_mass() * w.dot(w + dt / target.point_mass() * f);
                       passed -= target.point_mass() * w.x();
                     });
      result.energy_error = all / energy - 1.;
      result.rebound      = bar.momenta().linear.x() / momentum;
      result.passed_on    = passed / momentum;
    }
    bar.advance(dt, dt);
    if (moves)
      target.advance(dt, dt);
  }
  result.contact_time = last - first;
  result.plateau      = impulse / n_plateau;
  return result;
}

TEST(Bars, SteelBarOnARigidWall)
{
  const double h = 0.5e-3;
  const int n = 60, across = 4;
  const double length = n * h, area = std::pow(across * h, 2), c = std::sqrt(202e9 / 7850.);
  HexahedralBody bar(block({n, across, across}, h, 0.15, {0.01 * h, 0., 0.}), steel(), false);
  BodySample wall; // one point before each element; its face is x = 0
  wall.n                    = {4, across, across};
  wall.spacing              = h;
  wall.corner               = {-4. * h, 0., 0.};
  wall.family.horizon_ratio = 2.;
  auto target               = make_body(wall);
  // Springs three times as stiff as one element: the wall gives way by a third of an edge.
  const double plateau      = 7850. * c * 10. * area;
  const auto impact         = collide(bar, *target, false, 3. * 202e9 * h, c, length, plateau, 0.7);
  verify_near("V8", "steel bar on a rigid wall: contact time over 2L/c",
              impact.contact_time / (2. * length / c), 1., 0.02);
  verify_near("V8", "steel bar on a rigid wall: force over ρcvA", impact.plateau / plateau, 1.,
              0.02);
  verify_at_least("V8", "steel bar on a rigid wall: rebound over v", impact.rebound, 0.97);
  EXPECT_NEAR(impact.energy_error, 0., 1e-3);
}

TEST(Bars, FiniteElementBarOnAnEqualBarOfPoints)
{
  // The same elastic constants and density, nu = 1/4, on both sides. The points' bar is soft at its
  // free faces, by about 4 % in E A at 12 points across, and its ends are soft: hence 5 % for
  // contact time and force, which are those of the softer bar. The step is so short that it does
  // not matter: seen are 1.0, 4.8 and 2.9 % (momentum), the same to 0.2 % with a fifth of it. With
  // longer ones points touch and let go at other times: 2 % of force, 0.2 % of momentum.
  const auto solid = solid_with_poisson_ratio(0.25);
  const double h   = 0.5e-3;
  const int n = 48, across = 12;
  const double length = n * h;
  const double E      = 9. * solid.bulk_modulus * solid.shear_modulus /
                   (3. * solid.bulk_modulus + solid.shear_modulus);
  const double c = std::sqrt(E / solid.density);
  HexahedralBody bar(block({n / 2, across / 2, across / 2}, 2. * h, 0.1, {0.01 * h, 0., 0.}),
                     {solid.density, solid.bulk_modulus, solid.shear_modulus}, false);
  BodySample sample;
  sample.family.law    = solid;
  sample.n             = {n, across, across};
  sample.spacing       = h;
  sample.corner        = {-n * h, 0., 0.};
  auto target          = make_body(sample);
  const double plateau = 0.5 * solid.density * c * 10. * std::pow(across * h, 2);
  const auto impact    = collide(bar, *target, true, 2. * E * h, c, length, plateau, 0.1);
  EXPECT_NEAR(impact.contact_time, 2. * length / c, 0.05 * 2. * length / c);
  EXPECT_NEAR(impact.plateau, plateau, 0.05 * plateau);
  EXPECT_NEAR(impact.passed_on, 1., 0.03);
  EXPECT_NEAR(impact.passed_on - impact.rebound, 1., 1e-12); // momentum
  EXPECT_NEAR(impact.energy_error, 0., 1e-3);
}
} // namespace
} // namespace ricochet::tests
