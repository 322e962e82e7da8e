// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/plate_zone.h"

#include "zone_cells.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/simulation/plate_size.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
/// Elements alone must carry edges that do not reflect.
void check_edges(const Zone &zone, const bool mirror_y)
{
  const auto &n = zone.n_cells();
  bool reached  = false;
  zone.for_each_cell(
      [&](const Zone::Cell &cell)
      {
        const bool at_edge = cell[0] == 0 || cell[0] == n[0] - 1 || (cell[1] == 0 && !mirror_y) ||
                             cell[1] == n[1] - 1;
        reached = reached || (at_edge && zone.layer(cell) < zone.far());
      });
  if (reached)
    throw InputError("The peridynamic zone, with the " + std::to_string(zone.slaved_layers()) +
                     " cells of points that follow elements around it, reaches an edge of its "
                     "plate, which 'Non-reflecting edges' leaves to elements alone. Enlarge the "
                     "plate's 'Size', choose a smaller zone ('Coupling/Zone', 'Zone box'), or set "
                     "'Non-reflecting edges = false'.");
}

Zone::Cells off_the_edges(Zone::Cells cells, const Zone &zone, const bool mirror_y)
{
  for (int d = 0; d < 2; ++d)
  {
    if (d == 0 || !mirror_y)
      cells.low[d] = std::max(cells.low[d], zone.slaved_layers() + 1);
    cells.high[d] = std::min(cells.high[d], zone.n_cells()[d] - zone.slaved_layers() - 1);
  }
  return cells;
}

} // namespace

PlateZone plate_zone(const Scene &scene, const PlateParameters &plate, const Lattice::Box &box,
                     const Stencil &stencil)
{
  PlateZone result;
  if (!scene.zone.has_elements())
  {
    result.reason = "everything";
    return result;
  }
  const auto &n  = box.n;
  const int edge = scene.zone.coupling.points_per_edge;
  result.zone    = std::make_unique<Zone>(
      make_zone({n[0] / edge, n[1] / edge, n[2] / edge}, stencil, scene.zone.coupling));
  result.options.coupling   = scene.zone.coupling;
  result.options.quadrature = scene.zone.full_quadrature ? Quadrature::full : Quadrature::one_point;
  result.options.hourglass_coefficient = scene.zone.hourglass_coefficient;
  result.options.coarsening_levels     = coarsening_levels(scene, plate);

  const auto impacts = impacts_on(scene, plate, -(box.corner.z() + n[2] * box.spacing),
                                  n[2] * box.spacing, stencil.horizon);
  const ZoneCells cells(scene, box);
  auto boxes = cells.boxes_of(plate);
  switch (scene.zone.kind)
  {
    case ZoneKind::automatic:
    {
      boxes.clear();
      for (const auto &impact : impacts)
      {
        const auto choice = scene.zone.adaptive ? entry_zone(impact) : corridor_zone(impact);
        result.reason += (boxes.empty() ? "automatic: " : "; ") + choice.reason;
        boxes.push_back(cells.of(choice));
      }
      break;
    }
    case ZoneKind::boxes:
      result.reason = "boxes";
      break;
    default:
      result.reason = "none: elastic finite elements";
  }
  if (const auto around = cells.around_cutouts_of(plate); !around.empty())
  {
    boxes.insert(boxes.end(), around.begin(), around.end());
    result.reason += "; and around holes, notches and cracks, with 2 horizons on all sides";
  }
  result.zone->grow(boxes);
  result.options.absorbing_edges = plate.absorbing_edges;
  if (plate.absorbing_edges)
    check_edges(*result.zone, box.mirror_y);

  Zone::Cells limit = hull(boxes);
  if (scene.zone.adaptive && scene.zone.grows_everywhere)
    limit = {{0, 0, 0}, result.zone->n_cells()};
  else if (scene.zone.adaptive)
  {
    limit               = hull({limit, cells.widest(impacts)});
    // Ahead of the one that has got farthest; the others' damage comes behind that.
    result.growth_ahead = growth_ahead(impacts.front());
    for (const auto &impact : impacts)
      result.growth_ahead = std::max(result.growth_ahead, growth_ahead(impact));
  }
  if (plate.absorbing_edges && scene.zone.adaptive)
    limit = off_the_edges(limit, *result.zone, box.mirror_y);
  result.zone->set_limit(limit);

  // Points need fine elements wherever they are or may get to, those for contact too.
  result.options.fine_region = hull({limit, cells.touchable()});
  result.zone->set_contact_region({result.options.fine_region});
  return result;
}
} // namespace ricochet
