// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/coupled_plate.h"

#include "coupling/hex_tensors.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <map>

namespace ricochet::tests
{
namespace
{
CoupledSample block(const double horizon_ratio)
{
  CoupledSample sample;
  sample.communicator  = MPI_COMM_SELF;
  sample.horizon_ratio = horizon_ratio;
  // No node of the elements around lies in the softened layer, of three cells and less.
  sample.n_cells       = {20, 20, 20};
  sample.zone          = {{8, 8, 8}, {12, 12, 12}};
  return sample;
}

Calibration calibration_of(const PlateModel &plate, const CalibrationOptions &options = {})
{
  const auto &m = plate.points->material();
  return {MPI_COMM_SELF,
          *plate.points,
          plate.far->elements(),
          {m.bulk_modulus, m.shear_modulus},
          options};
}

std::map<int, GaussPointTensors> by_element(const std::vector<ElementStiffness> &stiffness)
{
  std::map<int, GaussPointTensors> result;
  for (const auto &one : stiffness)
    result[one.element] = one.tensors;
  return result;
}

TEST(Calibration, MendsAllForcesWithoutNegativeTensorsForAnyHorizon)
{
  for (const double horizon_ratio : {3., 4.})
  {
    const PlateModel plate(block(horizon_ratio));
    auto calibration     = calibration_of(plate);
    const auto stiffness = calibration.find();
    const auto &report   = calibration.report();
    EXPECT_EQ(report.n_elements, plate.zone->n_slaved_cells());
    EXPECT_GT(report.ghost_before, 0.05);
    EXPECT_LE(report.ghost_after, CalibrationOptions().tolerance);
    EXPECT_LT(report.n_iterations, CalibrationOptions().n_iterations);
    std::printf("horizon of %.0f spacings: ghost force %.1e to %.1e in %d iterations\n",
                horizon_ratio, report.ghost_before, report.ghost_after, report.n_iterations);
    double least = 1.;
    for (const auto &one : stiffness)
      for (const auto &tensor : one.tensors)
        least = std::min(
            least,
            Eigen::SelfAdjointEigenSolver<Matrix6>(unpacked(tensor)).eigenvalues().minCoeff() /
                PlateModel::modulus);
    EXPECT_GT(least, -1e-9);
  }
}

TEST(Calibration, FindsAgainWhatItHasFoundWithoutSearching)
{
  const PlateModel plate(block(3.));
  auto calibration = calibration_of(plate);
  const auto first = by_element(calibration.find());
  const auto again = by_element(calibration.find());
  EXPECT_EQ(calibration.report().n_iterations, 0);
  EXPECT_EQ(first, again);
}

TEST(Calibration, LeavesCellsAloneWhoseSurroundingsStay)
{
  auto sample    = block(3.);
  sample.n_cells = {26, 16, 16};
  sample.zone    = {{6, 6, 6}, {18, 10, 10}};
  PlateModel plate(sample);
  auto calibration = calibration_of(plate);
  const auto first = by_element(calibration.find());
  // Two cells more at one end: those at the other end see nothing of it.
  plate.zone->grow({{{18, 6, 6}, {20, 10, 10}}});
  const auto after = by_element(calibration.find());
  const auto &mesh = plate.far->elements().mesh();
  int n_same       = 0;
  for (const auto &[element, tensors] : first)
    if (cell_at(plate.points->lattice(), mesh.centre(mesh.elements()[element]))[0] < 7)
    {
      ++n_same;
      EXPECT_TRUE(after.at(element) == tensors) << "element " << element;
    }
  EXPECT_GT(n_same, 50);
}

TEST(Calibration, TakesAboutAsManyStepsHoweverOftenEigenvaluesAreLookedAt)
{
  // A column through the plate, whose tensors become negative on the way.
  auto sample    = block(3.);
  sample.n_cells = {20, 20, 6};
  sample.zone    = {{6, 6, 0}, {14, 14, 6}};
  const PlateModel plate(sample);
  for (const int round : {3, 7, 21})
  {
    CalibrationOptions options;
    options.round    = round;
    auto calibration = calibration_of(plate, options);
    calibration.find();
    const auto &report = calibration.report();
    std::printf("rounds of %d: %d iterations, smallest eigenvalue on the way %.1e\n", round,
                report.n_iterations, report.smallest_eigenvalue);
    EXPECT_LT(report.smallest_eigenvalue, 0.);
    EXPECT_NEAR(report.n_iterations, 75, 15);
  }
}

TEST(Calibration, SaysIfItsIterationsDidNotSuffice)
{
  const PlateModel plate(block(3.));
  CalibrationOptions options;
  options.n_iterations = 3;
  auto calibration     = calibration_of(plate, options);
  calibration.find();
  EXPECT_EQ(calibration.report().n_iterations, 3);
  EXPECT_GT(calibration.report().ghost_after, options.tolerance);
}
} // namespace
} // namespace ricochet::tests
