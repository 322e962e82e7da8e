// SPDX-License-Identifier: LGPL-2.1-or-later
// V1: a peridynamic block with faces, edges and corners inside a box of elements under uniform
// strain. V2: the same body moved as a rigid one.
#include "support/static_solution.h"
#include "support/verification.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ricochet::tests
{
namespace
{
CoupledSample block()
{
  CoupledSample sample;
  sample.communicator          = MPI_COMM_SELF;
  sample.coupling.correct_mass = false;
  return sample;
}

/// Largest ghost force per strain, in units of M eps h^2.
std::array<double, 6> ghosts(PlateModel &plate, const double strain = 1e-6)
{
  std::array<double, 6> result;
  const double h   = plate.edge();
  const auto &n    = plate.zone->n_cells();
  const auto inner = [&](const Vector3 &X)
  {
    for (int d = 0; d < 3; ++d)
      if (X[d] < 0.5 * h || X[d] > (n[d] - 0.5) * h)
        return false;
    return true;
  };
  for (int k = 0; k < 6; ++k)
  {
    const auto F = strained(k, strain);
    plate.deform([&](const Vector3 &X) -> Vector3 { return F * X; });
    result[k] = plate.largest_force(inner) / (PlateModel::modulus * strain * h * h);
  }
  return result;
}

/// Largest error of any strain in any element or cell of points, in units of the strain, after the
/// plate has relaxed with its outermost nodes held under that strain.
double worst_strain_error(PlateModel &plate, const int number)
{
  const double strain = 1e-6, h = plate.edge();
  const auto F  = strained(number, strain);
  const auto &n = plate.zone->n_cells();
  StaticSolution solution(plate,
                          [&](const Vector3 &X, int)
                          {
                            for (int d = 0; d < 3; ++d)
                              if (X[d] < 0.1 * h || X[d] > (n[d] - 0.1) * h)
                                return true;
                            return false;
                          });
  for (std::size_t i = 0; i < solution.size(); ++i)
    for (int d = 0; d < 3; ++d)
      solution.displacement(i, d) = (F * solution.reference(i) - solution.reference(i))[d];
  const int n_steps = solution.solve(1e-4);
  EXPECT_GT(n_steps, 0);
  EXPECT_LT(n_steps, 1000);
  double worst = 0.;
  solution.for_each_strain(
      [&](const Zone::Cell &, const Eigen::Matrix3d &e)
      {
        const Eigen::Matrix3d error = e - (F - Eigen::Matrix3d::Identity());
        worst                       = std::max(worst, error.cwiseAbs().maxCoeff() / strain);
      });
  return worst;
}

/// Two blocks that meet at a re-entrant edge and corners.
CoupledSample bent_block()
{
  CoupledSample sample = block();
  sample.n_cells       = {16, 14, 14};
  sample.zone          = {{5, 5, 5}, {11, 7, 9}};
  return sample;
}

void add_second_arm(PlateModel &plate)
{
  EXPECT_TRUE(plate.far->convert({{{5, 5, 5}, {8, 9, 7}}}));
}

TEST(V1Patch, GhostForcesOfABlockWithCorners)
{
  PlateModel plate(block());
  const auto &report = plate.far->calibration();
  EXPECT_GT(report.ghost_before, 0.05) << "nothing to calibrate"; // the scaled C alone
  EXPECT_LT(report.n_iterations, 100);
  const auto measured    = ghosts(plate);
  // In units of sigma h^2: M eps h^2, and for shear mu gamma h^2.
  const double mu_over_M = plate.points->material().shear_modulus / PlateModel::modulus;
  for (int k = 0; k < 6; ++k)
    verify_at_most("V1", "ghost forces of a block with corners, six strains [σh²]",
                   measured[k] / (k < 3 ? 1. : mu_over_M), 2e-3);
  // What calibration believes is what the bonds and elements do.
  EXPECT_NEAR(*std::max_element(measured.begin(), measured.end()), report.ghost_after, 1e-6);
}

TEST(V1Patch, GhostForcesFallAsFarAsCalibrationIsAskedTo)
{
  CoupledSample sample                  = block();
  sample.coupling.calibration.tolerance = 1e-5;
  PlateModel plate(sample);
  for (const double ghost : ghosts(plate))
    verify_at_most("V1", "ghost forces if calibrated to 1e-5 [Mεh²]", ghost, 1.1e-5);
}

TEST(V1Patch, StrainErrorOfABlockWithCorners)
{
  PlateModel plate(block());
  for (int k = 0; k < 6; ++k)
    verify_at_most("V1", "strain error of a block with corners, six strains",
                   worst_strain_error(plate, k), 2e-3);
}

TEST(V1Patch, ElementsOfOneAndOfFourSpacings)
{
  for (const int n : {1, 4})
  {
    CoupledSample sample            = block();
    sample.coupling.points_per_edge = n;
    const int outside = n == 1 ? 7 : 4, inside = 8 / n, all = inside + 2 * outside;
    sample.n_cells = {all, all, all};
    sample.zone    = {{outside, outside, outside},
                      {outside + inside, outside + inside, outside + inside}};
    PlateModel plate(sample);
    for (const double ghost : ghosts(plate))
      verify_at_most("V1", "ghost forces next to elements of 1 and 4 spacings [Mεh²]", ghost, 2e-3);
    for (int k = 0; k < 6; ++k)
      verify_at_most("V1", "strain error next to elements of 1 and 4 spacings",
                     worst_strain_error(plate, k), 2e-3);
  }
}

TEST(V1Patch, ZoneWithReentrantEdges)
{
  PlateModel plate(bent_block());
  add_second_arm(plate);
  for (const double ghost : ghosts(plate))
    verify_at_most("V1", "ghost forces of a zone with reentrant edges [Mεh²]", ghost, 2e-3);
  for (int k = 0; k < 6; ++k)
    verify_at_most("V1", "strain error of a zone with reentrant edges",
                   worst_strain_error(plate, k), 2e-3);
}

TEST(V1Patch, LargerZone)
{
  CoupledSample sample = block();
  sample.n_cells       = {20, 20, 20};
  sample.zone          = {{4, 4, 4}, {16, 16, 16}};
  PlateModel plate(sample);
  for (const double ghost : ghosts(plate))
    verify_at_most("V1", "ghost forces of a larger block [Mεh²]", ghost, 2e-3);
  for (const int k : {0, 5})
    verify_at_most("V1", "strain error of a larger block", worst_strain_error(plate, k), 2e-3);
}

TEST(V1Patch, OtherPoissonRatiosAndHorizons)
{
  for (const double nu : {0.25, 0.4})
  {
    CoupledSample sample = block();
    sample.poisson_ratio = nu;
    PlateModel plate(sample);
    for (const double ghost : ghosts(plate))
      verify_at_most("V1", "ghost forces with ν = 0.25 and 0.4 [Mεh²]", ghost, 2e-3);
  }
  // Reach 3: two cells of pad and two of halo.
  CoupledSample sample = block();
  sample.horizon_ratio = 4.;
  sample.n_cells       = {16, 16, 16};
  sample.zone          = {{6, 6, 6}, {10, 10, 10}};
  PlateModel plate(sample);
  EXPECT_EQ(plate.zone->pad_layers(), 2);
  EXPECT_EQ(plate.zone->slaved_layers(), 4);
  for (const double ghost : ghosts(plate))
    verify_at_most("V1", "ghost forces with a horizon of 4 spacings [Mεh²]", ghost, 2e-3);
}

TEST(V1Patch, WithoutCalibrationTheBlendIsWrong)
{
  // What calibration is for: the plain energy blend over two horizons leaves per cents (the list's
  // survey found 11 % in two dimensions).
  CoupledSample sample   = block();
  sample.coupling.method = CouplingMethod::energy_blend;
  sample.n_cells         = {18, 18, 18};
  sample.zone            = {{7, 7, 7}, {11, 11, 11}};
  PlateModel plate(sample);
  double worst = 0.;
  for (const double ghost : ghosts(plate))
    worst = std::max(worst, ghost);
  verify_at_least("V1", "ghost forces without calibration [Mεh²]", worst, 1e-2);
}

TEST(V2RigidMotion, TranslationAndQuarterTurnsCauseNoForce)
{
  PlateModel plate(block());
  const double unit = PlateModel::modulus * plate.spacing * plate.spacing;
  const auto all    = [](const Vector3 &) { return true; };
  const Vector3 far(0.7e-3, -1.3e-3, 2.1e-3);
  plate.deform([&](const Vector3 &X) -> Vector3 { return X + far; });
  verify_at_most("V2", "force in a coupled body that was shifted [Mh²]",
                 plate.largest_force(all) / unit, 1e-12);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Eigen::AngleAxisd turn(M_PI / 2., Vector3::Unit(axis));
    plate.deform([&](const Vector3 &X) -> Vector3 { return turn * X; });
    verify_at_most("V2", "force in a coupled body that was turned by 90° [Mh²]",
                   plate.largest_force(all) / unit, 1e-12);
    EXPECT_LE(plate.far->energies(0.).strain, 1e-24 * unit * plate.spacing);
  }
}
} // namespace
} // namespace ricochet::tests
