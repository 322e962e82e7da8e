// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/hourglass_watch.h"

#include "support/coupled_scene.h"

#include <gtest/gtest.h>

#include <functional>

namespace ricochet::tests
{
namespace
{
/// Calls visit(moment) after each of so many steps.
void for_each_record(const Scene &scene, const int n_steps,
                     const std::function<void(const Moment &)> &visit)
{
  Simulation simulation(MPI_COMM_WORLD, scene);
  for (int step = 0; step < n_steps; ++step)
  {
    simulation.compute_forces(true);
    const Totals totals = totals_of(simulation);
    visit({simulation, totals});
    simulation.advance();
  }
}

Scene elements_alone()
{
  Scene scene     = coupled_scene();
  scene.zone.kind = ZoneKind::none;
  return scene;
}

TEST(HourglassWatch, FindsTheLargestShareOfTheRunThatMatters)
{
  // All that such a plate stores is in its elements: the balance has the same numbers.
  for (const bool half : {false, true})
  {
    Scene scene     = elements_alone();
    scene.symmetric = half;
    HourglassWatch watch;
    double share = 0., time = -1.;
    int n_ignored = 0;
    for_each_record(scene, 60,
                    [&](const Moment &m)
                    {
                      watch.update(m);
                      const auto &e       = m.totals.energies;
                      const double stored = e.strain + e.hourglass;
                      n_ignored += stored < 1e-3 * e.initial;
                      if (stored >= 1e-3 * e.initial && e.hourglass / stored > share)
                      {
                        share = e.hourglass / stored;
                        time  = m.simulation.time();
                      }
                    });
    EXPECT_GT(n_ignored, 0) << "at rest nothing is stored";
    EXPECT_GT(share, 0.01);
    EXPECT_NEAR(watch.largest().share, share, 1e-12); // both halves are twice the one
    EXPECT_EQ(watch.largest().time, time);
    EXPECT_EQ(watch.is_large(), share > 0.1);
  }
}

TEST(HourglassWatch, LooksAtElementsNotAtPoints)
{
  // The zone stores most of the energy, but has no hourglass modes.
  HourglassWatch watch;
  double diluted = 0.;
  for_each_record(coupled_scene(), 120,
                  [&](const Moment &m)
                  {
                    watch.update(m);
                    const auto &e = m.totals.energies;
                    if (watch.largest().time == m.simulation.time())
                      diluted = e.hourglass / (e.strain + e.hourglass);
                  });
  EXPECT_GT(watch.largest().time, 0.);
  EXPECT_GT(watch.largest().share, 2. * diluted);
  EXPECT_LT(watch.largest().share, 1.);
}

TEST(HourglassWatch, FindsNoneWithoutElementsOrWithFullQuadrature)
{
  HourglassWatch of_points, of_full;
  for_each_record(two_plates(), 20, [&](const Moment &m) { of_points.update(m); });
  EXPECT_LT(of_points.largest().time, 0.);
  Scene full                = elements_alone();
  full.zone.full_quadrature = true;
  for_each_record(full, 60, [&](const Moment &m) { of_full.update(m); });
  EXPECT_GT(of_full.largest().time, 0.);
  EXPECT_EQ(of_full.largest().share, 0.);
}
} // namespace
} // namespace ricochet::tests
