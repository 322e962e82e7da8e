// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/zone_extent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
/// A 0.3 in bullet at 720 m/s, 30 degrees to a plate of 10 mm.
ImpactGeometry bullet()
{
  return {6.17e-3, 27.6e-3, 720., M_PI / 6., 40e-3, 5e-3, 0., 10e-3, 3e-3};
}

double length(const ZoneChoice &zone)
{
  return zone.x_high - zone.x_low;
}

TEST(ZoneExtent, CorridorOfAStraightPathIsTheOneOfThePaper)
{
  const auto impact = bullet();
  const auto zone   = corridor_zone(impact);
  const double side = 1.5 * 6.17e-3 + 2. * 3e-3;
  EXPECT_NEAR(zone.y_low, 5e-3 - side, 1e-12);
  EXPECT_NEAR(zone.y_high, 5e-3 + side, 1e-12);
  EXPECT_NEAR(zone.x_low, 40e-3 - side, 1e-12);
  EXPECT_NEAR(zone.x_high, 40e-3 + 10e-3 / std::tan(M_PI / 6.) + 27.6e-3 + 5. * 6.17e-3, 1e-12);
  EXPECT_NE(zone.reason.find("straight through"), std::string::npos) << zone.reason;
}

TEST(ZoneExtent, CorridorEndsWhereARicochetWould)
{
  auto impact       = bullet();
  impact.thickness  = 1.; // never left again
  const double arc  = 2. * 110e-3 * std::sin(M_PI / 6.);
  const double rest = 27.6e-3 + 5. * 6.17e-3 + 1.5 * 6.17e-3 + 2. * 3e-3;
  EXPECT_NEAR(length(corridor_zone(impact)), arc + rest, 1e-12);
  EXPECT_NE(corridor_zone(impact).reason.find("arc"), std::string::npos);
  impact.speed *= 1.5; // radius with the energy
  EXPECT_NEAR(length(corridor_zone(impact)), 1.5 * 1.5 * arc + rest, 1e-12);
}

TEST(ZoneExtent, DeepPlatesAreReachedFurtherAhead)
{
  const auto first = bullet();
  auto second      = first;
  second.depth     = 12e-3;
  const double way = 12e-3 / std::tan(M_PI / 6.);
  EXPECT_NEAR(corridor_zone(second).x_low, corridor_zone(first).x_low + way, 1e-12);
  EXPECT_NEAR(entry_zone(second).x_low, entry_zone(first).x_low + way, 1e-12);
  EXPECT_NEAR(growth_limit(second).x_low, growth_limit(first).x_low + way, 1e-12);
}

TEST(ZoneExtent, AGrowingZoneStartsWithinItsLimitAndReachesAsFarAsTheProjectile)
{
  for (const double degrees : {5., 15., 30., 60., 80.})
    for (const double speed : {200., 720., 1500.})
      for (const double depth : {0., 10e-3})
      {
        auto impact            = bullet();
        impact.incidence_angle = degrees * M_PI / 180.;
        impact.speed           = speed;
        impact.depth           = depth;
        const auto start = entry_zone(impact), limit = growth_limit(impact);
        EXPECT_LT(length(start), length(limit)) << degrees << " " << speed;
        EXPECT_GE(start.x_low, limit.x_low);
        EXPECT_LE(start.x_high, limit.x_high);
        EXPECT_GE(start.y_low, limit.y_low);
        EXPECT_LE(start.y_high, limit.y_high);
        // The entry point of this plate is in it, and damage has room ahead of the tip.
        const double entry = impact.entry_x + depth / std::tan(impact.incidence_angle);
        EXPECT_LT(start.x_low, entry - growth_ahead(impact) + 1e-12);
        EXPECT_GT(start.x_high, entry + growth_ahead(impact));
        EXPECT_EQ(limit.y_high - limit.y_low,
                  corridor_zone(impact).y_high - corridor_zone(impact).y_low);
      }
}
} // namespace
} // namespace ricochet::tests
