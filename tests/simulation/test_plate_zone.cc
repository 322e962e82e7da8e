// SPDX-License-Identifier: LGPL-2.1-or-later
// From a scene to lattice, zone and elements.
#include "support/coupled_plate.h"
#include "support/coupled_scene.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/simulation/plate_size.h"
#include "ricochet/simulation/plate_zone.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
Scene big_plate()
{
  Scene scene               = small_scene();
  scene.plates[0].length    = 0.2;
  scene.plates[0].width     = 0.1;
  scene.plates[0].thickness = 0.03;
  scene.plates[0].spacing   = 1.5e-3;
  scene.impact.entry_x      = 0.05;
  return scene;
}

PlateZone zone_of(const Scene &scene)
{
  const auto &plate = scene.plates[0];
  const auto n      = lattice_points(scene, plate);
  const Lattice::Box box{
      {0., scene.symmetric ? 0. : -0.5 * n[1] * plate.spacing, -n[2] * plate.spacing},
      plate.spacing,
      n,
      scene.symmetric};
  return plate_zone(scene, plate, box,
                    make_stencil(plate.spacing, plate.horizon_ratio, plate.influence_function));
}

using Points = std::array<int, 3>;

TEST(PlateZone, CellsHoldAsManyPointsAsElementsMay)
{
  Scene scene               = big_plate();
  scene.zone.kind           = ZoneKind::automatic;
  scene.plates[0].thickness = 24e-3; // 16 points
  for (const int n : {1, 2, 4})
  {
    scene.zone.coupling.points_per_edge = n;
    EXPECT_EQ(zone_of(scene).zone->n_cells(), (Points{136 / n, 64 / n, 16 / n})) << n;
  }
}

TEST(PlateZone, EverythingHasNoElements)
{
  const auto zone = zone_of(big_plate());
  EXPECT_EQ(zone.zone, nullptr);
  EXPECT_EQ(zone.reason, "everything");
}

TEST(PlateZone, NoneHasNoPoints)
{
  Scene scene     = big_plate();
  scene.zone.kind = ZoneKind::none;
  const auto zone = zone_of(scene);
  ASSERT_NE(zone.zone, nullptr);
  EXPECT_EQ(zone.zone->n_free_cells(), 0);
  EXPECT_NE(zone.reason.find("elastic"), std::string::npos);
}

/// The zone's cells are a column through the thickness; from and to along x and y.
std::array<int, 4> column(const Zone &zone)
{
  std::array<int, 4> range{1 << 20, -1, 1 << 20, -1};
  const auto n = zone.n_cells();
  zone.for_each_cell(
      [&](const Zone::Cell &cell)
      {
        if (!zone.is_free(cell))
          return;
        range = {std::min(range[0], cell[0]), std::max(range[1], cell[0] + 1),
                 std::min(range[2], cell[1]), std::max(range[3], cell[1] + 1)};
      });
  EXPECT_EQ(zone.n_free_cells(), std::int64_t(range[1] - range[0]) * (range[3] - range[2]) * n[2]);
  return range;
}

TEST(PlateZone, BoxesAreRoundedOutwardsToCells)
{
  Scene scene                  = big_plate();
  scene.zone.kind              = ZoneKind::boxes;
  scene.zone.coarsening_levels = 0; // 67 x 33 cells of 3 mm, y from -49.5 mm
  scene.plates[0].zone_boxes   = {{31e-3, 89e-3, -19e-3, 19e-3}};
  const auto range             = column(*zone_of(scene).zone);
  EXPECT_EQ(range, (std::array<int, 4>{10, 30, 10, 23}));
  // A box that fits stays; one beyond the plate is cut.
  scene.plates[0].zone_boxes = {{30e-3, 90e-3, -1., 1.}};
  EXPECT_EQ(column(*zone_of(scene).zone), (std::array<int, 4>{10, 30, 0, 33}));
}

TEST(PlateZone, AutomaticZoneHoldsTheCorridorAndAnAdaptiveOneItsBeginning)
{
  for (const bool symmetric : {false, true})
  {
    Scene scene      = big_plate();
    scene.symmetric  = symmetric;
    scene.zone.kind  = ZoneKind::automatic;
    const auto fixed = zone_of(scene);
    EXPECT_NE(fixed.reason.find("automatic"), std::string::npos);
    EXPECT_NE(fixed.reason.find("calibres"), std::string::npos);
    scene.zone.adaptive = true;
    const auto growing  = zone_of(scene);
    const auto large = column(*fixed.zone), small = column(*growing.zone);
    EXPECT_LT(growing.zone->n_free_cells(), fixed.zone->n_free_cells());
    // The entry point lies in both, one inside the other.
    const double cell = 3e-3;
    const int entry_x = static_cast<int>(scene.impact.entry_x / cell);
    const int entry_y = symmetric ? 0 : fixed.zone->n_cells()[1] / 2;
    for (const auto &range : {large, small})
    {
      EXPECT_LE(range[0], entry_x);
      EXPECT_GT(range[1], entry_x);
      EXPECT_LE(range[2], entry_y);
      EXPECT_GT(range[3], entry_y);
    }
    EXPECT_LE(large[0], small[0]);
    EXPECT_GE(large[1], small[1]);
    // It may grow as far as the fixed one is.
    EXPECT_LE(growing.zone->limit().low[0], large[0]);
    EXPECT_GE(growing.zone->limit().high[0], large[1]);
    EXPECT_LT(growing.zone->limit().high[0], growing.zone->n_cells()[0]);
    scene.zone.grows_everywhere = true;
    const auto everywhere       = zone_of(scene);
    EXPECT_EQ(everywhere.zone->limit().low, (Points{0, 0, 0}));
    EXPECT_EQ(everywhere.zone->limit().high, everywhere.zone->n_cells());
  }
}

TEST(PlateZone, AdaptiveZoneMayGrowAtLeastAsFarAsTheFixedOneIs)
{
  Scene scene     = big_plate();
  scene.zone.kind = ZoneKind::automatic;
  scene.plates[0].length *= 3.;
  for (const double speed : {300., 500., 720., 928.})
    for (const double angle : {10., 30., 45., 60.})
    {
      scene.impact.speed           = speed;
      scene.impact.incidence_angle = angle * 3.14159265358979 / 180.;
      scene.zone.adaptive          = false;
      const auto fixed             = column(*zone_of(scene).zone);
      scene.zone.adaptive          = true;
      const auto limit             = zone_of(scene).zone->limit();
      EXPECT_LE(limit.low[0], fixed[0]) << speed << " m/s, " << angle;
      EXPECT_GE(limit.high[0], fixed[1]) << speed << " m/s, " << angle;
      EXPECT_LE(limit.low[1], fixed[2]) << speed << " m/s, " << angle;
      EXPECT_GE(limit.high[1], fixed[3]) << speed << " m/s, " << angle;
    }
}

TEST(PlateZone, PlatesOfAStackCanBeTouchedWhereverAnyOfThemMayHavePoints)
{
  for (const bool adaptive : {false, true})
  {
    Scene scene                  = big_plate();
    scene.zone.kind              = ZoneKind::automatic;
    scene.zone.adaptive          = adaptive;
    scene.impact.incidence_angle = 0.35;
    scene.plates[0].length *= 2.;
    scene.plates.push_back(scene.plates[0]);
    std::vector<PlateZone> zones;
    for (const double top : {0., -scene.plates[0].thickness})
    {
      const auto &plate = scene.plates[0];
      const auto n      = lattice_points(scene, plate);
      const Lattice::Box box{
          {0., -0.5 * n[1] * plate.spacing, top - n[2] * plate.spacing}, plate.spacing, n, false};
      zones.push_back(
          plate_zone(scene, plate, box,
                     make_stencil(plate.spacing, plate.horizon_ratio, plate.influence_function)));
    }
    const auto &n = zones[0].zone->n_cells();
    for (const auto &one : zones)
      for (const auto &other : zones)
        for (int i = one.zone->limit().low[0] - one.zone->slaved_layers();
             i < one.zone->limit().high[0] + one.zone->slaved_layers(); ++i)
          for (int j = one.zone->limit().low[1] - one.zone->slaved_layers();
               j < one.zone->limit().high[1] + one.zone->slaved_layers(); ++j)
            for (const int k : {0, n[2] - 1})
              EXPECT_TRUE(!other.zone->contains({i, j, k}) ||
                          other.zone->layer({i, j, k}) < other.zone->far() ||
                          other.zone->has_contact({i, j, k}))
                  << i << ' ' << j << ' ' << k;
  }
}

TEST(PlateZone, FasterProjectilesNeedLongerCorridors)
{
  Scene scene                  = big_plate();
  scene.zone.kind              = ZoneKind::automatic;
  scene.impact.incidence_angle = 10. * M_PI / 180.;
  scene.impact.speed           = 300.;
  const auto slow              = column(*zone_of(scene).zone);
  scene.impact.speed           = 600.;
  const auto fast              = column(*zone_of(scene).zone);
  EXPECT_GT(fast[1], slow[1]);
  EXPECT_EQ(fast[0], slow[0]);
}

TEST(PlateZone, ZoneOfTheWholePlateIsPeridynamics)
{
  // Elements everywhere switched off: the very forces of a plate without a zone.
  CoupledSample sample;
  sample.communicator = MPI_COMM_SELF;
  sample.n_cells      = {6, 5, 4};
  sample.zone         = {{0, 0, 0}, {6, 5, 4}};
  PlateModel plate(sample);
  EXPECT_EQ(plate.far->elements().total_mass(), 0.);
  PeridynamicBody alone(MPI_COMM_SELF, 0, plate.points->lattice().box(),
                        plate.points->lattice().stencil(), plate.points->material());
  const auto map = [](const Vector3 &X) -> Vector3
  {
    const Vector3 c = 1e3 * X;
    return X + 1e-6 * Vector3(std::sin(12.9 * c[0] + 78.2 * c[1]), std::sin(37.7 * c[1] + c[2]),
                              std::sin(9.1 * c[2] + 11.1 * c[0]));
  };
  plate.deform(map);
  const auto &lattice = alone.lattice();
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 x = map(lattice.reference_position(lattice.coordinates(p)));
        for (int d = 0; d < 3; ++d)
          alone.state().arrays.position[d][p] = x[d];
      });
  alone.update_ghosts();
  alone.break_bonds();
  alone.compute_internal_forces({true});
  double n = 0.;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        for (int d = 0; d < 3; ++d)
          EXPECT_EQ(plate.points->state().arrays.force[d][p], alone.state().arrays.force[d][p]);
        n += 1.;
      });
  EXPECT_EQ(n, 8. * 6 * 5 * 4);
  EXPECT_GT(alone.energies(0.).strain, 0.);
  EXPECT_EQ(plate.far->energies(0.).strain, alone.energies(0.).strain);
}

TEST(PlateZone, ProjectileThatTouchesElementsIsNoticed)
{
  for (const double begin : {2e-3, 20e-3}) // the entry point is at 8e-3
    for (const auto &scene_of :
         {+[](Scene scene) { return scene; }, +[](Scene scene) { return deformable(scene); }})
    {
      Scene scene                = scene_of(coupled_scene());
      scene.plates[0].zone_boxes = {{begin, 28e-3, -8e-3, 8e-3}};
      Simulation simulation(MPI_COMM_SELF, scene);
      for (int step = 0; step < 200 && simulation.reaction().n_touching == 0.; ++step)
      {
        simulation.compute_forces(/*energy=*/false);
        simulation.advance();
      }
      ASSERT_GT(simulation.reaction().n_touching, 0.);
      EXPECT_EQ(simulation.reaction().on_elements, begin > 8e-3);
    }
}
} // namespace
} // namespace ricochet::tests
