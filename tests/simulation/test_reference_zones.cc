// SPDX-License-Identifier: LGPL-2.1-or-later
// The zones of the scenes in prm/ on which doc/coupling.md and doc/viscoelastic.md report: their
// cells are part of what was measured, so a change of the corridor must not move them unnoticed.
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/plate_size.h"
#include "ricochet/simulation/plate_zone.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// From and to along x, from and to along y, in cells.
using Columns = std::array<int, 4>;

Columns columns_of(const Zone::Cells &cells)
{
  return {cells.low[0], cells.high[0], cells.low[1], cells.high[1]};
}

struct Zones
{
  Columns start, limit;
};

/// Of each plate, from top to bottom.
std::vector<Zones> zones_of(const Scene &scene)
{
  std::vector<Zones> zones;
  double top = 0.;
  for (const auto &plate : scene.plates)
  {
    const auto n = lattice_points(scene, plate);
    top -= zones.empty() ? 0. : plate.gap;
    const double bottom = top - n[2] * plate.spacing;
    const Lattice::Box box{{0., scene.symmetric ? 0. : -0.5 * n[1] * plate.spacing, bottom},
                           plate.spacing,
                           n,
                           scene.symmetric};
    const auto zone =
        plate_zone(scene, plate, box,
                   make_stencil(plate.spacing, plate.horizon_ratio, plate.influence_function));
    Zone::Cells start{zone.zone->n_cells(), {0, 0, 0}};
    zone.zone->for_each_cell(
        [&](const Zone::Cell &cell)
        {
          for (int d = 0; d < 3 && zone.zone->is_free(cell); ++d)
          {
            start.low[d]  = std::min(start.low[d], cell[d]);
            start.high[d] = std::max(start.high[d], cell[d] + 1);
          }
        });
    zones.push_back({columns_of(start), columns_of(zone.zone->limit())});
    top = bottom;
  }
  return zones;
}

std::vector<Zones> zones_of(const std::string &file, const std::vector<std::string> &overrides)
{
  return zones_of(read_scene(ParameterFile(std::string(RICOCHET_SOURCE_DIR) + "/prm/" + file,
                                           parse_overrides(overrides))));
}

struct Reference
{
  std::string file;
  std::vector<std::string> overrides;
  std::vector<Zones> zones;
};

// Plates and strength with which doc/coupling.md was measured.
const std::string stretch   = "Material PMMA/Critical stretch=0.0105",
                  spacing   = "Plate 1/Grid spacing=1.0 mm",
                  plate     = "Plate 1/Size=198 mm, 96 mm, 30 mm",
                  wide      = "Plate 1/Size=402 mm, 204 mm, 30 mm",
                  single    = "Plate 1/Size=200 mm, 100 mm, 30 mm",
                  automatic = "Coupling/Zone=automatic";

const std::vector<Reference> references{
    {"coupled/base_automatic.prm", {plate, stretch}, {{{11, 53, 0, 6}, {11, 53, 0, 6}}}},
    {"coupled/base_automatic.prm", {plate, stretch, spacing}, {{{17, 80, 0, 8}, {17, 80, 0, 8}}}},
    {"coupled/base_adaptive.prm", {plate, stretch}, {{{12, 24, 0, 5}, {11, 63, 0, 6}}}},
    {"coupled/base_adaptive.prm", {plate, stretch, spacing}, {{{19, 34, 0, 6}, {17, 94, 0, 8}}}},
    {"coupled/base_adaptive.prm", {wide, stretch}, {{{12, 24, 0, 5}, {11, 63, 0, 6}}}},
    {"viscoelastic/base.prm", {}, {{{19, 34, 0, 6}, {17, 94, 0, 8}}}},
    {"three_layers/coupled.prm",
     {stretch, "Plate 1/Size=300 mm, 150 mm, 30 mm", "Plate 2/Size=300 mm, 150 mm, 30 mm",
      "Plate 3/Size=300 mm, 150 mm, 30 mm"},
     {{{13, 30, 0, 7}, {12, 100, 0, 8}},
      {{31, 48, 0, 7}, {29, 100, 0, 8}},
      {{48, 65, 0, 7}, {46, 100, 0, 8}}}},
    {"single_plate/speed_500.prm",
     {automatic, single, stretch},
     {{{11, 53, 0, 6}, {11, 53, 0, 6}}}},
    {"single_plate/speed_800.prm",
     {automatic, single, stretch},
     {{{11, 53, 0, 6}, {11, 53, 0, 6}}}},
    {"single_plate/angle_10.prm", {automatic, single, stretch}, {{{11, 49, 0, 6}, {11, 49, 0, 6}}}},
    {"single_plate/angle_20.prm", {automatic, single, stretch}, {{{11, 61, 0, 6}, {11, 61, 0, 6}}}},
    {"single_plate/angle_45.prm", {automatic, single, stretch}, {{{11, 46, 0, 6}, {11, 46, 0, 6}}}},
    {"single_plate/angle_60.prm", {automatic, single, stretch}, {{{11, 42, 0, 6}, {11, 42, 0, 6}}}},
};

TEST(ReferenceZones, KeepTheirCells)
{
  for (const auto &reference : references)
  {
    const auto zones = zones_of(reference.file, reference.overrides);
    ASSERT_EQ(zones.size(), reference.zones.size()) << reference.file;
    for (std::size_t i = 0; i < zones.size(); ++i)
    {
      EXPECT_EQ(zones[i].start, reference.zones[i].start) << reference.file << ", plate " << i + 1;
      EXPECT_EQ(zones[i].limit, reference.zones[i].limit) << reference.file << ", plate " << i + 1;
    }
  }
}
} // namespace
} // namespace ricochet::tests
