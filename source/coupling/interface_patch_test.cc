// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/interface_patch_test.h"

#include "surface_layers.h"

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
// Small enough to be linear, large enough that extensions survive the cancellation |xi + eta| -
// |xi|.
constexpr double strain = 1e-6;

using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

/// Columns of cells, x major, with points that lack neighbours at a hole or a crack, or have
/// neighbours that do: a constant strain is no equilibrium there.
std::vector<char> columns_near_openings(const MPI_Comm communicator, const PeridynamicBody &points)
{
  const Lattice &lattice = points.lattice();
  const auto &n          = lattice.zone()->n_cells();
  const int edge = lattice.zone()->points_per_edge(), reach = lattice.stencil().reach;
  std::vector<char> near(static_cast<std::size_t>(n[0]) * n[1], 0);
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (!points.is_open(p))
          return;
        const auto cell = points.cell_of(p);
        // Points at a rim are next to the hole; those at a crack are all that have lost a bond.
        const int r     = ((points.is_damaged(p) ? reach : 2 * reach) + edge - 1) / edge;
        for (int i = std::max(0, cell[0] - r); i <= std::min(n[0] - 1, cell[0] + r); ++i)
          for (int j = std::max(0, cell[1] - r); j <= std::min(n[1] - 1, cell[1] + r); ++j)
            near[static_cast<std::size_t>(i) * n[1] + j] = 1;
      });
  MPI_Allreduce(MPI_IN_PLACE, near.data(), static_cast<int>(near.size()), MPI_CHAR, MPI_MAX,
                communicator);
  return near;
}

class Patch
{
public:
  Patch(const MPI_Comm communicator, CoupledPlate &plate) :
    communicator_(communicator), plate_(plate), lattice_(plate.points().lattice()),
    mesh_(plate.elements().mesh()), a_(plate.points().state().arrays)
  {
    const auto &m = plate.elements().material();
    modulus_      = m.bulk_modulus + 4. / 3. * m.shear_modulus;
    edge_         = lattice_.zone()->points_per_edge() * lattice_.box().spacing;
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (lattice_.free(p))
            points_.push_back(p);
        });
    // Stiffness goes like modulus times edge, and mass like the edge to the third.
    const double of_points = std::cbrt(1. / plate.points().point_mass());
    const auto openings    = columns_near_openings(communicator, plate.points());
    for (const auto p : points_)
    {
      const auto cell = plate.points().cell_of(p);
      const bool softened =
          in_softened_layer(lattice_, point_at(p)) ||
          openings[static_cast<std::size_t>(cell[0]) * lattice_.zone()->n_cells()[1] + cell[1]];
      for (int d = 0; d < 3; ++d)
        softness_.push_back(softened ? 0. : of_points);
    }
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        softness_.push_back(in_softened_layer(lattice_, mesh_.reference_position(node))
                                ? 0.
                                : std::cbrt(plate.elements().inverse_mass(node, d)));
    number_unknowns();
  }

  /// Displaces everything to the gradient H times X plus u, and returns the forces on what is
  /// released.
  std::vector<double> forces(const Eigen::Matrix3d &H, const std::vector<double> &u) const
  {
    std::size_t i = 0;
    for (const auto p : points_)
    {
      const Vector3 X = point_at(p), x = X + H * X;
      for (int d = 0; d < 3; ++d)
        a_.position[d][p] = x[d] + u[i++];
    }
    auto &elements = plate_.elements();
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    {
      const Vector3 X = mesh_.reference_position(node), x = X + H * X;
      for (int d = 0; d < 3; ++d)
        elements.position()[3 * node + d] = x[d] + u[i++];
    }
    plate_.interpolate_to_slaved_points();
    plate_.update_ghosts();
    plate_.compute_internal_forces({/*energy=*/false, /*is_step=*/false});
    plate_.distribute_slaved_forces();

    std::vector<double> f;
    f.reserve(u.size());
    for (const auto p : points_)
      for (const double *component : a_.force)
        f.push_back(component[p]);
    f.insert(f.end(), elements.force().begin(),
             elements.force().begin() + 3 * mesh_.n_owned_nodes());
    for (std::size_t k = 0; k < f.size(); ++k)
      f[k] = softness_[k] > 0. ? f[k] : 0.;
    return f;
  }

  struct Relaxation
  {
    int n_iterations;
    bool converged;
  };
  /// Solves K u = f by conjugate gradients. With S^2 the softness the solver sees S K S (u/S) = S
  /// f: its norm of the residual is the preconditioner's, the square root of f S^2 f.
  Relaxation relax(const std::vector<double> &f, const int most_iterations,
                   const double residual_left, std::vector<double> &u) const
  {
    Vector load(unknowns_, communicator_), scaled(unknowns_, communicator_);
    for (std::size_t k = 0; k < f.size(); ++k)
      load.local_element(k) = std::sqrt(softness_[k]) * f[k];
    dealii::SolverControl control(most_iterations, residual_left * load.l2_norm(),
                                  /*log_history=*/false, /*log_result=*/false);
    try
    {
      dealii::SolverCG<Vector>(control).solve(*this, scaled, load, dealii::PreconditionIdentity());
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      // Reported.
    }
    for (std::size_t k = 0; k < u.size(); ++k)
      u[k] = std::sqrt(softness_[k]) * scaled.local_element(k);
    return {static_cast<int>(control.last_step()),
            control.last_check() == dealii::SolverControl::success};
  }

  /// image = S K S x, from the forces of a displacement so small that they are linear.
  void vmult(Vector &image, const Vector &x) const
  {
    std::vector<double> moved(softness_.size());
    for (std::size_t k = 0; k < moved.size(); ++k)
      moved[k] = std::sqrt(softness_[k]) * x.local_element(k);
    const double scale = strain * edge_ / largest(moved);
    for (double &value : moved)
      value *= scale;
    const auto f = forces(Eigen::Matrix3d::Zero(), moved);
    for (std::size_t k = 0; k < f.size(); ++k)
      image.local_element(k) = -std::sqrt(softness_[k]) * f[k] / scale;
  }

  /// Largest entry of the gradient of u, over elements and over pairs of neighbouring free points.
  double largest_gradient(const std::vector<double> &u) const
  {
    forces(Eigen::Matrix3d::Zero(), u); // puts everything, slaved points too, where it belongs
    double most = 0.;
    for (std::size_t e = 0; e < mesh_.elements().size(); ++e)
      if (plate_.elements().is_active(static_cast<int>(e)))
        most = std::max(most, (plate_.elements().deformation_gradient(static_cast<int>(e)) -
                               Eigen::Matrix3d::Identity())
                                  .cwiseAbs()
                                  .maxCoeff());
    const std::ptrdiff_t strides[] = {lattice_.plane_stride(), 1, lattice_.row_stride()};
    const double spacing           = lattice_.box().spacing;
    for (const auto p : points_)
    {
      const auto c = lattice_.coordinates(p);
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::ptrdiff_t q = p + strides[axis];
        if (c[axis] + 1 >= lattice_.box().n[axis] || !lattice_.exists(q))
          continue;
        for (int d = 0; d < 3; ++d)
        {
          const double apart = a_.position[d][q] - a_.position[d][p] - (d == axis ? spacing : 0.);
          most               = std::max(most, std::abs(apart) / spacing);
        }
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    return most;
  }

  double largest(const std::vector<double> &f) const
  {
    double most = 0.;
    for (const double value : f)
      most = std::max(most, std::abs(value));
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    return most;
  }

  double force_unit() const { return strain * modulus_ * edge_ * edge_; } // [N]
  std::size_t size() const { return softness_.size(); }

private:
  Vector3 point_at(const std::ptrdiff_t p) const
  {
    return lattice_.reference_position(lattice_.coordinates(p));
  }
  /// Those of each rank in a row.
  void number_unknowns()
  {
    std::uint64_t n = softness_.size(), end = 0;
    MPI_Scan(&n, &end, 1, MPI_UINT64_T, MPI_SUM, communicator_);
    std::uint64_t n_all = n;
    MPI_Allreduce(MPI_IN_PLACE, &n_all, 1, MPI_UINT64_T, MPI_SUM, communicator_);
    unknowns_.set_size(n_all);
    unknowns_.add_range(end - n, end);
  }

  MPI_Comm communicator_;
  CoupledPlate &plate_;
  const Lattice &lattice_;
  const HexMesh &mesh_;
  LatticeArrays &a_;
  double modulus_, edge_;              // M [Pa], h [m]
  std::vector<std::ptrdiff_t> points_; // free ones
  // Per component of points_, then of owned nodes: like the inverse of its stiffness; 0 if held.
  std::vector<double> softness_;
  dealii::IndexSet unknowns_; // of this rank, in the order of softness_
};
} // namespace

PatchReport patch_test(const MPI_Comm communicator, CoupledPlate &plate, const int most_iterations,
                       const double residual_left)
{
  Patch patch(communicator, plate);
  const bool mirrored = plate.points().lattice().box().mirror_y;
  PatchReport report{0., most_iterations > 0 ? 0. : std::numeric_limits<double>::quiet_NaN(), 0, 0,
                     most_iterations > 0};
  const std::vector<double> nothing(patch.size(), 0.);
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
    {
      if (mirrored && i != j && (i == 1 || j == 1))
        continue;
      Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
      H(i, j) = H(j, i)  = i == j ? strain : 0.5 * strain;
      const auto f       = patch.forces(H, nothing);
      report.ghost_force = std::max(report.ghost_force, patch.largest(f) / patch.force_unit());
      ++report.n_strains;
      if (most_iterations <= 0)
        continue;
      auto u                = nothing;
      const auto relaxation = patch.relax(f, most_iterations, residual_left, u);
      report.n_iterations += relaxation.n_iterations;
      report.converged    = report.converged && relaxation.converged;
      report.strain_error = std::max(report.strain_error, patch.largest_gradient(u) / strain);
    }
  patch.forces(Eigen::Matrix3d::Zero(), nothing);
  plate.rest();
  return report;
}
} // namespace ricochet
