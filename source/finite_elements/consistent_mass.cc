// SPDX-License-Identifier: LGPL-2.1-or-later
#include "consistent_mass.h"

#include <algorithm>

namespace ricochet
{
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
    momentum_[i] += kick * uncorrected_force_[i];
}

/// result = (2 M_L - M_C) x, zero where components are held.
void ConsistentMass::multiply(std::vector<double> &x, std::vector<double> &result) const
{
  mesh_.update_ghosts(x.data());
  std::fill(result.begin(), result.end(), 0.);
  add_mass_difference(x, result);
  mesh_.add_to_owners(result.data());
  for (std::size_t i = 0; i < lumped_.inverse.size(); ++i)
    result[i] = lumped_.inverse[i] > 0. ? result[i] + lumped_.mass[i / 3] * x[i] : 0.;
}

double ConsistentMass::product(const std::vector<double> &x, const std::vector<double> &y) const
{
  double sum = 0.;
  for (std::size_t i = 0; i < lumped_.inverse.size(); ++i)
    sum += x[i] * y[i];
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return sum;
}

/// Solves (2 M_L - M_C) y = M_L v by conjugate gradients, M_eff v = M_L y: all eigenvalues of the
/// scaled matrix lie between 1 and 2.
void ConsistentMass::find_momentum(const std::vector<double> &velocity)
{
  const std::size_t n = lumped_.inverse.size();
  std::vector<double> y(velocity.size(), 0.), residual(y), direction(y), image(y), scaled(y);
  std::copy_n(velocity.begin(), n, y.begin());
  multiply(y, image);
  for (std::size_t i = 0; i < n; ++i)
  {
    residual[i]  = lumped_.inverse[i] > 0. ? lumped_.mass[i / 3] * velocity[i] - image[i] : 0.;
    direction[i] = scaled[i] = residual[i] * lumped_.inverse[i];
  }
  double rho            = product(residual, scaled);
  const double enough   = 1e-26 * rho;
  constexpr int maximum = 60;
  for (int iteration = 0; iteration < maximum && rho > enough; ++iteration)
  {
    multiply(direction, image);
    const double alpha = rho / product(direction, image);
    for (std::size_t i = 0; i < n; ++i)
    {
      y[i] += alpha * direction[i];
      residual[i] -= alpha * image[i];
      scaled[i] = residual[i] * lumped_.inverse[i];
    }
    const double next = product(residual, scaled), beta = next / rho;
    rho = next;
    for (std::size_t i = 0; i < n; ++i)
      direction[i] = scaled[i] + beta * direction[i];
  }
  // Rows of both matrices have the same sums: with what is left of the residual the total is the
  // sum of M_L v to the last bit, however well y has converged.
  momentum_.clear();
  for (const int node : nodes_)
    for (int d = 0; d < 3; ++d)
      momentum_.push_back(lumped_.mass[node] * y[3 * node + d] + residual[3 * node + d]);
}
} // namespace ricochet
