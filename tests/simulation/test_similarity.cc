// SPDX-License-Identifier: LGPL-2.1-or-later
// Dynamically similar scenes: in units of calibre, speed and density they are the same, so their
// results are, whatever carries the plates and the projectile. All factors are powers of two, of
// four for masses and stresses whose roots are taken. They change no digit, so nothing is compared
// with a tolerance.
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/history_record.h"
#include "support/similar_scene.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
struct Course
{
  std::vector<HistoryColumn> columns;
  std::vector<std::vector<double>> records; // one every `interval` steps
  long n_conversions = 0;                   // of all plates
  double broken_bonds;
};

Course course_of(const Scene &scene, const int n_steps, const int interval)
{
  Simulation simulation(MPI_COMM_SELF, scene);
  Course course;
  course.columns = history_columns(simulation.n_projectiles());
  for (int step = 0; step <= n_steps; ++step)
  {
    const bool due = step % interval == 0;
    simulation.compute_forces(due);
    if (due)
    {
      const Totals totals = totals_of(simulation);
      course.records.push_back(history_record({simulation, totals}));
    }
    simulation.advance();
  }
  for (std::size_t i = 0; i < simulation.n_plates(); ++i)
    if (const auto *const plate = simulation.coupled_plate(i))
      course.n_conversions += plate->adaptive_zone().n_conversions();
  course.broken_bonds = simulation.broken_bonds();
  return course;
}

double n_different(const Course &one, const Course &other, const Scale &scale)
{
  const auto &columns = one.columns;
  double n            = 0.;
  for (std::size_t i = 0; i < one.records.size(); ++i)
    for (std::size_t c = 0; c < columns.size(); ++c)
      n += other.records[i][c] / scale.of(columns[c].unit) != one.records[i][c];
  return n;
}

void expect_similar(const Course &one, const Course &other, const Scale &scale)
{
  const auto &columns = one.columns;
  const auto &first = one.records, &second = other.records;
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t c = 0; c < columns.size(); ++c)
      ASSERT_EQ(second[i][c] / scale.of(columns[c].unit), first[i][c])
          << columns[c].name << ", record " << i;
}

/// A second one, heavier, comes down farther along.
Scene two_projectiles(Scene scene)
{
  scene.further_shots.push_back({scene.projectile, scene.impact});
  scene.further_shots[0].projectile.mass *= 2.;
  scene.further_shots[0].impact.entry_x = 20e-3;
  return scene;
}

Scene with_zone(Scene scene, const ZoneKind kind, const bool adaptive)
{
  scene.plates[0].length       = 60e-3;
  scene.plates[0].width        = 32e-3;
  scene.plates[0].thickness    = 8e-3;
  scene.plates[0].zone_boxes   = {{2e-3, 28e-3, -8e-3, 8e-3}};
  scene.impact.speed           = 500.;
  scene.impact.entry_x         = 16e-3;
  scene.zone.kind              = kind;
  scene.zone.adaptive          = adaptive;
  scene.zone.coarsening_levels = 0;
  return scene;
}

struct Case
{
  const char *name;
  Scene scene;

  /// How GoogleTest shows it.
  friend void PrintTo(const Case &c, std::ostream *out) { *out << c.name; }
};

class SimilarScenes : public testing::TestWithParam<Case>
{
};

INSTANTIATE_TEST_SUITE_P(
    Kinds, SimilarScenes,
    testing::Values(Case{"Everything", small_scene()},
                    Case{"EverythingHalf", symmetric(small_scene())},
                    Case{"TwoPlates", two_plates()}, Case{"JoinedPlates", joined(two_plates())},
                    Case{"TwoProjectiles", two_projectiles(small_scene())},
                    Case{"Relaxing", relaxing(small_scene(), HistoryPrecision::single_precision)},
                    Case{"Automatic", with_zone(small_scene(), ZoneKind::automatic, false)},
                    Case{"Adaptive", with_zone(small_scene(), ZoneKind::automatic, true)},
                    Case{"AdaptiveHalf",
                         symmetric(with_zone(small_scene(), ZoneKind::automatic, true))},
                    Case{"Boxes", with_zone(small_scene(), ZoneKind::boxes, false)},
                    Case{"Elements", with_zone(small_scene(), ZoneKind::none, false)},
                    Case{"ProjectileOfElements", deformable(small_scene())},
                    Case{"ProjectileOfPoints", peridynamic(small_scene())},
                    Case{"ProjectileOfBoth", peridynamic_nose(small_scene())}),
    [](const auto &info) { return info.param.name; });

TEST_P(SimilarScenes, HaveSimilarResultsToTheLastBit)
{
  const Scene &scene = GetParam().scene;
  const auto course  = course_of(scene, 120, 10);
  if (scene.zone.kind != ZoneKind::none)
  {
    EXPECT_GT(course.broken_bonds, 100.);
  }
  EXPECT_EQ(course.n_conversions > 0, scene.zone.adaptive);
  for (const Scale scale : {Scale{1., 0.25, 1.}, Scale{64., 2., 0.25}})
  {
    const auto other = course_of(similar(scene, scale), 120, 10);
    expect_similar(course, other, scale);
    verify_at_most("V28", "similarity: numbers of the history that differ, in units of the scales",
                   n_different(course, other, scale), 0.);
  }
}

TEST(SimilarScenesControl, WithOneQuantityInTheOldScaleAreNotSimilar)
{
  const Scale scale{1., 0.25, 1.};
  Scene other                    = similar(small_scene(), scale);
  other.contact.shank_resistance = small_scene().contact.shank_resistance;
  verify_at_least("V28", "similarity: the same if one quantity is left as it was",
                  n_different(course_of(small_scene(), 120, 10), course_of(other, 120, 10), scale),
                  100.);
}

/// As a user writes them, with units: a quarter of the speed.
TEST(SimilarFiles, HaveSimilarResultsWithEveryKindOfZone)
{
  const std::string folder = std::string(RICOCHET_SOURCE_DIR) + "/tests/cases/";
  for (const char *zone : {"everything", "automatic", "adaptive"})
  {
    const bool adaptive = std::string(zone) == "adaptive";
    const auto overrides =
        parse_overrides({"Coupling/Zone=" + std::string(adaptive ? "automatic" : zone),
                         "Coupling/Adaptive=" + std::string(adaptive ? "true" : "false")});
    const auto course_of_file = [&](const char *name)
    { return course_of(read_scene(ParameterFile(folder + name, overrides)), 100, 10); };
    SCOPED_TRACE(zone);
    expect_similar(course_of_file("similar_1.prm"), course_of_file("similar_2.prm"),
                   {1., 0.25, 1.});
  }
}
} // namespace
} // namespace ricochet::tests
