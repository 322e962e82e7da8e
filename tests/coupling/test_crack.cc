// SPDX-License-Identifier: LGPL-2.1-or-later
// A crack runs towards the interface of a zone that grows ahead of it, and is compared with the
// same crack in a strip that is peridynamic all along. V23: an impact with its interface moved.
#include "coupled_plate.h"
#include "coupled_scene.h"

#include "ricochet/drivers/zone_watch.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
constexpr double critical = 0.01, horizon = 3e-3; // [-], [m]

struct Crack
{
  std::map<int, std::pair<double, double>> sums; // per plane of points along x: of z, and how many
  double n_broken    = 0.;
  long n_conversions = 0;
  double reached     = -1.; // [s]

  double height(const int x) const { return sums.at(x).first / sums.at(x).second; }
  int tip() const { return sums.empty() ? -1 : sums.rbegin()->first; }
};

/// A strip under tension along z between clamps, 96 x 6 x 64 mm, with an oblique notch that comes
/// in from the left; the middle third of its height may break.
Crack crack(const bool coupled, const int n_steps)
{
  constexpr int low = 10, high = 22; // cells along z that may be points
  CoupledSample sample;
  sample.communicator     = MPI_COMM_SELF;
  sample.n_cells          = {48, 3, 32};
  sample.zone             = {{0, 0, low}, {coupled ? 16 : 48, 3, high}};
  sample.critical_stretch = critical;
  CoupledPlate strip(sample);
  ZoneWatch watch(MPI_COMM_SELF, *strip.far,
                  {0.5 * critical, coupled, {{0, 0, low}, {48, 3, high}}});

  // Bonds across the notch: a plane that rises towards the middle of the strip.
  const double notch = 22e-3, middle = 32e-3, slope = 0.3;
  const auto above    = [&](const Vector3 &X) { return X.z() > middle - slope * (notch - X.x()); };
  auto &points        = *strip.points;
  const auto &lattice = points.lattice();
  const auto &offsets = lattice.stencil().offsets;
  for (std::ptrdiff_t p = 0; p < lattice.owned_end(); ++p)
    if (lattice.exists(p))
      for (std::size_t k = 0; k < offsets.size(); ++k)
      {
        const auto q    = p + lattice.shift(offsets[k]);
        const Vector3 A = lattice.reference_position(lattice.coordinates(p)),
                      B = lattice.reference_position(lattice.coordinates(q));
        if (A.x() < notch && B.x() < notch && above(A) != above(B))
          points.state().arrays.bonds[p / 8 * offsets.size() + k] &=
              static_cast<std::uint8_t>(~(1u << (p % 8)));
      }

  // Stretched at once, and clamped.
  const double strain = 0.42 * critical;
  strip.deform(
      [&](const Vector3 &X) -> Vector3 {
        return {X.x(), X.y(), X.z() + strain * (X.z() - middle)};
      });
  auto &elements = strip.far->elements();
  for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    if (const double z = elements.mesh().reference_position(node).z();
        z < 1e-6 || z > 2. * middle - 1e-6)
      elements.fix(node, 2);

  const double dt = 1.4e-6;
  for (int step = 0; step < n_steps; ++step)
  {
    points.update_ghosts();
    if (watch.update(step * dt, dt))
    {
      points.update_ghosts();
      for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node) // masses are new
        if (const double z = elements.mesh().reference_position(node).z();
            z < 1e-6 || z > 2. * middle - 1e-6)
          elements.fix(node, 2);
    }
    points.evaluate(/*breaking=*/true, /*energy=*/false);
    strip.far->evaluate(/*energy=*/false);
    strip.advance(dt, dt);
  }
  Crack result;
  points.for_each_broken_bond(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, std::size_t)
      {
        const auto a = lattice.coordinates(p), b = lattice.coordinates(q);
        const Vector3 X = 0.5 * (lattice.reference_position(a) + lattice.reference_position(b));
        if (X.x() < notch + 1e-3)
          return;
        auto &sum = result.sums[a[0]];
        sum.first += X.z();
        sum.second += 1.;
        result.n_broken += 1.;
      });
  result.n_conversions = watch.n_conversions();
  result.reached       = watch.reached();
  return result;
}

TEST(LongCrack, RunsThroughAGrowingZoneAsThroughPoints)
{
  const auto full = crack(false, 260), coupled = crack(true, 260);
  std::printf("full: %g bonds, tip at %d; coupled: %g bonds, tip at %d, %ld conversions\n",
              full.n_broken, full.tip(), coupled.n_broken, coupled.tip(), coupled.n_conversions);
  double worst = 0.;
  int n_planes = 0;
  for (const auto &[x, sum] : full.sums)
    if (coupled.sums.count(x))
    {
      worst = std::max(worst, std::abs(full.height(x) - coupled.height(x)));
      ++n_planes;
    }
  std::printf("path: %g horizons apart on %d planes\n", worst / horizon, n_planes);
  EXPECT_GE(full.tip(), 50) << "the crack did not leave the first zone, 32 planes long";
  EXPECT_GE(coupled.n_conversions, 2);
  EXPECT_LT(coupled.reached, 0.);
  EXPECT_GE(n_planes, 25);
  EXPECT_LE(worst, 2. * horizon);
  EXPECT_LE(std::abs(full.tip() - coupled.tip()), 6); // 2 horizons
  EXPECT_NEAR(coupled.n_broken / full.n_broken, 1., 0.1);
}

struct ImpactResult
{
  double speed, damaged, reached;
};

/// The small impact on a large plate; the zone reaches so many horizons beyond what breaks.
ImpactResult impact(const double horizons)
{
  Scene scene                  = symmetric(coupled_scene());
  scene.plates[0].length       = 140e-3;
  scene.plates[0].width        = 120e-3;
  scene.impact.entry_x         = 60e-3;
  scene.zone.coarsening_levels = 1;
  const double margin          = horizons * horizon;
  scene.plates[0].zone_boxes   = {{56e-3 - margin, 80e-3 + margin, -8e-3 - margin, 8e-3 + margin}};
  Simulation simulation(MPI_COMM_SELF, scene);
  for (int step = 0; simulation.time() < 60e-6; ++step)
  {
    simulation.evaluate(false);
    simulation.advance();
  }
  const auto &plate = *simulation.plates()[0];
  double damaged    = 0.;
  plate.lattice().for_each_owned([&](const std::ptrdiff_t p) { damaged += plate.damage(p); });
  return {simulation.projectile().motion().velocity.norm(), damaged,
          simulation.zone_watches()[0]->reached()};
}

TEST(LongV23InterfacePosition, ImpactDoesNotFeelTheInterface)
{
  const auto near = impact(4.), middle = impact(8.), far = impact(16.);
  for (const auto &result : {near, middle, far})
    std::printf("speed %.4f m/s, damaged volume %.2f, interface reached %g us\n", result.speed,
                result.damaged, 1e6 * result.reached);
  EXPECT_NEAR(middle.speed / far.speed, 1., 0.02);
  EXPECT_NEAR(middle.damaged / far.damaged, 1., 0.02);
}
} // namespace
} // namespace ricochet::tests
