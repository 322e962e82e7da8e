// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/zone_extent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
/// A 0.3 in bullet at 720 m/s, 30 degrees to a plate of 10 mm of PMMA, E s_c = 63.1 MPa.
ImpactOnPlate bullet()
{
  return {6.17e-3, 27.6e-3, 5.25e-3, 720., M_PI / 6., 40e-3, 5e-3, 0., 10e-3, 3e-3, 63.1e6};
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
  const double arc  = 2. * ricochet_radius(impact) * std::sin(M_PI / 6.);
  const double rest = 27.6e-3 + 5. * 6.17e-3 + 1.5 * 6.17e-3 + 2. * 3e-3;
  EXPECT_NEAR(length(corridor_zone(impact)), arc + rest, 1e-12);
  EXPECT_NE(corridor_zone(impact).reason.find("arc"), std::string::npos);
  impact.speed *= 1.5; // lengths with the speed
  EXPECT_NEAR(length(corridor_zone(impact)), 1.5 * arc + rest, 1e-12);
}

/// What 2 R sin(angle) stands for: how far a projectile comes from the first to the last touch.
TEST(ZoneExtent, RicochetsAreAsLongAsInRunsThatArePeridynamicThroughout)
{
  struct Run
  {
    const char *name;
    double degrees, touching; // [deg], [m], see doc/coupling.md
    void (*change)(ImpactOnPlate &);
  };
  const auto as_is = [](ImpactOnPlate &) {};
  const Run runs[] = {
      {"10 deg", 10., 43e-3, as_is},
      {"20 deg", 20., 63e-3, as_is},
      {"30 deg", 30., 129e-3, as_is},
      {"250 m/s", 20., 21e-3, [](ImpactOnPlate &impact) { impact.speed = 250.; }},
      {"500 m/s", 20., 41e-3, [](ImpactOnPlate &impact) { impact.speed = 500.; }},
      {"1000 m/s", 20., 113e-3, [](ImpactOnPlate &impact) { impact.speed = 1000.; }},
      {"10 deg, 1000 m/s", 10., 65e-3, [](ImpactOnPlate &impact) { impact.speed = 1000.; }},
      {"30 deg, 500 m/s", 30., 53e-3, [](ImpactOnPlate &impact) { impact.speed = 500.; }},
      {"half the mass", 20., 44e-3, [](ImpactOnPlate &impact) { impact.mass /= 2.; }},
      {"twice the mass", 20., 117e-3, [](ImpactOnPlate &impact) { impact.mass *= 2.; }},
      {"8 mm", 20., 56e-3, [](ImpactOnPlate &impact) { impact.calibre = 8e-3; }},
      {"half the strength", 20., 86e-3, [](ImpactOnPlate &impact) { impact.strength /= 2.; }},
      {"twice the strength", 20., 49e-3, [](ImpactOnPlate &impact) { impact.strength *= 2.; }}};
  for (const auto &run : runs)
  {
    auto impact            = bullet();
    impact.incidence_angle = run.degrees * M_PI / 180.;
    run.change(impact);
    const double arc = 2. * ricochet_radius(impact) * std::sin(impact.incidence_angle);
    // An estimate: the corridor has five calibres to spare, and is no dearer than need be.
    EXPECT_GT(arc + 5. * impact.calibre, run.touching) << run.name;
    EXPECT_LT(arc, 1.5 * run.touching) << run.name;
  }
}

TEST(ZoneExtent, SimilarImpactsHaveSimilarZones)
{
  const auto impact = bullet();
  for (const double speed : {0.25, 1., 8.})
    for (const double scale : {0.5, 1., 1024.})
      for (const double density : {0.125, 1., 4.})
      {
        auto similar = impact;
        for (const auto member :
             {&ImpactOnPlate::calibre, &ImpactOnPlate::length, &ImpactOnPlate::entry_x,
              &ImpactOnPlate::entry_y, &ImpactOnPlate::depth, &ImpactOnPlate::thickness,
              &ImpactOnPlate::horizon})
          similar.*member *= scale;
        similar.mass *= density * scale * scale * scale;
        similar.speed *= speed;
        similar.strength *= density * speed * speed;
        for (const auto zone_of : {&corridor_zone, &growth_limit, &entry_zone})
        {
          const auto expected = zone_of(impact), found = zone_of(similar);
          for (const auto member :
               {&ZoneChoice::x_low, &ZoneChoice::x_high, &ZoneChoice::y_low, &ZoneChoice::y_high})
            EXPECT_EQ(found.*member, scale * expected.*member) // powers of two: exactly
                << speed << " " << scale << " " << density;
        }
        EXPECT_EQ(growth_ahead(similar), scale * growth_ahead(impact));
      }
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
