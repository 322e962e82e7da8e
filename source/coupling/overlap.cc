// SPDX-License-Identifier: LGPL-2.1-or-later
#include "overlap.h"

#include "ricochet/base/exceptions.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ricochet
{
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

CellFinder::CellFinder(const HexSolid &solid, const double plane) : solid_(solid)
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

std::pair<int, std::array<double, 8>> CellFinder::find(const Vector3 &place) const
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

std::map<int, double> nodes_followed(const CellFinder &finder, const Vector3 &centre,
                                     const double edge, const int n, std::vector<char> &overlaps)
{
  // Quarters, down to the centre alone: the largest cube that lies in the elements.
  for (const double size : {1., 0.75, 0.5, 0.25, 0.})
  {
    std::map<int, double> nodes;
    std::vector<int> cells;
    for (int part = 0; part < n * n * n; ++part)
    {
      const std::array<int, 3> along{part % n, part / n % n, part / (n * n)};
      const Vector3 place(along[0], along[1], along[2]);
      const Vector3 offset = (place.array() + 0.5) / n - 0.5;
      const auto [cell, N] = finder.find(centre + size * edge * offset);
      if (cell < 0)
        break;
      cells.push_back(cell);
      for (int corner = 0; corner < 8; ++corner)
        nodes[finder.solid().cells[cell][corner]] += N[corner] / (n * n * n);
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

Eigen::Matrix<double, 3, 8> nodal_forces(const HexSolid &solid, const int cell,
                                         const Eigen::Matrix3d &stress)
{
  return -stress * integrals(solid, cell).gradient.transpose();
}

namespace
{
using Matrix = Eigen::SparseMatrix<double>;

Eigen::VectorXd least_squares(const Matrix &A, const Eigen::VectorXd &b,
                              const LeastSquaresLimits &limits)
{
  Eigen::LeastSquaresConjugateGradient<Matrix> solver;
  solver.setTolerance(limits.tolerance);
  if (limits.most_iterations > 0)
    solver.setMaxIterations(limits.most_iterations);
  solver.compute(A);
  Eigen::VectorXd x = solver.solveWithGuess(b, Eigen::VectorXd::Ones(A.cols()));
  if (solver.info() != Eigen::Success || !x.allFinite())
  {
    std::ostringstream message;
    message << "The shares of the " << A.cols()
            << " elements that overlap the points of the projectile were not found: after "
            << solver.iterations() << " iterations " << solver.error()
            << " of the residual is left, where " << limits.tolerance
            << " was due.\n  Change 'Projectile/Peridynamic length', 'Projectile/Grid spacing' or "
               "the mesh.";
    throw RunError(message.str());
  }
  return x;
}
} // namespace

OverlapShares find_overlap_shares(const HexSolid &solid, const std::vector<char> &overlaps,
                                  const bool mirrored, const double E, Eigen::VectorXd missing,
                                  const LeastSquaresLimits &limits)
{
  const Eigen::Matrix3d stress = Vector3(E, 0., 0.).asDiagonal();
  std::vector<int> columns; // elements in the overlap
  std::vector<Eigen::Triplet<double>> entries;
  // A half body has half the force at nodes on its plane, which count once in the whole one, others
  // twice.
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(missing.size());
  double edge            = 0.;
  for (int cell = 0; cell < static_cast<int>(solid.cells.size()); ++cell)
  {
    const auto forces = nodal_forces(solid, cell, stress);
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
      {
        const int node = solid.cells[cell][corner], row = 3 * node + d;
        const bool on_plane = mirrored && solid.nodes[node].y() == 0.;
        if (!overlaps[cell])
          missing[row] -= forces(d, corner);
        else if (!(d == 1 && on_plane))
        {
          counts[row] = on_plane ? std::sqrt(2.) : 1.;
          entries.emplace_back(row, static_cast<int>(columns.size()),
                               counts[row] * forces(d, corner));
        }
      }
    if (overlaps[cell])
    {
      columns.push_back(cell);
      edge += std::cbrt(cell_volume(solid, cell));
    }
  }
  missing = missing.cwiseProduct(counts);

  const int n = static_cast<int>(columns.size());
  Matrix A(missing.size(), n);
  A.setFromTriplets(entries.begin(), entries.end());
  // No part of the energy may be negative.
  const Eigen::VectorXd found = least_squares(A, missing, limits).cwiseMax(0.);
  OverlapShares result;
  result.n_elements = n;
  result.ghost      = (A * found - missing).cwiseAbs().maxCoeff() / (E * edge * edge / n / n);
  result.shares.assign(solid.cells.size(), 1.);
  for (int i = 0; i < n; ++i)
    result.shares[columns[i]] = found[i];
  return result;
}
} // namespace ricochet
