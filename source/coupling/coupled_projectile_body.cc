// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/coupled_projectile_body.h"

#include "ricochet/base/exceptions.h"

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace ricochet
{
namespace
{
constexpr double small_strain = 1e-5; // linear, and far above rounding

/// The cells for which `chosen` is true, and the new number of each node or -1.
HexSolid part_of(const HexSolid &mesh, const std::vector<char> &chosen, std::vector<int> &number)
{
  HexSolid part;
  number.assign(mesh.nodes.size(), -1);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (chosen[cell])
    {
      part.cells.push_back(mesh.cells[cell]);
      for (int &node : part.cells.back())
      {
        if (number[node] < 0)
        {
          number[node] = static_cast<int>(part.nodes.size());
          part.nodes.push_back(mesh.nodes[node]);
        }
        node = number[node];
      }
    }
  return part;
}

/// Finds the cells around places that lie in front of a plane across x.
class CellFinder
{
public:
  CellFinder(const HexSolid &solid, const double plane) : solid_(solid)
  {
    for (int cell = 0; cell < static_cast<int>(solid.cells.size()); ++cell)
    {
      Vector3 low = solid.nodes[solid.cells[cell][0]], high = low;
      for (const int node : solid.cells[cell])
      {
        low  = low.cwiseMin(solid.nodes[node]);
        high = high.cwiseMax(solid.nodes[node]);
      }
      const Vector3 margin = Vector3::Constant(0.5 * (high - low).maxCoeff());
      if (high.x() + margin.x() > plane)
        boxes_.push_back({cell, low - margin, high + margin});
    }
  }

  /// The cell that the place lies in, or is nearest to; the shape functions there. -1: far from
  /// all.
  std::pair<int, std::array<double, 8>> find(const Vector3 &place) const
  {
    int best     = -1;
    Vector3 at   = Vector3::Zero();
    double least = 2.; // half edges from the cell's centre: farther away nothing follows a cell
    for (const auto &box : boxes_)
      if ((place - box.low).minCoeff() > 0. && (box.high - place).minCoeff() > 0.)
      {
        const Vector3 natural = natural_coordinates(solid_, box.cell, place);
        if (const double away = natural.cwiseAbs().maxCoeff(); away < least)
        {
          least = away;
          best  = box.cell;
          at    = natural;
        }
      }
    return {best, shape_functions(at)};
  }

private:
  struct Box
  {
    int cell;
    Vector3 low, high;
  };
  const HexSolid &solid_;
  std::vector<Box> boxes_;
};

/// The nodes that a point follows, with their weights: the mean over n^3 parts of its cube. At the
/// body's surface the cube sticks out; there it is made smaller, about the same centre. Adds the
/// cells to `overlaps`.
std::map<int, double> nodes_followed(const CellFinder &finder, const HexSolid &solid,
                                     const Vector3 &centre, const double edge, const int n,
                                     std::vector<char> &overlaps)
{
  for (const double size : {1., 0.75, 0.5, 0.25, 0.})
  {
    std::map<int, double> nodes;
    std::vector<int> cells;
    for (int part = 0; part < n * n * n; ++part)
    {
      const Vector3 place(part % n, part / n % n, part / n / n);
      const Vector3 offset = (place.array() + 0.5) / n - 0.5;
      const auto [cell, N] = finder.find(centre + size * edge * offset);
      if (cell < 0)
        break;
      cells.push_back(cell);
      for (int corner = 0; corner < 8; ++corner)
        nodes[solid.cells[cell][corner]] += N[corner] / (n * n * n);
    }
    if (static_cast<int>(cells.size()) < n * n * n)
      continue;
    for (const int cell : cells)
      overlaps[cell] = 1;
    return nodes;
  }
  throw InputError("A point of the projectile lies in none of the elements that it should follow.\n"
                   "  Change 'Projectile/Peridynamic length' or the mesh.");
}

/// What a cell in uniform stress does to its nodes: - V stress B_a [N].
Eigen::Matrix<double, 3, 8> nodal_forces(const HexSolid &solid, const int cell,
                                         const Eigen::Matrix3d &stress)
{
  return -stress * integrals(solid, cell).gradient.transpose();
}
} // namespace

CoupledProjectileBody::CoupledProjectileBody(const BodyOfRevolution &shape, const HexSolid &mesh,
                                             const Parameters &parameters) :
  mass_(parameters.mass),
  interface_(shape.base_position())
{
  std::vector<char> is_element(mesh.cells.size(), 0);
  double volume_of_points = 0., volume_of_all = 0.;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
  {
    double centre = 0.;
    for (const int node : mesh.cells[cell])
      centre += mesh.nodes[node].x() / 8.;
    const double size = cell_volume(mesh, static_cast<int>(cell));
    is_element[cell]  = centre < shape.tip_position() - parameters.points_length;
    volume_of_all += size;
    if (!is_element[cell])
      volume_of_points += size;
    else
      for (const int node : mesh.cells[cell])
        interface_ = std::max(interface_, mesh.nodes[node].x());
  }
  const HexSolid solid = part_of(mesh, is_element, node_);
  if (solid.cells.empty() && std::isfinite(parameters.points_length))
    throw InputError("The peridynamic nose of the projectile leaves no element behind it.\n  Lower "
                     "'Projectile/Peridynamic length', or set 'Projectile/Model = peridynamic'.");
  Parameters of_points = parameters;
  of_points.mass *= volume_of_points / volume_of_all;
  place_points(shape, of_points, volume_of_points);

  const Lattice &lattice = peridynamic_->lattice();
  auto &a                = peridynamic_->state().arrays;
  int n_free             = 0;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        index_.push_back(p);
        points_.push_back({lattice.reference_position(lattice.coordinates(p)), {}});
        if (!lattice.free(p))
          return;
        points_.back().follows.emplace_back(n_free++, 1.);
        const double mass = peridynamic_->point_mass();
        mass_points_.push_back({points_.back().reference,
                                mass,
                                Vector3::Constant(1. / mass),
                                {&a.position[0][p], &a.position[1][p], &a.position[2][p]},
                                {&a.velocity[0][p], &a.velocity[1][p], &a.velocity[2][p]},
                                {&a.force[0][p], &a.force[1][p], &a.force[2][p]}});
      });
  if (solid.cells.empty())
  {
    rest();
    return;
  }

  const CellFinder finder(solid, interface_ - overlap_.length);
  // A point's cube may be larger than an element: it follows the mean over parts of its cube.
  const double edge = std::cbrt((volume_of_all - volume_of_points) / double(solid.cells.size()));
  const int n       = std::max(2, static_cast<int>(std::ceil(1.5 * parameters.spacing / edge)));
  std::vector<char> overlaps(solid.cells.size(), 0);
  for (int i = 0; i < static_cast<int>(points_.size()); ++i)
    if (!lattice.free(index_[i]))
    {
      slaved_.push_back(i);
      for (const auto &[node, weight] :
           nodes_followed(finder, solid, points_[i].reference, parameters.spacing, n, overlaps))
        points_[i].follows.emplace_back(n_free + node, weight);
    }

  const double density = parameters.mass / volume_of_all;
  HexahedralBody::Options options;
  options.shares = shares_of(mesh, solid, overlaps, parameters);
  elements_      = std::make_unique<HexahedralBody>(
      solid, FiniteElementMaterial{density, parameters.bulk_modulus, parameters.shear_modulus},
      parameters.mirrored, options);
  for (int node = 0; node < elements_->n_nodes(); ++node)
  {
    const auto three = [node](std::vector<double> &values)
    {
      return std::array<double *, 3>{&values[3 * node], &values[3 * node + 1],
                                     &values[3 * node + 2]};
    };
    mass_points_.push_back(
        {solid.nodes[node], elements_->node_mass(node),
         Vector3(elements_->inverse_mass(3 * node), elements_->inverse_mass(3 * node + 1),
                 elements_->inverse_mass(3 * node + 2)),
         three(elements_->position()), three(elements_->velocity()), three(elements_->force())});
  }
  for (int &number : node_)
    if (number >= 0)
      number += n_free;
  rest();
}

CoupledProjectileBody::~CoupledProjectileBody() = default;

/// The lattice: what lies in front of the interface and the overlap behind it, or all of the body.
void CoupledProjectileBody::place_points(const BodyOfRevolution &shape,
                                         const Parameters &parameters, const double volume)
{
  const double spacing = parameters.spacing;
  const double base = shape.base_position(), diameter = shape.shape().diameter;
  const bool has_elements = interface_ > base;
  const Stencil stencil   = make_stencil(spacing, 3., InfluenceFunction::cone);
  const auto cells        = [&](const double points)
  { return static_cast<int>(std::ceil(points / Zone::usual_points_per_edge)); };

  // In cells of the lattice; the plane of the interface lies between two of them.
  const int behind    = has_elements ? Zone({1, 1, 1}, stencil.reach).slaved_layers() : 0;
  const int across    = cells(diameter / 2. / spacing);
  const double length = shape.tip_position() - interface_;
  const double points_along =
      has_elements ? length / spacing : std::max(1., std::round(length / spacing));
  const std::array<int, 3> n_cells{behind + cells(points_along),
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
  const auto inside = [shape, box](const int x, const int y, const int z)
  {
    const Vector3 place = box.corner + box.spacing * Vector3(x + 0.5, y + 0.5, z + 0.5);
    return shape.hit(place).distance < 0.;
  };
  double n_points = 0.; // that are free
  for (int x = behind * Zone::usual_points_per_edge; x < box.n[0]; ++x)
    for (int y = 0; y < box.n[1]; ++y)
      for (int z = 0; z < box.n[2]; ++z)
        n_points += inside(x, y, z);
  if (diameter <= 2. * spacing || n_points < 50.)
  {
    std::ostringstream message;
    message << "The grid of the projectile is too coarse: a spacing of " << 1e3 * spacing
            << " mm puts " << diameter / spacing << " points across its diameter and " << n_points
            << " into it.\n  Lower 'Projectile/Grid spacing'.";
    throw InputError(message.str());
  }

  // Points stand for the whole volume, whatever part of it the lattice meets.
  const double cubes = n_points * spacing * spacing * spacing, more = volume / cubes;
  const PeridynamicMaterial material{
      parameters.law, parameters.mass / cubes, more * parameters.bulk_modulus,
      more * parameters.shear_modulus, std::numeric_limits<double>::infinity()};
  zone_ = std::make_unique<Zone>(n_cells, stencil.reach);
  zone_->grow({{{behind, 0, 0}, n_cells}});
  peridynamic_ = std::make_unique<PeridynamicBody>(MPI_COMM_SELF, 0, box, stencil, material, inside,
                                                   nullptr, zone_.get());
  if (parameters.correct_surface)
    correct_surface(PeridynamicBody(MPI_COMM_SELF, 0, box, stencil, material, inside));
}

/// Puts all points into an axial pull with the contraction of a bar.
void CoupledProjectileBody::strain(PeridynamicBody &points)
{
  const auto &m  = points.material();
  const double K = m.bulk_modulus, mu = m.shear_modulus;
  const double nu        = (3. * K - 2. * mu) / (6. * K + 2. * mu);
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
  const auto &m  = whole.material();
  const double E = 9. * m.bulk_modulus * m.shear_modulus / (3. * m.bulk_modulus + m.shear_modulus);
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
  const double K = parameters.bulk_modulus, mu = parameters.shear_modulus;
  const double E               = 9. * K * mu / (3. * K + mu);
  const Eigen::Matrix3d stress = Vector3(E, 0., 0.).asDiagonal();
  const int n_rows             = 3 * static_cast<int>(elements.nodes.size());

  // What the shares have to make up for: the forces of all cells as elements, less those of points
  // and of the elements that keep everything.
  Eigen::VectorXd missing = Eigen::VectorXd::Zero(n_rows);
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

  std::vector<int> columns; // elements in the overlap
  std::vector<Eigen::Triplet<double>> entries;
  // A half body has half the force at nodes on its plane, which count once in the whole one, others
  // twice.
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(n_rows);
  double edge            = 0.;
  for (int cell = 0; cell < static_cast<int>(elements.cells.size()); ++cell)
  {
    const auto forces = nodal_forces(elements, cell, stress);
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
      {
        const int node = elements.cells[cell][corner], row = 3 * node + d;
        if (!overlaps[cell])
          missing[row] -= forces(d, corner);
        else if (!(parameters.mirrored && d == 1 && elements.nodes[node].y() == 0.))
        {
          counts[row] = parameters.mirrored && elements.nodes[node].y() == 0. ? std::sqrt(2.) : 1.;
          entries.emplace_back(row, static_cast<int>(columns.size()),
                               counts[row] * forces(d, corner));
        }
      }
    if (overlaps[cell])
    {
      columns.push_back(cell);
      edge += std::cbrt(cell_volume(elements, cell));
    }
  }
  missing = missing.cwiseProduct(counts);

  const int n = static_cast<int>(columns.size());
  Eigen::SparseMatrix<double> A(n_rows, n);
  A.setFromTriplets(entries.begin(), entries.end());
  Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> solver;
  solver.setTolerance(1e-13);
  solver.compute(A);
  // No part of the energy may be negative.
  const Eigen::VectorXd found =
      solver.solveWithGuess(missing, Eigen::VectorXd::Ones(n)).cwiseMax(0.);
  overlap_.n_elements = n;
  overlap_.ghost      = (A * found - missing).cwiseAbs().maxCoeff() / (E * edge * edge / n / n);

  std::vector<double> shares(elements.cells.size(), 1.);
  for (int i = 0; i < n; ++i)
    shares[columns[i]] = found[i];
  return shares;
}
} // namespace ricochet
