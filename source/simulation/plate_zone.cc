// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/plate_zone.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/coupling/zone_extent.h"
#include "ricochet/simulation/plate_size.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
Zone::Cells columns(const Lattice::Box &box, const int points_per_edge, const double x_low,
                    const double x_high, const double y_low, const double y_high)
{
  const double cell = points_per_edge * box.spacing;
  const auto from   = [&](const double x, const int d)
  { return static_cast<int>(std::floor((x - box.corner[d]) / cell + 1e-9)); };
  const auto to = [&](const double x, const int d)
  { return static_cast<int>(std::ceil((x - box.corner[d]) / cell - 1e-9)); };
  Zone::Cells cells{{from(x_low, 0), from(y_low, 1), 0},
                    {to(x_high, 0), to(y_high, 1), box.n[2] / points_per_edge}};
  for (int d = 0; d < 3; ++d)
  {
    const int n   = box.n[d] / points_per_edge;
    cells.low[d]  = std::clamp(cells.low[d], 0, n);
    cells.high[d] = std::clamp(cells.high[d], 0, n);
  }
  return cells;
}

/// On a plate whose upper face lies so deep below that of the first.
ImpactGeometry impact_on(const Scene &scene, const double depth, const double thickness,
                         const double horizon)
{
  return {scene.projectile.shape.diameter,
          scene.projectile.shape.length,
          scene.impact.speed,
          scene.impact.incidence_angle,
          scene.impact.entry_x,
          scene.impact.entry_y,
          depth,
          thickness,
          horizon};
}

/// The smallest box around all; without any, an empty one.
Zone::Cells hull(const std::vector<Zone::Cells> &boxes)
{
  Zone::Cells cells{};
  bool empty = true;
  for (const auto &box : boxes)
  {
    if (box.low[0] >= box.high[0])
      continue;
    if (empty)
      cells = box;
    empty = false;
    for (int d = 0; d < 3; ++d)
    {
      cells.low[d]  = std::min(cells.low[d], box.low[d]);
      cells.high[d] = std::max(cells.high[d], box.high[d]);
    }
  }
  return cells;
}

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

/// The cells of one plate that choices of a zone mean.
class ZoneCells
{
public:
  ZoneCells(const Scene &scene, const Lattice::Box &box) :
    scene_(scene), box_(box), edge_(scene.zone.coupling.points_per_edge)
  {
  }

  /// A choice is no sharp limit: the nearest cells will do.
  Zone::Cells of(const ZoneChoice &choice) const
  {
    const double cell  = edge_ * box_.spacing;
    const auto nearest = [&](const double x, const int d)
    { return box_.corner[d] + cell * std::round((x - box_.corner[d]) / cell); };
    return columns(box_, edge_, nearest(choice.x_low, 0), nearest(choice.x_high, 0),
                   nearest(choice.y_low, 1), nearest(choice.y_high, 1));
  }

  /// Boxes that were asked for are filled.
  std::vector<Zone::Cells> boxes_of(const PlateParameters &plate) const
  {
    std::vector<Zone::Cells> cells;
    if (scene_.zone.kind == ZoneKind::boxes)
      for (const auto &b : plate.zone_boxes)
        cells.push_back(columns(box_, edge_, b[0], b[1], b[2], b[3]));
    return cells;
  }

  /// The corridor, or all that a growing zone may become.
  Zone::Cells widest(const ImpactGeometry &impact) const
  {
    const auto corridor = of(corridor_zone(impact));
    return scene_.zone.adaptive ? hull({corridor, of(growth_limit(impact))}) : corridor;
  }

  /// Where a plate must be ready to be touched: in a stack, wherever any plate has points or may
  /// get some, those around its zone included. What lay in the other plate before it could be
  /// touched would be thrown out of it.
  Zone::Cells touchable() const
  {
    Zone::Cells all{};
    double depth = 0.;
    for (const auto &plate : scene_.plates)
    {
      depth += &plate == &scene_.plates.front() ? 0. : plate.gap;
      const Stencil stencil =
          make_stencil(plate.spacing, plate.horizon_ratio, plate.influence_function);
      auto cells = hull({widest(impact_on(scene_, depth, plate.thickness, stencil.horizon)),
                         hull(boxes_of(plate))});
      // Pad and halo of that plate, in cells of this one.
      const double layers =
          make_zone({1, 1, 1}, stencil, scene_.zone.coupling).slaved_layers() * plate.spacing;
      const int margin = static_cast<int>(std::ceil(layers / box_.spacing - 1e-9));
      for (int d = 0; d < 2; ++d)
      {
        cells.low[d] -= margin;
        cells.high[d] += margin;
      }
      all = hull({all, cells});
      depth += plate.thickness;
    }
    return all;
  }

private:
  const Scene &scene_;
  const Lattice::Box &box_;
  int edge_;
};
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

  const auto impact =
      impact_on(scene, -(box.corner.z() + n[2] * box.spacing), n[2] * box.spacing, stencil.horizon);
  const ZoneCells cells(scene, box);
  auto boxes = cells.boxes_of(plate);
  switch (scene.zone.kind)
  {
    case ZoneKind::automatic:
    {
      const auto choice = scene.zone.adaptive ? entry_zone(impact) : corridor_zone(impact);
      result.reason     = "automatic: " + choice.reason;
      boxes             = {cells.of(choice)};
      break;
    }
    case ZoneKind::boxes:
      result.reason = "boxes";
      break;
    default:
      result.reason = "none: elastic finite elements";
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
    limit               = hull({limit, cells.widest(impact)});
    result.growth_ahead = growth_ahead(impact);
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
