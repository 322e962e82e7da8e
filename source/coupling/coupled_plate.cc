// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/coupled_plate.h"

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
  return {m.density, m.bulk_modulus, m.shear_modulus, m.relaxation};
}

/// Of the shear modulus [-].
double relaxing_share(const PeridynamicBody &points)
{
  double share = 0.;
  for (const auto &branch : points.material().relaxation)
    share += branch.share;
  return share;
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

CoupledPlate::CoupledPlate(const MPI_Comm communicator, std::unique_ptr<Zone> zone,
                           std::unique_ptr<PeridynamicBody> points,
                           const CoupledPlateOptions &options) :
  communicator_(communicator),
  zone_(std::move(zone)), points_(std::move(points)), options_(options),
  elements_(communicator, mesh_box(*points_, *zone_, options), material_of(*points_),
            element_options(*points_, *zone_, options)),
  calibration_(communicator, *points_, elements_,
               {elements_.material().bulk_modulus,
                elements_.material().shear_modulus * (1. - relaxing_share(*points_))},
               options.coupling.calibration)
{
  if (!elements_.material().relaxation.empty())
    shear_calibration_ = std::make_unique<Calibration>(
        communicator, *points_, elements_, ElasticModuli{0., elements_.material().shear_modulus},
        options.coupling.calibration);
  if (options_.absorbing_edges)
    elements_.absorb_at({true, true, !points_->lattice().box().mirror_y, true, false, false});
  build_interface();
  interpolate_to_slaved_points();
}

void CoupledPlate::build_interface()
{
  const auto &mesh = elements_.mesh();
  const auto &box  = points_->lattice().box();
  switch (options_.coupling.method)
  {
    case CouplingMethod::calibrated_energy_blend:
      elements_.set_stiffness(calibrated_stiffness());
      break;
    case CouplingMethod::energy_blend:
      elements_.set_stiffness(blended_stiffness());
      break;
    case CouplingMethod::force_blend:
    case CouplingMethod::none:
      break;
  }

  const double cell = zone_->points_per_edge() * box.spacing;
  if (options_.coupling.correct_mass)
  {
    std::vector<int> pad;
    for (std::size_t e = 0; e < mesh.elements().size(); ++e)
    {
      const auto &element = mesh.elements()[e];
      if (element.edge > 1.5 * cell)
        continue;
      const int layer = zone_->layer(cell_at(points_->lattice(), mesh.centre(element)));
      if (layer > 0 && layer <= zone_->pad_layers())
        pad.push_back(static_cast<int>(e));
    }
    elements_.set_consistent_mass(pad, zone_->points_per_edge());
  }
  find_slaved_nodes();

  if (options_.coupling.method == CouplingMethod::force_blend)
  {
    const int width = cells_in(options_.coupling.blend_width, points_->lattice().stencil(),
                               zone_->points_per_edge());
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
        if (zone_->contains(around))
          distance = std::min(distance, zone_->layer(around));
      }
      bond_share_.push_back(blend(options_.coupling.blend, double(distance) / width));
    }
  }
}

/// Finds the nodes that slaved points follow.
void CoupledPlate::find_slaved_nodes()
{
  slaved_ = SlavedPoints(communicator_, elements_, points_->lattice(),
                         [&](const Zone::Cell &at)
                         { return zone_->is_slaved(at) || zone_->has_contact(at); });
}

bool CoupledPlate::rebalance()
{
  // Moving planes costs about as much as some steps.
  constexpr double tolerable = 1.1, worth_it = 0.95;
  const Lattice &lattice = points_->lattice();
  const auto fair        = lattice.fair_plane_starts();
  const double now       = lattice.imbalance(lattice.plane_starts());
  if (now < tolerable || lattice.imbalance(fair) > worth_it * now)
    return false;
  points_->redistribute(fair);
  find_slaved_nodes();
  interpolate_to_slaved_points();
  return true;
}

CalibrationReport CoupledPlate::calibration() const
{
  CalibrationReport report = calibration_.report();
  if (shear_calibration_)
  {
    const auto &shear          = shear_calibration_->report();
    report.ghost_before        = std::max(report.ghost_before, shear.ghost_before);
    report.ghost_after         = std::max(report.ghost_after, shear.ghost_after);
    report.smallest_eigenvalue = std::min(report.smallest_eigenvalue, shear.smallest_eigenvalue);
    report.n_iterations += shear.n_iterations;
  }
  return report;
}

std::vector<ElementStiffness> CoupledPlate::calibrated_stiffness()
{
  auto stiffness = calibration_.find();
  if (!shear_calibration_)
    return stiffness;
  // What is left in the end, and what relaxes: neither is negative, so nothing in between is.
  const auto shear   = shear_calibration_->find();
  const double share = relaxing_share(*points_);
  for (std::size_t i = 0; i < stiffness.size(); ++i)
  {
    stiffness[i].shear = shear[i].tensors;
    for (std::size_t g = 0; g < shear[i].tensors.size(); ++g)
      for (int k = 0; k < HexTensors::n_entries; ++k)
        stiffness[i].tensors[g][k] += share * shear[i].tensors[g][k];
  }
  return stiffness;
}

/// 1 minus the mean weight of the points in an element, times the material's stiffness.
std::vector<ElementStiffness> CoupledPlate::blended_stiffness() const
{
  const auto &mesh    = elements_.mesh();
  const auto &box     = points_->lattice().box();
  const int n         = zone_->points_per_edge();
  const double cell   = n * box.spacing;
  const double mu     = elements_.material().shear_modulus,
               lambda = elements_.material().bulk_modulus - 2. / 3. * mu;
  std::vector<ElementStiffness> stiffness;
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
  {
    const auto &element = mesh.elements()[e];
    const auto at       = cell_at(points_->lattice(), mesh.centre(element));
    if (element.edge > 1.5 * cell || !zone_->is_slaved(at))
      continue;
    double share = 1.;
    for (int z = n * at[2]; z < n * (at[2] + 1); ++z)
      for (int y = n * at[1]; y < n * (at[1] + 1); ++y)
        for (int x = n * at[0]; x < n * (at[0] + 1); ++x)
          share -= zone_->weight(x, y, z) / (n * n * n);
    ElementStiffness own{static_cast<int>(e), {}};
    const auto isotropic = [&](const double first)
    {
      std::array<double, HexTensors::n_entries> tensor;
      for (int i = 0, k = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j, ++k)
          tensor[k] = share * ((j < 3 ? first : 0.) + (i == j ? (i < 3 ? 2. : 1.) * mu : 0.));
      return tensor;
    };
    own.tensors.fill(isotropic(lambda));
    own.shear.fill(isotropic(-2. / 3. * mu));
    stiffness.push_back(own);
  }
  return stiffness;
}

void CoupledPlate::interpolate_to_slaved_points()
{
  elements_.update_ghosts();
  slaved_.interpolate_to_slaved_points(elements_, points_->state());
}

void CoupledPlate::start_relaxation(const double dt)
{
  points_->start_relaxation(dt);
  elements_.start_relaxation(dt);
}

void CoupledPlate::compute_internal_forces(const ForceRequest &request)
{
  points_->compute_internal_forces(request);
  elements_.compute_internal_forces(request);
}

void CoupledPlate::distribute_slaved_forces()
{
  if (options_.coupling.method == CouplingMethod::force_blend)
    blend_forces();
  else
    slaved_.add_transposed(points_->state(), elements_.force());
}

void CoupledPlate::complete_forces()
{
  distribute_slaved_forces();
  elements_.complete_forces();
}

void CoupledPlate::advance(const double kick, const double drift)
{
  points_->advance(kick, drift);
  elements_.advance(kick, drift);
  interpolate_to_slaved_points();
}

void CoupledPlate::rest()
{
  points_->rest();
  elements_.rest();
  interpolate_to_slaved_points();
  points_->update_ghosts();
}

void CoupledPlate::blend_forces()
{
  bond_force_.assign(elements_.force().size(), 0.);
  slaved_.add_transposed(points_->state(), bond_force_);
  for (std::size_t i = 0; i < 3 * bond_share_.size(); ++i)
  {
    const double share   = bond_share_[i / 3];
    elements_.force()[i] = (1. - share) * elements_.force()[i] + share * bond_force_[i];
  }
}

Energies CoupledPlate::energies(const double dt) const
{
  auto energies = points_->energies(dt);
  energies += elements_.energies(dt);
  return energies;
}

Momenta CoupledPlate::momenta() const
{
  auto momenta = points_->momenta();
  momenta += elements_.momenta();
  return momenta;
}

std::string CoupledPlate::first_not_finite() const
{
  const auto found = points_->first_not_finite();
  return found.empty() ? elements_.first_not_finite() : found;
}

std::vector<std::vector<double>> CoupledPlate::nodal_histories() const
{
  constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
  const auto &mesh     = elements_.mesh();
  const int n_branches = points_->history()->n_branches();
  std::vector<double> weight(elements_.force().size(), 0.);
  std::vector<std::vector<double>> fields(2 * n_branches, weight);
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
  {
    if (!elements_.is_active(static_cast<int>(e)))
      continue;
    const auto &element = mesh.elements()[e];
    const double volume = element.edge * element.edge * element.edge;
    for (int k = -1; k < n_branches; ++k)
    {
      const Eigen::Matrix3d G =
          k < 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Ones()) : elements_.history(e, k);
      for (const int node : element.nodes)
        for (int i = 0; i < (k < 0 ? 3 : 6); ++i)
          (k < 0 ? weight : fields[2 * k + i / 3])[3 * node + i % 3] +=
              volume * G(row[i], column[i]);
    }
  }
  mesh.add_to_owners(weight.data());
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    mesh.add_to_owners(fields[f].data());
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i    = 3 * node + d;
        // The mirrored half takes 23 and 12 away.
        const bool odd = f % 2 == 1 && d != 1 && mesh.on_mirror_plane(node);
        fields[f][i]   = weight[i] > 0. && !odd ? fields[f][i] / weight[i] : 0.;
      }
    mesh.update_ghosts(fields[f].data());
    mesh.follow_masters(fields[f].data());
  }
  return fields;
}

bool CoupledPlate::convert(const std::vector<Zone::Cells> &cells)
{
  std::vector<std::uint8_t> before;
  zone_->for_each_cell([&](const Zone::Cell &cell)
                       { before.push_back(static_cast<std::uint8_t>(zone_->layer(cell))); });
  if (!zone_->grow(cells))
    return false;
  int first = zone_->n_cells()[0], last = 0;
  std::size_t i = 0;
  std::vector<bool> was_free(before.size());
  zone_->for_each_cell(
      [&](const Zone::Cell &cell)
      {
        was_free[i] = before[i] == 0;
        if (before[i++] != zone_->layer(cell))
        {
          first = std::min(first, cell[0]);
          last  = std::max(last, cell[0] + 1);
        }
      });
  points_->follow_zone(zone_->points_per_edge() * first, zone_->points_per_edge() * last);

  // All points that did not move by themselves start from where the nodes are.
  SlavedPoints starting(communicator_, elements_, points_->lattice(),
                        [&](const Zone::Cell &cell) {
                          return !was_free[zone_->number(cell)] &&
                                 zone_->layer(cell) < zone_->far();
                        });
  starting.interpolate_to_slaved_points(elements_, points_->state());
  if (points_->history() != nullptr)
  {
    const auto nodal = nodal_histories();
    PeridynamicBody::TensorFields histories(nodal.size() / 2);
    for (std::size_t k = 0; k < histories.size(); ++k)
    {
      for (auto &field : histories[k])
        field.assign(points_->lattice().size(), 0.);
      for (const int half : {0, 1})
      {
        double *const fields[3] = {histories[k][3 * half].data(), histories[k][3 * half + 1].data(),
                                   histories[k][3 * half + 2].data()};
        starting.interpolate(nodal[2 * k + half], fields);
      }
    }
    points_->update_ghosts();
    points_->continue_history(histories);
  }

  elements_.set_active([&](const Vector3 &centre)
                       { return !zone_->is_free(cell_at(points_->lattice(), centre)); });
  build_interface();
  interpolate_to_slaved_points();
  return true;
}
} // namespace ricochet
