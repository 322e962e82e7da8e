// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stiffness_least_squares.h"

#include "ricochet/base/exact_sum.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>

namespace ricochet
{
namespace
{
// Zones are symmetric, so that conjugate gradients know nothing of modes which rounding alone
// excites: these would grow a little with each step, differently on any number of ranks. Three
// rounds of twenty steps, see CalibrationOptions.
constexpr int directions_before_forgetting = 60;

/// Nodes of new elements are mended down to this part of what is allowed, others only to what is:
/// when the next cells come, those kept here have room for what these do to them.
constexpr double share_allowed_to_new = 0.5;
} // namespace

StiffnessLeastSquares::StiffnessLeastSquares(const MPI_Comm communicator,
                                             const CalibratedElements &system, Start &&start,
                                             const CalibrationOptions &options) :
  communicator_(communicator),
  system_(system), options_(options), tensors_(std::move(start.tensors)),
  kept_(std::move(start.kept)), residual_(std::move(start.residual))
{
  for (auto *tensors : {&slope_, &last_slope_, &direction_})
    tensors->resize(tensors_.size(), GaussPointTensors{});
}

void StiffnessLeastSquares::solve(CalibrationReport &report)
{
  report              = {};
  report.ghost_before = system_.largest(residual_);
  // C may become negative where little is left of it. What is cut off then is sought again, from
  // there; the part of the solution space without negative eigenvalues is convex.
  while (report.n_iterations < options_.n_iterations && system_.largest_excess(residual_) > 1.)
  {
    choose_active();
    next_direction();
    report.n_iterations += conjugate_gradient_steps(
        std::min(options_.round, options_.n_iterations - report.n_iterations));
    report.smallest_eigenvalue = std::min(report.smallest_eigenvalue, project());
  }
  report.ghost_after = system_.largest(residual_);
  MPI_Allreduce(MPI_IN_PLACE, &report.smallest_eigenvalue, 1, MPI_DOUBLE, MPI_MIN, communicator_);
  report.n_elements = static_cast<std::int64_t>(tensors_.size());
  MPI_Allreduce(MPI_IN_PLACE, &report.n_elements, 1, MPI_INT64_T, MPI_SUM, communicator_);
}

/// Adds elements near nodes whose force is too large; to make it smaller than need be is left to
/// nodes of elements that are new.
void StiffnessLeastSquares::choose_active()
{
  const auto &elements = system_.elements();
  const std::size_t n  = elements.size();
  std::vector<char> marked(residual_.size()), is_new(residual_.size());
  for (std::size_t i = 0; i < n; ++i)
    if (!kept_[i])
      for (const int node : elements[i].corner)
        is_new[node] = 1;
  system_.share(is_new);
  for (std::size_t i = 0; i < residual_.size(); ++i)
    for (const auto &lanes : residual_[i])
      marked[i] = marked[i] || lanes.abs().maxCoeff() >
                                   (is_new[i] ? share_allowed_to_new : 1.) * system_.allowed(i);
  std::vector<char> chosen(n);
  const int n_layers =
      std::max(1, mending_range(system_.lattice().stencil()) / system_.zone().points_per_edge());
  for (int layer = 0; layer < n_layers; ++layer)
  {
    for (std::size_t i = 0; i < n; ++i)
      chosen[i] = std::any_of(elements[i].corner.begin(), elements[i].corner.end(),
                              [&](const int node) { return marked[node] != 0; });
    for (std::size_t i = 0; i < n; ++i)
      if (chosen[i])
        for (const int node : elements[i].corner)
          marked[node] = 1;
    system_.share(marked);
  }
  for (const int i : active_)
    chosen[i] = 1;
  active_.clear();
  for (std::size_t i = 0; i < n; ++i)
    if (chosen[i])
      active_.push_back(static_cast<int>(i));
}

/// With the share of the last one that Polak and Ribiere give it: they forgive that tensors were
/// projected in between or others have become active.
void StiffnessLeastSquares::next_direction()
{
  slope_.swap(last_slope_);
  for (const int i : active_)
    slope_[i] = descent(residual_, system_.elements()[i].corner);
  const double squared = product(slope_, slope_);
  const bool forget    = n_directions_++ % directions_before_forgetting == 0;
  const double share =
      forget ? 0. : std::max(0., (squared - product(slope_, last_slope_)) / squared_slope_);
  squared_slope_ = squared;
  for (const int i : active_)
    for (int g = 0; g < 8; ++g)
      for (int k = 0; k < HexTensors::n_entries; ++k)
        direction_[i][g][k] = slope_[i][g][k] + share * direction_[i][g][k];
}

/// At most so many steps towards the smallest residual with the smallest change of the active
/// tensors; returns how many.
int StiffnessLeastSquares::conjugate_gradient_steps(const int n_steps)
{
  for (int done = 1; squared_slope_ > 0.; ++done)
  {
    NodalForces image(residual_.size());
    for (const int i : active_)
      add_cube_forces(direction_[i], system_.elements()[i].corner, image);
    system_.complete(image);
    const double length = product(slope_, direction_) / system_.squared_norm(image);
    for (const int i : active_)
      for (int g = 0; g < 8; ++g)
        add(length, direction_[i][g], tensors_[i][g]);
    add_to_residual(length, image);
    if (done == n_steps || system_.largest_excess(residual_) < 1.)
      return done;
    next_direction();
  }
  return n_steps;
}

/// Raises negative eigenvalues to zero if asked, and keeps the residual up to date; returns the
/// smallest one on this rank, or zero.
double StiffnessLeastSquares::project()
{
  NodalForces image(residual_.size());
  double smallest = 0.;
  for (const int i : active_)
  {
    GaussPointTensors change{};
    if (project(i, change, smallest))
      add_cube_forces(change, system_.elements()[i].corner, image);
  }
  system_.complete(image);
  add_to_residual(1., image);
  return smallest;
}

bool StiffnessLeastSquares::project(const int element, GaussPointTensors &change, double &smallest)
{
  bool changed = false;
  for (int g = 0; g < 8; ++g)
  {
    const Matrix6 m = unpacked(tensors_[element][g]);
    // Most are positive, and this is the quick way to know.
    if (Eigen::LLT<Matrix6>(m + 1e-9 * Matrix6::Identity()).info() == Eigen::Success)
      continue;
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(m);
    smallest = std::min(smallest, solver.eigenvalues()[0]);
    if (!options_.clip || solver.eigenvalues()[0] >= 0.)
      continue;
    const Matrix6 kept = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.).asDiagonal() *
                         solver.eigenvectors().transpose();
    change[g]            = packed(kept - m);
    tensors_[element][g] = packed(kept);
    changed              = true;
  }
  return changed;
}

void StiffnessLeastSquares::add_to_residual(const double factor, const NodalForces &forces)
{
  for (std::size_t i = 0; i < residual_.size(); ++i)
    for (int c = 0; c < 3; ++c)
      residual_[i][c] += factor * forces[i][c];
}

double StiffnessLeastSquares::product(const std::vector<GaussPointTensors> &x,
                                      const std::vector<GaussPointTensors> &y) const
{
  ExactSum sum;
  for (const int i : active_)
  {
    double own = 0.;
    for (int g = 0; g < 8; ++g)
      for (int k = 0; k < HexTensors::n_entries; ++k)
        own += x[i][g][k] * y[i][g][k];
    sum.add(own);
  }
  return total(communicator_, sum);
}
} // namespace ricochet
