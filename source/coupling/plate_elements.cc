// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plate_elements.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
// Relative cost of elements, for their distribution over ranks: switched off, one Gauss point, own
// tensors at eight.
constexpr unsigned int cost_of_none = 1, cost_of_one = 10, cost_of_slaved = 60;
} // namespace

int cells_in(const double horizons, const Stencil &stencil, const int points_per_edge)
{
  return std::max(1, static_cast<int>(std::ceil(
                         horizons * stencil.horizon / stencil.spacing / points_per_edge - 1e-9)));
}

HexMesh::Box mesh_box(const PeridynamicBody &points, const Zone &zone,
                      const CoupledPlateOptions &options)
{
  const auto &box    = points.lattice().box();
  const double cell  = zone.points_per_edge() * box.spacing;
  const int multiple = zone.points_per_edge() << options.coarsening_levels;
  HexMesh::Box mesh{box.corner, cell * (1 << options.coarsening_levels), {}, box.mirror_y, {}};
  for (int d = 0; d < 3; ++d)
  {
    if (box.n[d] % multiple != 0)
      throw InputError("A plate of " + std::to_string(box.n[0]) + " x " + std::to_string(box.n[1]) +
                       " x " + std::to_string(box.n[2]) +
                       " points cannot be divided into finite elements of " +
                       std::to_string(multiple) + " points along each axis.");
    mesh.n[d] = box.n[d] / multiple;
  }
  if (options.coarsening_levels > 0)
  {
    HexMesh::Region region{box.corner, box.corner, options.coarsening_levels};
    for (int d = 0; d < 3; ++d)
    {
      region.low[d] += cell * (options.fine_region.low[d] - 2);
      region.high[d] += cell * (options.fine_region.high[d] + 2);
    }
    mesh.regions.push_back(region);
  }
  mesh.cost = [&zone, &points, cell](const Vector3 &centre, const double edge)
  {
    const auto at = cell_at(points.lattice(), centre);
    return edge > 1.5 * cell || (!zone.is_free(at) && !zone.is_slaved(at)) ? cost_of_one
           : zone.is_free(at)                                              ? cost_of_none
                                                                           : cost_of_slaved;
  };
  return mesh;
}

FiniteElementBody::Options element_options(const PeridynamicBody &points, const Zone &zone,
                                           const CoupledPlateOptions &options)
{
  FiniteElementBody::Options result;
  result.quadrature            = options.quadrature;
  result.hourglass_coefficient = options.hourglass_coefficient;
  result.active                = [&zone, &points](const Vector3 &centre)
  { return !zone.is_free(cell_at(points.lattice(), centre)); };
  return result;
}

FiniteElementMaterial material_of(const PeridynamicBody &points)
{
  const auto &m = points.material();
  return {m.density, m.bulk_modulus, m.shear_modulus, m.relaxation,
          lattice_anisotropy(points.lattice().stencil(), *m.law, m.bulk_modulus, m.shear_modulus)};
}

double relaxing_share(const PeridynamicBody &points)
{
  double share = 0.;
  for (const auto &branch : points.material().relaxation)
    share += branch.share;
  return share;
}

Zone make_zone(const std::array<int, 3> &n_cells, const Stencil &stencil,
               const CouplingParameters &coupling)
{
  const int n      = coupling.points_per_edge;
  const int layers = cells_in(coupling.blend_width, stencil, n);
  switch (coupling.method)
  {
    case CouplingMethod::energy_blend:
      return Zone(n_cells, stencil.reach, coupling.blend, layers, n);
    case CouplingMethod::force_blend: // the forces of blended points are needed in full
      return Zone(n_cells, stencil.reach, BlendFunction::step, layers + (stencil.reach + n - 1) / n,
                  n);
    default:
      return Zone(n_cells, stencil.reach, BlendFunction::step, 0, n);
  }
}
} // namespace ricochet
