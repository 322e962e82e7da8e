// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/hex_solid.h"

#include "ricochet/base/exceptions.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace ricochet
{
namespace
{
// Corners of the faces, counter-clockwise seen from outside.
constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

/// Volume and first moment of a cell: 2 x 2 x 2 Gauss points are exact for the volume.
std::pair<double, Vector3> moments(const HexSolid &solid, const int cell)
{
  double volume = 0.;
  Vector3 first = Vector3::Zero();
  for (int point = 0; point < 8; ++point)
  {
    double xi[3];
    for (int d = 0; d < 3; ++d)
      xi[d] = ((point >> d) & 1 ? 1. : -1.) / std::sqrt(3.);
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    Vector3 place     = Vector3::Zero();
    for (int a = 0; a < 8; ++a)
    {
      double factor[3], sign[3];
      for (int d = 0; d < 3; ++d)
      {
        sign[d]   = (a >> d) & 1 ? 1. : -1.;
        factor[d] = 1. + sign[d] * xi[d];
      }
      const Vector3 &X = solid.nodes[solid.cells[cell][a]];
      for (int d = 0; d < 3; ++d)
        J.col(d) += sign[d] * factor[(d + 1) % 3] * factor[(d + 2) % 3] / 8. * X;
      place += factor[0] * factor[1] * factor[2] / 8. * X;
    }
    const double weight = J.determinant();
    volume += weight;
    first += weight * place;
  }
  return {volume, first};
}
} // namespace

double cell_volume(const HexSolid &solid, const int cell)
{
  return moments(solid, cell).first;
}

CellIntegrals integrals(const HexSolid &solid, const int cell)
{
  Eigen::Matrix<double, 3, 8> X;
  for (int a = 0; a < 8; ++a)
    X.col(a) = solid.nodes[solid.cells[cell][a]];
  CellIntegrals sum;
  for (int point = 0; point < 8; ++point)
  {
    Eigen::Matrix<double, 8, 3> derivative; // dN_a/dxi
    Eigen::Matrix<double, 8, 1> N;
    for (int a = 0; a < 8; ++a)
    {
      double sign[3], factor[3];
      for (int d = 0; d < 3; ++d)
      {
        sign[d]   = (a >> d) & 1 ? 1. : -1.;
        factor[d] = 1. + sign[d] * ((point >> d) & 1 ? 1. : -1.) / std::sqrt(3.);
      }
      N[a] = factor[0] * factor[1] * factor[2] / 8.;
      for (int d = 0; d < 3; ++d)
        derivative(a, d) = sign[d] * factor[(d + 1) % 3] * factor[(d + 2) % 3] / 8.;
    }
    const Eigen::Matrix3d J = X * derivative;
    const double weight     = J.determinant();
    sum.volume += weight;
    sum.gradient += weight * derivative * J.inverse();
    sum.shape += weight * N;
  }
  return sum;
}

std::array<double, 8> shape_functions(const Vector3 &natural)
{
  std::array<double, 8> N;
  for (int a = 0; a < 8; ++a)
  {
    N[a] = 1.;
    for (int d = 0; d < 3; ++d)
      N[a] *= 0.5 * (1. + ((a >> d) & 1 ? natural[d] : -natural[d]));
  }
  return N;
}

Vector3 natural_coordinates(const HexSolid &solid, const int cell, const Vector3 &place)
{
  Vector3 natural = Vector3::Zero();
  for (int iteration = 0; iteration < 30; ++iteration)
  {
    const auto N          = shape_functions(natural);
    Vector3 miss          = -place;
    Eigen::Matrix3d J     = Eigen::Matrix3d::Zero();
    constexpr double half = 0.5;
    for (int a = 0; a < 8; ++a)
    {
      const Vector3 &X = solid.nodes[solid.cells[cell][a]];
      miss += N[a] * X;
      for (int d = 0; d < 3; ++d)
      {
        double slope = (a >> d) & 1 ? half : -half;
        for (int other = 0; other < 3; ++other)
          if (other != d)
            slope *= half * (1. + ((a >> other) & 1 ? natural[other] : -natural[other]));
        J.col(d) += slope * X;
      }
    }
    const Vector3 step = J.inverse() * miss;
    natural -= step;
    if (step.cwiseAbs().maxCoeff() < 1e-12)
      return natural;
    if (!(natural.cwiseAbs().maxCoeff() < 20.))
      break;
  }
  return Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
}

double volume(const HexSolid &solid)
{
  double sum = 0.;
  for (std::size_t cell = 0; cell < solid.cells.size(); ++cell)
    sum += cell_volume(solid, static_cast<int>(cell));
  return sum;
}

Vector3 centroid(const HexSolid &solid)
{
  double sum    = 0.;
  Vector3 first = Vector3::Zero();
  for (std::size_t cell = 0; cell < solid.cells.size(); ++cell)
  {
    const auto part = moments(solid, static_cast<int>(cell));
    sum += part.first;
    first += part.second;
  }
  return first / sum;
}

double scaled_jacobian(const HexSolid &solid, const int cell)
{
  double worst        = std::numeric_limits<double>::max();
  const auto &corners = solid.cells[cell];
  for (int a = 0; a < 8; ++a)
  {
    Eigen::Matrix3d edges;
    for (int d = 0; d < 3; ++d)
    {
      // From the corner along the axis d, in the direction of the axis.
      const int low = a & ~(1 << d), high = a | (1 << d);
      const Vector3 edge = solid.nodes[corners[high]] - solid.nodes[corners[low]];
      const double norm  = edge.norm();
      if (!(norm > 0.))
        return 0.;
      edges.col(d) = edge / norm;
    }
    worst = std::min(worst, edges.determinant());
  }
  return worst;
}

double smallest_edge(const HexSolid &solid)
{
  double smallest = std::numeric_limits<double>::max();
  for (const auto &corners : solid.cells)
    for (int a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d)
        if (!((a >> d) & 1))
          smallest = std::min(
              smallest, (solid.nodes[corners[a | (1 << d)]] - solid.nodes[corners[a]]).norm());
  return smallest;
}

std::vector<SurfaceQuad> surface_of(const HexSolid &solid)
{
  std::map<std::array<int, 4>, std::pair<SurfaceQuad, int>> count; // by the sorted nodes
  for (const auto &corners : solid.cells)
    for (const auto &face : faces)
    {
      SurfaceQuad quad;
      for (int i = 0; i < 4; ++i)
        quad[i] = corners[face[i]];
      auto sorted = quad;
      std::sort(sorted.begin(), sorted.end());
      auto &entry = count[sorted];
      entry.first = quad;
      if (++entry.second > 2)
        throw InputError("Three hexahedra of the mesh share one face, with the nodes " +
                         std::to_string(quad[0] + 1) + ", " + std::to_string(quad[1] + 1) + ", " +
                         std::to_string(quad[2] + 1) + " and " + std::to_string(quad[3] + 1) +
                         ".\n  Remove duplicate elements.");
    }
  std::vector<SurfaceQuad> surface;
  for (const auto &[sorted, entry] : count)
    if (entry.second == 1)
      surface.push_back(entry.first);
  return surface;
}

HexSolid upper_half(const HexSolid &solid, const double tolerance)
{
  HexSolid half;
  std::vector<int> number(solid.nodes.size(), -1);
  for (const auto &corners : solid.cells)
  {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const int node : corners)
    {
      low  = std::min(low, solid.nodes[node].y());
      high = std::max(high, solid.nodes[node].y());
    }
    if (low < -tolerance && high > tolerance)
      throw InputError("A hexahedron of the mesh lies on both sides of the symmetry plane y = 0, "
                       "from y = " +
                       std::to_string(1e3 * low) + " to " + std::to_string(1e3 * high) +
                       " mm.\n  Cut the mesh along y = 0, or set 'Symmetric = false'.");
    if (high <= tolerance)
      continue;
    half.cells.push_back(corners);
    for (int &node : half.cells.back())
    {
      if (number[node] < 0)
      {
        number[node] = static_cast<int>(half.nodes.size());
        half.nodes.push_back(solid.nodes[node]);
        if (half.nodes.back().y() <= tolerance)
          half.nodes.back().y() = 0.;
      }
      node = number[node];
    }
  }
  return half;
}
} // namespace ricochet
