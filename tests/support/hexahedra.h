// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids of distorted hexahedra for tests, and the textbook's fully integrated element.
#pragma once

#include "ricochet/finite_elements/hexahedral_body.h"
#include "support/random.h"

#include <Eigen/Dense>

#include <cmath>

namespace ricochet::tests
{
inline FiniteElementMaterial elastic(const double E, const double nu, const double density)
{
  return {density, E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu))};
}

/// E 202 GPa, nu 0.30, 7850 kg/m^3.
inline FiniteElementMaterial steel()
{
  return elastic(202e9, 0.3, 7850.);
}

/// nx x ny x nz cells of edge h from `corner` on; inner nodes moved by up to `distortion` edges.
inline HexSolid block(const std::array<int, 3> &n, const double h, const double distortion = 0.,
                      const Vector3 &corner = Vector3::Zero())
{
  Random random(11);
  HexSolid solid;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
      {
        Vector3 x = h * Vector3(i, j, k);
        if (i > 0 && i < n[0] && j > 0 && j < n[1] && k > 0 && k < n[2])
          x += distortion * h * random.vector();
        solid.nodes.push_back(corner + x);
      }
  const auto number = [&](const int i, const int j, const int k)
  { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
      {
        std::array<int, 8> cell;
        for (int a = 0; a < 8; ++a)
          cell[a] = number(i + (a & 1), j + ((a >> 1) & 1), k + (a >> 2));
        solid.cells.push_back(cell);
      }
  return solid;
}

/// All nodes moved: no two elements are alike, no face is flat.
inline HexSolid distorted_block(const std::array<int, 3> &n, const double h,
                                const double distortion)
{
  HexSolid solid = block(n, h);
  Random random(12);
  for (auto &x : solid.nodes)
    x += distortion * h * random.vector();
  return solid;
}

inline Vector3 node_of(const std::vector<double> &values, const int node)
{
  return {values[3 * node], values[3 * node + 1], values[3 * node + 2]};
}

template <class Map>
void deform(HexahedralBody &body, Map &&map)
{
  for (int node = 0; node < body.n_nodes(); ++node)
  {
    const Vector3 x = map(body.solid().nodes[node]);
    for (int d = 0; d < 3; ++d)
      body.position()[3 * node + d] = x[d];
  }
  body.compute_internal_forces({/*energy=*/true});
}

/// Forces and energy of one element with 2 x 2 x 2 Gauss points, St Venant-Kirchhoff.
struct FullyIntegrated
{
  Eigen::Matrix<double, 3, 8> force = Eigen::Matrix<double, 3, 8>::Zero();
  double energy                     = 0.;

  FullyIntegrated(const Eigen::Matrix<double, 3, 8> &X, const Eigen::Matrix<double, 3, 8> &x,
                  const double lambda, const double mu)
  {
    for (int point = 0; point < 8; ++point)
    {
      Eigen::Matrix<double, 8, 3> derivative;
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d)
        {
          double value = (a >> d) & 1 ? 0.125 : -0.125;
          for (int e = 0; e < 3; ++e)
            if (e != d)
              value *=
                  1. + ((a >> e) & 1 ? 1. : -1.) * ((point >> e) & 1 ? 1. : -1.) / std::sqrt(3.);
          derivative(a, d) = value;
        }
      const Eigen::Matrix3d J                    = X * derivative;
      const Eigen::Matrix<double, 8, 3> gradient = derivative * J.inverse();
      const Eigen::Matrix3d F                    = x * gradient;
      const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
      const Eigen::Matrix3d S = lambda * E.trace() * Eigen::Matrix3d::Identity() + 2. * mu * E;
      const double weight     = J.determinant();
      force -= weight * F * S * gradient.transpose();
      energy += 0.5 * weight * (S * E).trace();
    }
  }
};
} // namespace ricochet::tests
