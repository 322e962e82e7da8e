// SPDX-License-Identifier: LGPL-2.1-or-later
// The test that a run makes of its interface; what it finds for many blocks is in
// verification/test_patch.cc.
#include "support/coupled_plate.h"

#include "ricochet/coupling/interface_patch_test.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
CoupledSample block()
{
  CoupledSample sample;
  sample.communicator          = MPI_COMM_SELF;
  sample.coupling.correct_mass = false;
  sample.n_cells               = {16, 16, 16};
  sample.zone                  = {{6, 6, 6}, {10, 10, 10}};
  return sample;
}

TEST(InterfacePatchTest, FindsTheGhostForceOfTheCalibrationAndASmallStrainError)
{
  PlateModel plate(block());
  const auto report = patch_test(MPI_COMM_SELF, *plate.far);
  EXPECT_EQ(report.n_strains, 6);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(report.ghost_force, plate.far->calibration().ghost_after, 1e-6);
  EXPECT_GT(report.strain_error, 0.);
  EXPECT_LT(report.strain_error, 2e-3);
  // A hundred times smaller a residual changes the error by the per cent that is promised.
  const auto sharper = patch_test(MPI_COMM_SELF, *plate.far, 1000, 1e-4);
  EXPECT_GT(sharper.n_iterations, report.n_iterations);
  EXPECT_NEAR(report.strain_error, sharper.strain_error, 0.02 * sharper.strain_error);
}

TEST(InterfacePatchTest, LeavesThePlateAtRest)
{
  PlateModel plate(block());
  patch_test(MPI_COMM_SELF, *plate.far);
  EXPECT_EQ(plate.far->elements().position(), plate.far->elements().mesh().reference());
  plate.for_each_free(
      [&](const std::ptrdiff_t p, const Vector3 &X)
      {
        for (int d = 0; d < 3; ++d)
          EXPECT_EQ(plate.points->state().arrays.position[d][p], X[d]);
      });
}

TEST(InterfacePatchTest, SaysIfItHasNotConverged)
{
  PlateModel plate(block());
  const auto report = patch_test(MPI_COMM_SELF, *plate.far, /*most_iterations=*/2);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.n_iterations, 6 * 2);
  EXPECT_FALSE(patch_test(MPI_COMM_SELF, *plate.far, /*most_iterations=*/0).converged);
}
} // namespace
} // namespace ricochet::tests
