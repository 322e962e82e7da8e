// SPDX-License-Identifier: LGPL-2.1-or-later
// The one-dimensional system that a bar along x becomes when all points and nodes of a plane move
// alike along x: its matrix, measured with the very force routines. What the middle of a section
// sixteen points wide feels is then what an infinitely wide plate with a plane interface would
// feel.
#pragma once

#include "support/coupled_plate.h"

#include <algorithm>
#include <complex>

namespace ricochet::tests
{
struct PlaneSystem
{
  Eigen::MatrixXd acceleration; // of plane i per displacement of plane j [1/s^2]
  Eigen::VectorXd x;            // of the planes, ascending [m]
  Eigen::VectorXd mass;         // lumped, per area [kg/m^2]
  std::vector<char> is_point;   // or a plane of nodes

  Eigen::Index size() const { return x.size(); }
  Eigen::MatrixXd stiffness() const { return -(mass.asDiagonal() * acceleration); } // [Pa/m]
};

/// Points across the bars.
constexpr int section_points = 16;

/// A bar of so many cells with the zone from cell `low` to `high` along x.
inline CoupledSample bar(const int n_cells, const int low, const int high,
                         const int points_per_edge = 2)
{
  CoupledSample sample;
  sample.coupling.points_per_edge = points_per_edge;
  const int section_cells         = section_points / points_per_edge;
  sample.communicator             = MPI_COMM_SELF;
  sample.n_cells                  = {n_cells, section_cells, section_cells};
  sample.zone                     = {{low, 0, 0}, {high, section_cells, section_cells}};
  return sample;
}

inline PlaneSystem plane_system(PlateModel &plate)
{
  const double dx     = plate.spacing;
  const double middle = 0.5 * section_points * dx; // of the section
  auto &a             = plate.points->state().arrays;
  auto &elements      = plate.far->elements();
  struct Plane
  {
    double x;
    bool is_point;
    std::ptrdiff_t centre;
  };
  std::vector<Plane> planes;
  const auto is_centre = [&](const double y, const double z, const double off)
  { return std::abs(y - middle - off) < 0.1 * dx && std::abs(z - middle - off) < 0.1 * dx; };
  plate.for_each_free(
      [&](const std::ptrdiff_t p, const Vector3 &X)
      {
        if (is_centre(X.y(), X.z(), 0.5 * dx))
          planes.push_back({X.x(), true, p});
      });
  for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    if (const Vector3 X = elements.mesh().reference_position(node);
        elements.mass(node) > 0. && is_centre(X.y(), X.z(), 0.))
      planes.push_back({X.x(), false, node});
  std::sort(planes.begin(), planes.end(), [](const Plane &p, const Plane &q) { return p.x < q.x; });

  PlaneSystem result;
  const auto n = static_cast<Eigen::Index>(planes.size());
  result.acceleration.setZero(n, n);
  result.x.resize(n);
  result.mass.resize(n);
  const double area = plate.edge() * plate.edge();
  for (Eigen::Index i = 0; i < n; ++i)
  {
    result.x[i] = planes[i].x;
    result.is_point.push_back(planes[i].is_point);
    result.mass[i] = planes[i].is_point ? PlateModel::density * dx
                                        : elements.mass(static_cast<int>(planes[i].centre)) / area;
  }
  // Planes so far apart do not feel each other: one evaluation for a whole comb of them. Mesh and
  // lattice coordinates of a plane differ by rounding only.
  const double apart = 32. * dx, amplitude = 1e-6 * dx;
  for (const bool points : {true, false})
    for (int tooth = 0; tooth < std::lround(apart / (points ? dx : plate.edge())); ++tooth)
    {
      const double first = points ? (tooth + 0.5) * dx : tooth * plate.edge();
      const auto moves   = [&](const double x)
      {
        const double t = (x - first) / apart;
        return std::abs(t - std::round(t)) * apart < 0.1 * dx;
      };
      plate.for_each_free(
          [&](const std::ptrdiff_t p, const Vector3 &X)
          {
            for (int d = 0; d < 3; ++d)
              a.position[d][p] = X[d];
            if (points && moves(X.x()))
              a.position[0][p] += amplitude;
          });
      for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
      {
        const Vector3 X = elements.mesh().reference_position(node);
        for (int d = 0; d < 3; ++d)
          elements.position()[3 * node + d] = X[d];
        if (!points && moves(X.x()))
          elements.position()[3 * node] += amplitude;
      }
      plate.far->lead();
      plate.evaluate(/*energy=*/false);
      for (Eigen::Index j = 0; j < n; ++j)
        if (planes[j].is_point == points && moves(planes[j].x))
          for (Eigen::Index i = 0; i < n; ++i)
            if (std::abs(planes[i].x - planes[j].x) < 0.5 * apart)
            {
              const auto c = planes[i].centre;
              result.acceleration(i, j) =
                  (planes[i].is_point
                       ? a.force[0][c] / plate.points->point_mass()
                       : elements.force()[3 * c] * elements.inverse_mass(static_cast<int>(c), 0)) /
                  amplitude;
            }
    }
  return result;
}
} // namespace ricochet::tests
