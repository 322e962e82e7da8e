// SPDX-License-Identifier: LGPL-2.1-or-later
#include "consistent_mass.h"

#include "ricochet/base/exact_sum.h"
#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
/// The residual falls by this; below, sums of doubles know nothing.
constexpr double tolerance = 1e-13;

/// Chebyshev's polynomial of degree k is cosh(k arcosh x), and after k steps the residual has
/// fallen by at least T_k((b + a)/(b - a)), with the spectrum between a and b.
int steps_needed(const double middle, const double half_width)
{
  return static_cast<int>(std::ceil(std::acosh(1. / tolerance) / std::acosh(middle / half_width)));
}
} // namespace

ConsistentMass::ConsistentMass(const MPI_Comm communicator, const HexMesh &mesh,
                               const LumpedMass &lumped, const double density,
                               const std::vector<int> &elements, const int points_per_edge) :
  communicator_(communicator),
  mesh_(mesh), lumped_(lumped), density_(density), elements_(elements)
{
  // n masses in the middles of the parts of an edge couple its ends by (s, 1/2 - s).
  const double n = points_per_edge;
  near_          = (4. * n * n - 1.) / (12. * n * n);
  far_           = 0.5 - near_;
  // An owned node may be a corner of other ranks' elements only.
  std::vector<double> touched(mesh_.reference().size(), 0.);
  for (const int e : elements_)
    for (const int node : mesh_.elements()[e].nodes)
      touched[3 * node] = 1.;
  mesh_.add_to_owners(touched.data());
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    if (touched[3 * node] > 0.)
      nodes_.push_back(node);
  uncorrected_force_.assign(3 * nodes_.size(), 0.);
  momentum_ = uncorrected_force_;
  acceleration_.assign(touched.size(), 0.);
}

/// M_C of a cube is the product of those of its edges.
void ConsistentMass::add_mass_difference(const std::vector<double> &acceleration,
                                         std::vector<double> &force) const
{
  for (const int e : elements_)
  {
    const auto &element = mesh_.elements()[e];
    const double mass   = density_ * element.edge * element.edge * element.edge;
    for (int d = 0; d < 3; ++d)
    {
      double a[8], c[8];
      for (int corner = 0; corner < 8; ++corner)
        c[corner] = a[corner] = acceleration[3 * element.nodes[corner] + d];
      for (const int axis : {1, 2, 4})
        for (int corner = 0; corner < 8; ++corner)
          if ((corner & axis) == 0)
          {
            const double low = c[corner], high = c[corner | axis];
            c[corner]        = near_ * low + far_ * high;
            c[corner | axis] = far_ * low + near_ * high;
          }
      for (int corner = 0; corner < 8; ++corner)
        force[3 * element.nodes[corner] + d] += mass * (a[corner] / 8. - c[corner]);
    }
  }
}

void ConsistentMass::correct(std::vector<double> &force)
{
  for (std::size_t i = 0; i < lumped_.inverse.size(); ++i)
    acceleration_[i] = force[i] * lumped_.inverse[i];
  mesh_.update_ghosts(acceleration_.data());
  mesh_.follow_masters(acceleration_.data());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (int d = 0; d < 3; ++d)
      uncorrected_force_[3 * i + d] = force[3 * nodes_[i] + d];
  // Ghost entries of the force are zero since it went to its owners.
  add_mass_difference(acceleration_, force);
  mesh_.add_to_owners(force.data());
}

void ConsistentMass::advance(const double kick)
{
  for (std::size_t i = 0; i < momentum_.size(); ++i)
    if (lumped_.inverse[3 * nodes_[i / 3] + i % 3] > 0.) // what is held takes up no momentum
      momentum_[i] += kick * uncorrected_force_[i];
}

/// result = (2 M_L - M_C) x, zero where components are held.
void ConsistentMass::multiply(std::vector<double> &x, std::vector<double> &result) const
{
  mesh_.update_ghosts(x.data());
  mesh_.follow_masters(x.data());
  std::fill(result.begin(), result.end(), 0.);
  add_mass_difference(x, result);
  mesh_.add_to_owners(result.data());
  for (std::size_t i = 0; i < lumped_.inverse.size(); ++i)
    result[i] = lumped_.inverse[i] > 0. ? result[i] + lumped_.mass[i / 3] * x[i] : 0.;
}

/// r M_L^-1 r, in which Chebyshev's bound holds.
double ConsistentMass::squared_norm(const std::vector<double> &residual) const
{
  ExactSum sum;
  for (std::size_t i = 0; i < lumped_.inverse.size(); ++i)
    sum.add(residual[i] * residual[i] * lumped_.inverse[i]);
  return total(communicator_, sum);
}

/// Solves (2 M_L - M_C) y = M_L v by Chebyshev's iteration (Saad 2003, Iterative methods for sparse
/// linear systems, algorithm 12.1): the spectrum is known, so that the number of steps is, too, and
/// no scalar products over all ranks are needed. M_eff v = M_L y.
void ConsistentMass::find_momentum(const std::vector<double> &velocity)
{
  const std::size_t n         = lumped_.inverse.size();
  constexpr double middle     = 0.5 * (largest_eigenvalue + smallest_eigenvalue),
                   half_width = 0.5 * (largest_eigenvalue - smallest_eigenvalue);
  std::vector<double> y(velocity.size(), 0.), residual(y), step(y), image(y);
  std::copy_n(velocity.begin(), n, y.begin());
  multiply(y, image);
  for (std::size_t i = 0; i < n; ++i)
  {
    residual[i] = lumped_.inverse[i] > 0. ? lumped_.mass[i / 3] * velocity[i] - image[i] : 0.;
    step[i]     = residual[i] * lumped_.inverse[i] / middle;
  }
  const double at_start = squared_norm(residual);
  const int n_steps     = steps_needed(middle, half_width);
  double rho            = half_width / middle;
  for (int k = 0; k < n_steps; ++k)
  {
    multiply(step, image);
    const double next = 1. / (2. * middle / half_width - rho);
    for (std::size_t i = 0; i < n; ++i)
    {
      y[i] += step[i];
      residual[i] -= image[i];
      step[i] = next * rho * step[i] + 2. * next / half_width * residual[i] * lumped_.inverse[i];
    }
    rho = next;
  }
  if (const double left = squared_norm(residual); !(left <= tolerance * tolerance * at_start))
  {
    std::ostringstream message;
    message << "The momentum of the finite elements with consistent mass was not found: after "
            << n_steps << " steps " << std::sqrt(left / at_start)
            << " of the residual is left, where " << tolerance
            << " was due.\n  The velocities are not finite, or the elements' mass is not what the "
               "iteration takes it for; the latter is an error of the program.\n  'Coupling/Mass "
               "correction "
               "= false' does without.";
    throw RunError(message.str());
  }
  // Rows of both matrices have the same sums: with what is left of the residual the total is the
  // sum of M_L v to the last bit, however well y has converged.
  momentum_.clear();
  for (const int node : nodes_)
    for (int d = 0; d < 3; ++d)
      momentum_.push_back(lumped_.mass[node] * y[3 * node + d] + residual[3 * node + d]);
}

void ConsistentMass::exchange_state(StateArchive &archive)
{
  std::vector<std::int64_t> places;
  for (const int node : nodes_)
    places.push_back(mesh_.place_number(mesh_.reference_position(node)));
  archive.rows("momentum", places, momentum_, 3);
}
} // namespace ricochet
