// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coupling/overlap.h"

#include "ricochet/base/exceptions.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// n cubes of 1 mm along x, two by two across.
HexSolid column(const int n)
{
  HexSolid solid;
  const auto node = [](const int x, const int y, const int z) { return 9 * x + 3 * y + z; };
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= 2; ++y)
      for (int z = 0; z <= 2; ++z)
        solid.nodes.emplace_back(1e-3 * x, 1e-3 * y, 1e-3 * z);
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 2; ++z)
      {
        auto &cell = solid.cells.emplace_back();
        for (int corner = 0; corner < 8; ++corner)
          cell[corner] = node(x + (corner & 1), y + ((corner >> 1) & 1), z + (corner >> 2));
      }
  return solid;
}

TEST(Overlap, PartOfAMeshKeepsItsPlaces)
{
  const HexSolid solid = column(3);
  std::vector<char> chosen(solid.cells.size(), 0);
  chosen[8] = chosen[9] = 1; // of the last layer
  std::vector<int> number;
  const HexSolid part = part_of(solid, chosen, number);
  EXPECT_EQ(part.cells.size(), 2u);
  EXPECT_EQ(part.nodes.size(), 12u);
  int n_kept = 0;
  for (std::size_t node = 0; node < number.size(); ++node)
    if (number[node] >= 0)
    {
      ++n_kept;
      EXPECT_EQ(part.nodes[number[node]], solid.nodes[node]);
    }
  EXPECT_EQ(n_kept, 12);
}

TEST(Overlap, PointsFollowALinearMotionExactly)
{
  const HexSolid solid = column(4);
  const CellFinder finder(solid, 0.);
  Eigen::Matrix3d F;
  F << 1.1, 0.2, -0.1, 0.3, 0.9, 0.1, -0.2, 0.1, 1.2;
  // Inside, larger than a cell; at the surface, where the cube sticks out.
  for (const Vector3 &centre : {Vector3(2.1e-3, 0.9e-3, 1.2e-3), Vector3(1.3e-3, 0.1e-3, 1.9e-3)})
  {
    std::vector<char> overlaps(solid.cells.size(), 0);
    const auto nodes = nodes_followed(finder, centre, 1.5e-3, 3, overlaps);
    Vector3 place    = Vector3::Zero();
    double sum       = 0.;
    for (const auto &[node, weight] : nodes)
    {
      place += weight * (F * solid.nodes[node]);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1., 1e-14);
    EXPECT_LT((place - F * centre).norm(), 1e-16);
    EXPECT_GT(std::count(overlaps.begin(), overlaps.end(), 1), 0);
  }
  std::vector<char> overlaps(solid.cells.size(), 0);
  EXPECT_THROW(nodes_followed(finder, Vector3(2e-3, 9e-3, 1e-3), 1e-3, 2, overlaps), InputError);
}

/// Forces that the first two layers of the column would have with a third and two thirds of their
/// energy, under a pull along x, less those of the rest.
struct Problem
{
  static constexpr double E = 202e9; // [Pa]
  HexSolid solid            = column(4);
  std::vector<char> overlaps;
  std::vector<double> shares;
  Eigen::VectorXd missing;

  Problem()
  {
    const Eigen::Matrix3d stress = Vector3(E, 0., 0.).asDiagonal();
    missing                      = Eigen::VectorXd::Zero(3 * Eigen::Index(solid.nodes.size()));
    for (std::size_t cell = 0; cell < solid.cells.size(); ++cell)
    {
      overlaps.push_back(cell < 8);
      shares.push_back(cell < 4 ? 1. / 3. : cell < 8 ? 2. / 3. : 1.);
      const auto forces = nodal_forces(solid, static_cast<int>(cell), stress);
      for (int corner = 0; corner < 8; ++corner)
        missing.segment<3>(3 * solid.cells[cell][corner]) += shares.back() * forces.col(corner);
    }
  }
};

TEST(Overlap, SharesAreFoundWhereTheyExist)
{
  const Problem problem;
  const auto found =
      find_overlap_shares(problem.solid, problem.overlaps, false, Problem::E, problem.missing);
  EXPECT_EQ(found.n_elements, 8);
  EXPECT_LT(found.ghost, 1e-10);
  for (std::size_t cell = 0; cell < problem.shares.size(); ++cell)
    EXPECT_NEAR(found.shares[cell], problem.shares[cell], 1e-10);
}

TEST(Overlap, SharesThatWouldBeNegativeAreZero)
{
  Problem problem;
  problem.missing *= -1.;
  const auto found =
      find_overlap_shares(problem.solid, problem.overlaps, false, Problem::E, problem.missing);
  for (std::size_t cell = 0; cell < problem.shares.size(); ++cell)
    EXPECT_GE(found.shares[cell], 0.);
  EXPECT_GT(found.ghost, 0.1);
}

TEST(Overlap, SharesThatAreNotFoundAreAnError)
{
  const Problem problem;
  LeastSquaresLimits limits;
  limits.most_iterations = 1;
  try
  {
    find_overlap_shares(problem.solid, problem.overlaps, false, Problem::E, problem.missing,
                        limits);
    FAIL() << "nobody asked whether it had converged";
  }
  catch (const RunError &error)
  {
    EXPECT_NE(std::string(error.what()).find("Projectile/Grid spacing"), std::string::npos);
  }
  auto not_finite = problem.missing;
  not_finite[0]   = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(find_overlap_shares(problem.solid, problem.overlaps, false, Problem::E, not_finite),
               RunError);
}
} // namespace
} // namespace ricochet::tests
