// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/dispersion.h"

#include "plate_elements.h"

#include "ricochet/base/elastic_constants.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
double largest_eigenvalue(const WaveMatrix &matrix)
{
  Eigen::SelfAdjointEigenSolver<WaveMatrix> solver;
  solver.computeDirect(matrix, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

/// The largest eigenvalue over pi >= k_x >= k_y >= k_z >= 0, which stands for all wave vectors
/// because of the cubic symmetry: on a grid, then around the best of it in steps halved each time.
template <class Dispersion>
double largest_over_wave_vectors(const Dispersion &dispersion)
{
  constexpr int n_steps = 24, n_halvings = 12;
  double step    = M_PI / n_steps;
  double largest = 0.;
  Vector3 best   = Vector3::Zero();
  for (int i = 0; i <= n_steps; ++i)
    for (int j = 0; j <= i; ++j)
      for (int k = 0; k <= j; ++k)
      {
        const Vector3 at = step * Vector3(i, j, k);
        if (const double value = largest_eigenvalue(dispersion.matrix(at)); value > largest)
        {
          largest = value;
          best    = at;
        }
      }
  for (int halving = 0; halving < n_halvings; ++halving)
  {
    step *= 0.5;
    const Vector3 centre = best;
    for (int neighbour = 0; neighbour < 27; ++neighbour)
    {
      const int along[3] = {neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1};
      const Vector3 at   = centre + step * Vector3(along[0], along[1], along[2]);
      if (const double value = largest_eigenvalue(dispersion.matrix(at)); value > largest)
      {
        largest = value;
        best    = at;
      }
    }
  }
  return largest;
}

Vector3 corner_position(const int corner)
{
  return Vector3(corner & 1, (corner >> 1) & 1, corner >> 2);
}
} // namespace

LatticeDispersion::LatticeDispersion(const Stencil &stencil, const BondLaw &law,
                                     const double density, const double bulk_modulus,
                                     const double shear_modulus)
{
  const auto family = family_constants(stencil, bulk_modulus, shear_modulus);
  const double mass = density * family.volume;
  for (const auto &o : stencil.offsets)
  {
    const auto c         = law.bond(family, o.length, o.omega);
    const Vector3 offset = Vector3(o.x, o.y, o.z);
    bonds_.push_back({offset, offset.normalized(), 2. * c.extension / mass,
                      2. * c.dilatation * stencil.spacing});
  }
  volumetric_ = law.has_dilatation
                    ? 2. * law.point_stiffness(family) / (mass * stencil.spacing * stencil.spacing)
                    : 0.;
}

WaveMatrix LatticeDispersion::matrix(const Vector3 &k) const
{
  WaveMatrix result = WaveMatrix::Zero();
  Vector3 g         = Vector3::Zero();
  for (const auto &bond : bonds_)
  {
    const double phase = k.dot(bond.offset);
    result += bond.stiffness * (1. - std::cos(phase)) * bond.unit * bond.unit.transpose();
    g += bond.dilatation * std::sin(phase) * bond.unit;
  }
  return result + volumetric_ * g * g.transpose();
}

double LatticeDispersion::largest_squared_frequency() const
{
  return largest_over_wave_vectors(*this);
}

ElementDispersion::ElementDispersion(const double edge, const FiniteElementMaterial &material,
                                     const Quadrature quadrature,
                                     const double hourglass_coefficient)
{
  const double tetragonal = material.anisotropy.tetragonal * material.shear_modulus,
               mu         = material.anisotropy.diagonal * material.shear_modulus,
               lambda     = material.bulk_modulus - 2. / 3. * tetragonal,
               E          = youngs_modulus(material.bulk_modulus, material.shear_modulus);
  stiffness_.setZero();
  // In units of the edge: energy over edge^3, displacement over edge.
  const int n_points = quadrature == Quadrature::full ? 8 : 1;
  const double at    = quadrature == Quadrature::full ? 1. / std::sqrt(3.) : 0.;
  for (int g = 0; g < n_points; ++g)
  {
    Eigen::Matrix<double, 8, 3> gradient;
    for (int a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d)
      {
        gradient(a, d) = (a >> d) & 1 ? 1. : -1.;
        for (int o = 0; o < 3; ++o)
          if (o != d)
            gradient(a, d) *= 0.5 * (1. + ((a >> o) & 1 ? at : -at) * ((g >> o) & 1 ? 1. : -1.));
      }
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b)
      {
        const Vector3 na = gradient.row(a), nb = gradient.row(b);
        stiffness_.block<3, 3>(3 * a, 3 * b) +=
            1. / n_points *
            (lambda * na * nb.transpose() +
             mu * (na.dot(nb) * Eigen::Matrix3d::Identity() + nb * na.transpose()));
        for (int d = 0; d < 3; ++d)
          stiffness_(3 * a + d, 3 * b + d) += 2. * (tetragonal - mu) / n_points * na[d] * nb[d];
      }
  }
  // Hourglass vectors: products of two or three corner coordinates. FiniteElementBody::Options
  // says where the stiffness comes from.
  if (quadrature == Quadrature::one_point)
    for (const int axes : {6, 5, 3, 7})
    {
      const double k  = hourglass_coefficient * E / (axes == 7 ? 144. : 48.);
      const auto sign = [&](const int corner)
      {
        double product = 1.;
        for (int d = 0; d < 3; ++d)
          if ((axes >> d) & 1)
            product *= (corner >> d) & 1 ? 1. : -1.;
        return product;
      };
      for (int a = 0; a < 8; ++a)
        for (int b = 0; b < 8; ++b)
          stiffness_.block<3, 3>(3 * a, 3 * b) +=
              k * sign(a) * sign(b) * Eigen::Matrix3d::Identity();
    }
  stiffness_ /= material.density * edge * edge;
}

WaveMatrix ElementDispersion::matrix(const Vector3 &k) const
{
  WaveMatrix result = WaveMatrix::Zero();
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b)
      result += std::cos(k.dot(corner_position(b) - corner_position(a))) *
                stiffness_.block<3, 3>(3 * a, 3 * b);
  return 0.5 * (result + result.transpose()); // rounding
}

double ElementDispersion::largest_squared_frequency() const
{
  return largest_over_wave_vectors(*this);
}

double ElementDispersion::largest_squared_frequency_of_block(const int n) const
{
  const int n_nodes = (n + 1) * (n + 1) * (n + 1);
  const auto node   = [&](const int cell, const int corner)
  {
    const int i = cell % n + (corner & 1), j = cell / n % n + ((corner >> 1) & 1),
              k = cell / (n * n) + (corner >> 2);
    return i + (n + 1) * (j + (n + 1) * k);
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * n_nodes, 3 * n_nodes);
  Eigen::VectorXd mass   = Eigen::VectorXd::Zero(n_nodes); // in those of a cube
  for (int cell = 0; cell < n * n * n; ++cell)
    for (int a = 0; a < 8; ++a)
    {
      mass[node(cell, a)] += 0.125;
      for (int b = 0; b < 8; ++b)
        matrix.block<3, 3>(3 * node(cell, a), 3 * node(cell, b)) +=
            stiffness_.block<3, 3>(3 * a, 3 * b);
    }
  for (int a = 0; a < n_nodes; ++a)
    for (int b = 0; b < n_nodes; ++b)
      matrix.block<3, 3>(3 * a, 3 * b) /= std::sqrt(mass[a] * mass[b]);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[3 * n_nodes - 1];
}

PredictedTimeStep predicted_time_step(const PeridynamicBody &points, const CoupledPlateOptions *far)
{
  const auto &m       = points.material();
  const auto &stencil = points.lattice().stencil();
  const LatticeDispersion lattice(stencil, *m.law, m.density, m.bulk_modulus, m.shear_modulus);
  PredictedTimeStep result{2. / std::sqrt(lattice.largest_squared_frequency()),
                           std::numeric_limits<double>::infinity()};
  if (far != nullptr)
  {
    const ElementDispersion elements(far->coupling.points_per_edge * stencil.spacing,
                                     material_of(points), far->quadrature,
                                     far->hourglass_coefficient);
    result.elements = 2. / std::sqrt(elements.largest_squared_frequency_of_block());
  }
  return result;
}
} // namespace ricochet
