// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/far_field.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
// Relative cost of elements, for their distribution over ranks: switched off, one Gauss point, own
// tensors at eight.
constexpr unsigned int cost_of_none = 1, cost_of_one = 10, cost_of_slaved = 60;

int cells_in(const double horizons, const Stencil &stencil)
{
  return std::max(
      1, static_cast<int>(std::ceil(
             horizons * stencil.horizon / stencil.spacing / Zone::points_per_edge - 1e-9)));
}

int layers_for_horizon(const Stencil &stencil)
{
  return (stencil.reach + Zone::points_per_edge - 1) / Zone::points_per_edge;
}

HexMesh::Box mesh_box(const PeridynamicForce &points, const Zone &zone,
                      const FarFieldOptions &options)
{
  const auto &box    = points.lattice().box();
  const double cell  = Zone::points_per_edge * box.spacing;
  const int multiple = Zone::points_per_edge << options.coarsening_levels;
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
  mesh.cost = [&zone, &box, cell](const Vector3 &centre, const double edge)
  {
    const auto at = cell_at(box, centre);
    return edge > 1.5 * cell || (!zone.is_free(at) && !zone.is_slaved(at)) ? cost_of_one
           : zone.is_free(at)                                              ? cost_of_none
                                                                           : cost_of_slaved;
  };
  return mesh;
}

FiniteElementForce::Options element_options(const PeridynamicForce &points, const Zone &zone,
                                            const FarFieldOptions &options)
{
  FiniteElementForce::Options result;
  result.quadrature            = options.quadrature;
  result.hourglass_coefficient = options.hourglass_coefficient;
  result.active                = [&zone, &points](const Vector3 &centre)
  { return !zone.is_free(cell_at(points.lattice().box(), centre)); };
  return result;
}

FiniteElementMaterial material_of(const PeridynamicForce &points)
{
  const auto &m = points.material();
  return {m.density, m.bulk_modulus, m.shear_modulus};
}

/// The blend as a function of the distance from the zone in parts of its width.
double blend(const BlendFunction function, const double t)
{
  if (t <= 0. || t >= 1. || function == BlendFunction::step)
    return t < 1. ? 1. : 0.;
  return function == BlendFunction::linear ? 1. - t : 1. - t * t * (3. - 2. * t);
}
} // namespace

Zone make_zone(const std::array<int, 3> &n_cells, const Stencil &stencil,
               const CouplingParameters &coupling)
{
  const int layers = cells_in(coupling.blend_width, stencil);
  switch (coupling.method)
  {
    case CouplingMethod::energy_blend:
      return Zone(n_cells, stencil.reach, coupling.blend, layers);
    case CouplingMethod::force_blend: // the forces of blended points are needed in full
      return Zone(n_cells, stencil.reach, BlendFunction::step,
                  layers + layers_for_horizon(stencil));
    default:
      return Zone(n_cells, stencil.reach);
  }
}

FarField::FarField(const MPI_Comm communicator, PeridynamicForce &points, Zone &zone,
                   const FarFieldOptions &options) :
  communicator_(communicator),
  points_(points), zone_(zone), options_(options),
  elements_(communicator, mesh_box(points, zone, options), material_of(points),
            element_options(points, zone, options)),
  calibration_(communicator, points, elements_, options.coupling.calibration)
{
  join();
  lead();
}

void FarField::join()
{
  const auto &mesh = elements_.mesh();
  const auto &box  = points_.lattice().box();
  switch (options_.coupling.method)
  {
    case CouplingMethod::calibrated_energy_blend:
      elements_.set_stiffness(calibration_.find());
      break;
    case CouplingMethod::energy_blend:
      elements_.set_stiffness(blended_stiffness());
      break;
    case CouplingMethod::force_blend:
    case CouplingMethod::none:
      break;
  }

  const double cell = Zone::points_per_edge * box.spacing;
  if (options_.coupling.correct_mass)
  {
    std::vector<int> pad;
    for (std::size_t e = 0; e < mesh.elements().size(); ++e)
    {
      const auto &element = mesh.elements()[e];
      if (element.edge > 1.5 * cell)
        continue;
      const int layer = zone_.layer(cell_at(box, mesh.centre(element)));
      if (layer > 0 && layer <= zone_.pad_layers())
        pad.push_back(static_cast<int>(e));
    }
    elements_.set_consistent_mass(pad);
  }
  slaved_ = SlavedPoints(communicator_, elements_, points_.lattice(),
                         [&](const Zone::Cell &at)
                         { return zone_.is_slaved(at) || zone_.has_contact(at); });

  if (options_.coupling.method == CouplingMethod::force_blend)
  {
    const int width = cells_in(options_.coupling.blend_width, points_.lattice().stencil());
    bond_share_.clear();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    {
      // Layer of the nearest cell around the node: its distance from the zone in cells.
      const Vector3 at = (mesh.reference_position(node) - box.corner) / cell;
      int distance     = std::numeric_limits<int>::max();
      for (int corner = 0; corner < 8; ++corner)
      {
        Zone::Cell around;
        for (int d = 0; d < 3; ++d)
          around[d] = static_cast<int>(std::lround(at[d])) - ((corner >> d) & 1);
        if (zone_.contains(around))
          distance = std::min(distance, zone_.layer(around));
      }
      bond_share_.push_back(blend(options_.coupling.blend, double(distance) / width));
    }
  }
}

/// 1 minus the mean weight of the points in an element, times the material's stiffness.
std::vector<ElementStiffness> FarField::blended_stiffness() const
{
  const auto &mesh    = elements_.mesh();
  const auto &box     = points_.lattice().box();
  const double cell   = Zone::points_per_edge * box.spacing;
  const double mu     = elements_.material().shear_modulus,
               lambda = elements_.material().bulk_modulus - 2. / 3. * mu;
  std::vector<ElementStiffness> stiffness;
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
  {
    const auto &element = mesh.elements()[e];
    const auto at       = cell_at(box, mesh.centre(element));
    if (element.edge > 1.5 * cell || !zone_.is_slaved(at))
      continue;
    double share = 1.;
    for (int sub = 0; sub < 8; ++sub)
      share -= 0.125 * zone_.weight(2 * at[0] + (sub & 1), 2 * at[1] + ((sub >> 1) & 1),
                                    2 * at[2] + (sub >> 2));
    ElementStiffness own{static_cast<int>(e), {}};
    for (auto &tensor : own.tensors)
      for (int i = 0, k = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j, ++k)
          tensor[k] = share * ((j < 3 ? lambda : 0.) + (i == j ? (i < 3 ? 2. : 1.) * mu : 0.));
    stiffness.push_back(own);
  }
  return stiffness;
}

void FarField::lead()
{
  elements_.update_ghosts();
  slaved_.follow(elements_, points_.state());
}

void FarField::evaluate(const bool energy)
{
  elements_.evaluate(energy);
  if (options_.coupling.method == CouplingMethod::force_blend)
    blend_forces();
  else
    slaved_.hand_on(points_.state(), elements_.force());
  elements_.correct_mass();
}

void FarField::blend_forces()
{
  bond_force_.assign(elements_.force().size(), 0.);
  slaved_.hand_on(points_.state(), bond_force_);
  for (std::size_t i = 0; i < 3 * bond_share_.size(); ++i)
  {
    const double share   = bond_share_[i / 3];
    elements_.force()[i] = (1. - share) * elements_.force()[i] + share * bond_force_[i];
  }
}

FarField::Energies FarField::energies(const double dt) const
{
  const auto points = points_.energies(dt);
  const auto nodes  = elements_.energies(dt);
  return {points.kinetic + nodes.kinetic, points.strain + nodes.strain, nodes.hourglass};
}

PeridynamicForce::Momenta FarField::momenta() const
{
  const auto points = points_.momenta();
  const auto nodes  = elements_.momenta();
  return {points.linear + nodes.linear, points.angular + nodes.angular};
}

bool FarField::convert(const std::vector<Zone::Cells> &cells)
{
  std::vector<std::uint8_t> before;
  zone_.for_each_cell([&](const Zone::Cell &cell)
                      { before.push_back(static_cast<std::uint8_t>(zone_.layer(cell))); });
  if (!zone_.grow(cells))
    return false;
  int first = zone_.n_cells()[0], last = 0;
  std::size_t i = 0;
  std::vector<bool> was_free(before.size());
  zone_.for_each_cell(
      [&](const Zone::Cell &cell)
      {
        was_free[i] = before[i] == 0;
        if (before[i++] != zone_.layer(cell))
        {
          first = std::min(first, cell[0]);
          last  = std::max(last, cell[0] + 1);
        }
      });
  points_.follow_zone(Zone::points_per_edge * first, Zone::points_per_edge * last);

  // All points that did not move by themselves start from where the nodes are.
  SlavedPoints(communicator_, elements_, points_.lattice(),
               [&](const Zone::Cell &cell)
               { return !was_free[zone_.number(cell)] && zone_.layer(cell) < zone_.far(); })
      .follow(elements_, points_.state());

  const auto &box = points_.lattice().box();
  elements_.set_active([&](const Vector3 &centre) { return !zone_.is_free(cell_at(box, centre)); });
  join();
  lead();
  return true;
}
} // namespace ricochet
