// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/coupled_projectile_body.h"

#include "overlap.h"

#include "ricochet/base/elastic_constants.h"
#include "ricochet/base/exceptions.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ricochet
{
namespace
{
constexpr double small_strain = 1e-5; // linear, and far above rounding

/// Fewer free points than these are no body: the smallest with a core that has all its neighbours
/// is about four points across.
constexpr double fewest_points = 50.;

void check_fineness(const double spacing, const double diameter, const double n_points)
{
  if (diameter > 2. * spacing && n_points >= fewest_points)
    return;
  std::ostringstream message;
  message << "The grid of the projectile is too coarse: a spacing of " << 1e3 * spacing
          << " mm puts " << diameter / spacing << " points across its diameter and " << n_points
          << " into it.\n  Lower 'Projectile/Grid spacing'.";
  throw InputError(message.str());
}

int cells_for(const double points)
{
  return static_cast<int>(std::ceil(points / Zone::usual_points_per_edge));
}

std::array<double *, 3> three(std::vector<double> &values, const int node)
{
  return {&values[3 * node], &values[3 * node + 1], &values[3 * node + 2]};
}
} // namespace

CoupledProjectileBody::CoupledProjectileBody(const BodyOfRevolution &shape, const HexSolid &mesh,
                                             const Parameters &parameters) :
  mass_(parameters.mass),
  interface_(shape.base_position())
{
  const Division division = divide(mesh, shape, parameters);
  Parameters of_points    = parameters;
  of_points.mass *= division.volume_of_points / division.volume;
  place_points(shape, of_points, division.volume_of_points);
  list_points();
  if (!division.elements.cells.empty())
    make_elements(mesh, division, parameters);
  rest();
}

CoupledProjectileBody::~CoupledProjectileBody() = default;

/// Which cells of the mesh are elements: those behind the interface, which is found here.
CoupledProjectileBody::Division CoupledProjectileBody::divide(const HexSolid &mesh,
                                                              const BodyOfRevolution &shape,
                                                              const Parameters &parameters)
{
  Division division;
  std::vector<char> is_element(mesh.cells.size(), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
  {
    double centre = 0.;
    for (const int node : mesh.cells[cell])
      centre += mesh.nodes[node].x() / 8.;
    const double size = cell_volume(mesh, static_cast<int>(cell));
    is_element[cell]  = centre < shape.tip_position() - parameters.points_length;
    division.volume += size;
    if (!is_element[cell])
      division.volume_of_points += size;
    else
      for (const int node : mesh.cells[cell])
        interface_ = std::max(interface_, mesh.nodes[node].x());
  }
  division.elements = part_of(mesh, is_element, node_);
  if (division.elements.cells.empty() && std::isfinite(parameters.points_length))
    throw InputError("The peridynamic nose of the projectile leaves no element behind it.\n  Lower "
                     "'Projectile/Peridynamic length', or set 'Projectile/Model = peridynamic'.");
  return division;
}

/// The lattice: what lies in front of the interface and the overlap behind it, or all of the body.
/// Its cells are counted so that the plane of the interface lies between two of them.
Lattice::Box CoupledProjectileBody::lattice_box(const BodyOfRevolution &shape,
                                                const Parameters &parameters, const int behind)
{
  const double spacing = parameters.spacing, base = shape.base_position();
  const bool has_elements = interface_ > base;
  const int across        = cells_for(shape.shape().diameter / 2. / spacing);
  const double length     = shape.tip_position() - interface_;
  const double points_along =
      has_elements ? length / spacing : std::max(1., std::round(length / spacing));
  const std::array<int, 3> n_cells{behind + cells_for(points_along),
                                   parameters.mirrored ? across : 2 * across, 2 * across};
  overlap_.length = behind * Zone::usual_points_per_edge * spacing;
  if (overlap_.length > interface_ - base)
  {
    std::ostringstream message;
    message << "The elements of the projectile are too short: " << 1e3 * (interface_ - base)
            << " mm, of which points overlap the front " << 1e3 * overlap_.length
            << " mm.\n  Lower 'Projectile/Peridynamic length' or 'Projectile/Grid spacing'.";
    throw InputError(message.str());
  }

  Lattice::Box box;
  box.spacing  = spacing;
  box.mirror_y = parameters.mirrored;
  for (int d = 0; d < 3; ++d)
    box.n[d] = Zone::usual_points_per_edge * n_cells[d];
  const double half_width = across * Zone::usual_points_per_edge * spacing;
  box.corner              = {has_elements ? interface_ - overlap_.length
                                          : base + 0.5 * (length - points_along * spacing),
                parameters.mirrored ? 0. : -half_width, -half_width};
  return box;
}

void CoupledProjectileBody::place_points(const BodyOfRevolution &shape,
                                         const Parameters &parameters, const double volume)
{
  const double spacing  = parameters.spacing;
  const Stencil stencil = make_stencil(spacing, parameters.horizon_ratio, parameters.influence);
  const int behind =
      interface_ > shape.base_position() ? Zone({1, 1, 1}, stencil.reach).slaved_layers() : 0;
  const Lattice::Box box = lattice_box(shape, parameters, behind);
  const auto inside      = [shape, box](const int x, const int y, const int z)
  {
    const Vector3 place = box.corner + box.spacing * Vector3(x + 0.5, y + 0.5, z + 0.5);
    return shape.hit(place).distance < 0.;
  };
  double n_points = 0.; // that are free
  for (int x = behind * Zone::usual_points_per_edge; x < box.n[0]; ++x)
    for (int y = 0; y < box.n[1]; ++y)
      for (int z = 0; z < box.n[2]; ++z)
        n_points += inside(x, y, z);
  check_fineness(spacing, shape.shape().diameter, n_points);

  // Points stand for the whole volume, whatever part of it the lattice meets.
  const double cubes = n_points * spacing * spacing * spacing, more = volume / cubes;
  const PeridynamicMaterial material{
      parameters.law, parameters.mass / cubes, more * parameters.bulk_modulus,
      more * parameters.shear_modulus, std::numeric_limits<double>::infinity()};
  Zone::Cells all{{behind, 0, 0}, box.n};
  for (int &n : all.high)
    n /= Zone::usual_points_per_edge;
  zone_ = std::make_unique<Zone>(all.high, stencil.reach);
  zone_->grow({all});
  peridynamic_ = std::make_unique<PeridynamicBody>(MPI_COMM_SELF, 0, box, stencil, material, inside,
                                                   nullptr, zone_.get());
  if (parameters.correct_surface)
    correct_surface(PeridynamicBody(MPI_COMM_SELF, 0, box, stencil, material, inside));
}

/// Free points have mass; those in the overlap get what they follow in make_elements().
void CoupledProjectileBody::list_points()
{
  const Lattice &lattice = peridynamic_->lattice();
  auto &a                = peridynamic_->state().arrays;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        index_.push_back(p);
        points_.push_back({lattice.reference_position(lattice.coordinates(p)), {}});
        if (!lattice.free(p))
          return;
        points_.back().follows.emplace_back(static_cast<int>(mass_points_.size()), 1.);
        const double mass = peridynamic_->point_mass();
        mass_points_.push_back({points_.back().reference,
                                mass,
                                Vector3::Constant(1. / mass),
                                {&a.position[0][p], &a.position[1][p], &a.position[2][p]},
                                {&a.velocity[0][p], &a.velocity[1][p], &a.velocity[2][p]},
                                {&a.force[0][p], &a.force[1][p], &a.force[2][p]}});
      });
}

void CoupledProjectileBody::make_elements(const HexSolid &mesh, const Division &division,
                                          const Parameters &parameters)
{
  const HexSolid &solid = division.elements;
  const int n_free      = static_cast<int>(mass_points_.size());
  HexahedralBody::Options options;
  options.shares = shares_of(mesh, solid, find_slaved_points(division, parameters), parameters);
  const double density = parameters.mass / division.volume;
  elements_            = std::make_unique<HexahedralBody>(
      solid, FiniteElementMaterial{density, parameters.bulk_modulus, parameters.shear_modulus},
      parameters.mirrored, options);
  for (int node = 0; node < elements_->n_nodes(); ++node)
    mass_points_.push_back(
        {solid.nodes[node], elements_->node_mass(node),
         Vector3(elements_->inverse_mass(3 * node), elements_->inverse_mass(3 * node + 1),
                 elements_->inverse_mass(3 * node + 2)),
         three(elements_->position(), node), three(elements_->velocity(), node),
         three(elements_->force(), node)});
  for (int &number : node_)
    if (number >= 0)
      number += n_free;
}

/// Which nodes the points in the overlap follow; returns for each element whether points follow it.
std::vector<char> CoupledProjectileBody::find_slaved_points(const Division &division,
                                                            const Parameters &parameters)
{
  const HexSolid &solid = division.elements;
  const CellFinder finder(solid, interface_ - overlap_.length);
  // A point's cube may be larger than an element: it follows the mean over parts of its cube.
  const double edge =
      std::cbrt((division.volume - division.volume_of_points) / double(solid.cells.size()));
  const int n      = std::max(2, static_cast<int>(std::ceil(1.5 * parameters.spacing / edge)));
  const int n_free = static_cast<int>(mass_points_.size());
  std::vector<char> overlaps(solid.cells.size(), 0);
  for (int i = 0; i < static_cast<int>(points_.size()); ++i)
    if (!peridynamic_->lattice().free(index_[i]))
    {
      slaved_.push_back(i);
      for (const auto &[node, weight] :
           nodes_followed(finder, points_[i].reference, parameters.spacing, n, overlaps))
        points_[i].follows.emplace_back(n_free + node, weight);
    }
  return overlaps;
}

/// Puts all points into an axial pull with the contraction of a bar.
void CoupledProjectileBody::strain(PeridynamicBody &points)
{
  const auto &m          = points.material();
  const double nu        = poissons_ratio(m.bulk_modulus, m.shear_modulus);
  const Vector3 stretch  = Vector3::Ones() + small_strain * Vector3(1., -nu, -nu);
  const Lattice &lattice = points.lattice();
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 X = lattice.reference_position(lattice.coordinates(p));
        for (int d = 0; d < 3; ++d)
          points.state().arrays.position[d][p] = stretch[d] * X[d];
      });
  points.update_ghosts();
  points.compute_internal_forces({/*energy=*/true});
}

/// `whole`: the same points without elements, in which those of the pad have all their neighbours.
void CoupledProjectileBody::correct_surface(PeridynamicBody &&whole)
{
  strain(whole);
  // With w = bulk energy / own energy the sum of w times own energies is exact for this pull: a
  // bond counts as often as its ends do in the mean.
  const auto &m      = whole.material();
  const double E     = youngs_modulus(m.bulk_modulus, m.shear_modulus);
  const double bulk  = 0.5 * E * small_strain * small_strain * whole.point_volume();
  const auto &energy = whole.state().arrays.energy;
  std::vector<double> factor(whole.lattice().size(), 1.);
  whole.lattice().for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (energy[p] > 0.)
          factor[p] = bulk / energy[p];
      });
  whole.state().mirror(whole.lattice(), factor.data());
  peridynamic_->scale_energy(factor);
}

/// Per element. The points are left strained.
std::vector<double> CoupledProjectileBody::shares_of(const HexSolid &mesh, const HexSolid &elements,
                                                     const std::vector<char> &overlaps,
                                                     const Parameters &parameters)
{
  const double E               = youngs_modulus(parameters.bulk_modulus, parameters.shear_modulus);
  const Eigen::Matrix3d stress = Vector3(E, 0., 0.).asDiagonal();
  // What the shares have to make up for: the forces of all cells as elements, less those of points
  // and of the elements that keep everything.
  Eigen::VectorXd missing =
      Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(elements.nodes.size()));
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
  {
    const auto forces = nodal_forces(mesh, cell, stress);
    for (int corner = 0; corner < 8; ++corner)
      if (const int node = node_[mesh.cells[cell][corner]]; node >= 0)
        missing.segment<3>(3 * node) += forces.col(corner);
  }
  strain(*peridynamic_);
  const auto &a    = peridynamic_->state().arrays;
  const int n_free = static_cast<int>(mass_points_.size());
  for (const int i : slaved_)
    for (const auto &[number, weight] : points_[i].follows)
      for (int d = 0; d < 3; ++d)
        missing[3 * (number - n_free) + d] -= weight * a.force[d][index_[i]] / small_strain;
  auto found          = find_overlap_shares(elements, overlaps, parameters.mirrored, E, missing);
  overlap_.n_elements = found.n_elements;
  overlap_.ghost      = found.ghost;
  return std::move(found.shares);
}
} // namespace ricochet
