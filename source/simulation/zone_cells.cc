// SPDX-License-Identifier: LGPL-2.1-or-later
#include "zone_cells.h"

#include "plate_builder.h"

#include "ricochet/base/elastic_constants.h"
#include "ricochet/simulation/plate_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
Stencil stencil_of(const PlateParameters &plate)
{
  return make_stencil(plate.spacing, plate.horizon_ratio, plate.influence_function);
}

/// E s_c, the least from the first plate down to this one: what comes through a weak plate comes
/// far [Pa].
double least_strength(const Scene &scene, const PlateParameters &last)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto &plate : scene.plates)
  {
    const auto &material = material_of(scene, plate);
    least = std::min(least, youngs_modulus(material.bulk_modulus, material.shear_modulus) *
                                critical_stretch(material, stencil_of(plate)));
    if (&plate == &last)
      break;
  }
  return least;
}
} // namespace

std::vector<ImpactOnPlate> impacts_on(const Scene &scene, const PlateParameters &plate,
                                      const double depth, const double thickness,
                                      const double horizon)
{
  std::vector<ImpactOnPlate> impacts;
  for (std::size_t i = 0; i < scene.n_projectiles(); ++i)
  {
    const auto &projectile = scene.projectile_at(i);
    const auto &impact     = scene.impact_at(i);
    impacts.push_back({projectile.shape.diameter, projectile.shape.length, projectile.mass,
                       impact.speed, impact.incidence_angle, impact.entry_x, impact.entry_y, depth,
                       thickness, horizon, least_strength(scene, plate)});
  }
  return impacts;
}

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

ZoneCells::ZoneCells(const Scene &scene, const Lattice::Box &box) :
  scene_(scene), box_(box), edge_(scene.zone.coupling.points_per_edge)
{
}

Zone::Cells ZoneCells::columns(const double x_low, const double x_high, const double y_low,
                               const double y_high) const
{
  const double cell = edge_ * box_.spacing;
  const auto n      = [&](const int d) { return box_.n[d] / edge_; };
  // Cut before it becomes a whole number: the path of a grazing shot has no end.
  const auto from   = [&](const double x, const int d)
  {
    const double number = std::floor((x - box_.corner[d]) / cell + 1e-9);
    return static_cast<int>(std::clamp<double>(number, 0., n(d)));
  };
  const auto to = [&](const double x, const int d)
  {
    const double number = std::ceil((x - box_.corner[d]) / cell - 1e-9);
    return static_cast<int>(std::clamp<double>(number, 0., n(d)));
  };
  return {{from(x_low, 0), from(y_low, 1), 0}, {to(x_high, 0), to(y_high, 1), n(2)}};
}

Zone::Cells ZoneCells::of(const ZoneChoice &choice) const
{
  const double cell  = edge_ * box_.spacing;
  const auto nearest = [&](const double x, const int d)
  { return box_.corner[d] + cell * std::round((x - box_.corner[d]) / cell); };
  return columns(nearest(choice.x_low, 0), nearest(choice.x_high, 0), nearest(choice.y_low, 1),
                 nearest(choice.y_high, 1));
}

std::vector<Zone::Cells> ZoneCells::boxes_of(const PlateParameters &plate) const
{
  std::vector<Zone::Cells> cells;
  if (scene_.zone.kind == ZoneKind::boxes)
    for (const auto &b : plate.zone_boxes)
      cells.push_back(columns(b[0], b[1], b[2], b[3]));
  return cells;
}

std::vector<Zone::Cells> ZoneCells::around_cutouts_of(const PlateParameters &plate) const
{
  const double margin = interface_margin * plate.horizon_ratio * plate.spacing;
  std::vector<Zone::Cells> cells;
  for (const auto &c : plate.cutouts.columns())
    cells.push_back(columns(c[0] - margin, c[1] + margin, c[2] - margin, c[3] + margin));
  return cells;
}

Zone::Cells ZoneCells::widest(const std::vector<ImpactOnPlate> &impacts) const
{
  std::vector<Zone::Cells> boxes;
  for (const auto &impact : impacts)
  {
    boxes.push_back(of(corridor_zone(impact)));
    if (scene_.zone.adaptive)
      boxes.push_back(of(growth_limit(impact)));
  }
  return hull(boxes);
}

Zone::Cells ZoneCells::touchable() const
{
  Zone::Cells all{};
  double depth = 0.;
  for (const auto &plate : scene_.plates)
  {
    depth += &plate == &scene_.plates.front() ? 0. : plate.gap;
    const Stencil stencil = stencil_of(plate);
    auto cells = hull({widest(impacts_on(scene_, plate, depth, plate.thickness, stencil.horizon)),
                       hull(boxes_of(plate)), hull(around_cutouts_of(plate))});
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
} // namespace ricochet
