// SPDX-License-Identifier: LGPL-2.1-or-later
// What points of a coupled plate feel, on any number of ranks.
#include "ricochet/coupling/plate_stress.h"

#include "support/coupled_plate.h"
#include "support/some_strain.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
using Matrix = Eigen::Matrix3d;

/// With a zone whose points have all their neighbours; half of it, if mirrored.
CoupledSample sample_of(const bool mirrored)
{
  CoupledSample sample;
  sample.n_cells  = {14, mirrored ? 8 : 14, 14};
  sample.zone     = {{5, mirrored ? 0 : 5, 5}, {9, mirrored ? 3 : 9, 9}};
  sample.mirror_y = mirrored;
  return sample;
}

/// Without the shear that a mirror plane y = 0 forbids.
Matrix mirrored_strain()
{
  Matrix strain = some_strain(1e-6);
  strain(0, 1) = strain(1, 0) = strain(1, 2) = strain(2, 1) = 0.;
  return strain;
}

double sum_over_ranks(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

void expect_homogeneous(PlateModel &plate)
{
  const Matrix strain   = mirrored_strain();
  const Matrix expected = hooke(plate.points->material(), strain);
  const double energy   = 0.5 * expected.cwiseProduct(strain).sum();
  const auto states     = plate_stress(*plate.points, plate.far.get());
  const auto &lattice   = plate.points->lattice();
  ASSERT_EQ(static_cast<std::ptrdiff_t>(states.size()), lattice.size());
  double n[2] = {0., 0.};
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        // 0.2 %: the elastic constants of the lattice (ElasticConstantsTable); elements are exact
        // but for the square of the strain.
        const bool free        = lattice.free(p);
        const double tolerance = free ? 2e-3 : 2e-5;
        EXPECT_LT((states[p].stress - expected).norm(), tolerance * expected.norm()) << free;
        EXPECT_NEAR(states[p].dilatation, strain.trace(), 1e-5 * strain.norm()) << free;
        EXPECT_NEAR(states[p].energy_density, energy, tolerance * energy) << free;
        n[free] += 1.;
      });
  EXPECT_EQ(sum_over_ranks(n[1]), 8. * plate.zone->n_free_cells());
  EXPECT_EQ(sum_over_ranks(n[0]), 8. * plate.zone->n_slaved_cells());
}

TEST(PlateStress, OfAHomogeneousStrainIsHookesLawOnBothSidesOfTheInterface)
{
  for (const bool mirrored : {false, true})
  {
    PlateModel plate(sample_of(mirrored));
    plate.deform([&](const Vector3 &X) -> Vector3 { return X + mirrored_strain() * X; });
    expect_homogeneous(plate);
  }
}

TEST(PlateStress, OfARelaxingPlateIsWhatIsLeftOnBothSides)
{
  auto sample       = sample_of(true);
  sample.relaxation = {{0.4, 0.5e-6}};
  PlateModel plate(sample);
  plate.far->start_relaxation(0.25e-6);
  // Pulled within a step, then held: e_b of a linear rise, and its decay (Mitchell 2011).
  double back = 0.;
  for (int step = 0; step < 6; ++step)
  {
    const double r = std::exp(-0.5), beta = 1. - (1. - r) / 0.5;
    back = r * back + (step == 0 ? beta : 1. - r);
    plate.deform([&](const Vector3 &X) -> Vector3 { return X + mirrored_strain() * X; });
    if (step == 5)
    {
      const auto states = plate_stress(*plate.points, plate.far.get());
      auto left         = plate.points->material();
      left.shear_modulus *= 1. - 0.4 * back;
      const Matrix expected = hooke(left, mirrored_strain());
      plate.points->lattice().for_each_owned(
          [&](const std::ptrdiff_t p)
          {
            const double tolerance = plate.points->lattice().free(p) ? 2e-3 : 2e-5;
            EXPECT_LT((states[p].stress - expected).norm(), tolerance * expected.norm());
          });
    }
  }
}

TEST(PlateStress, WithoutElementsIsThatOfThePoints)
{
  PlateModel plate(sample_of(false));
  plate.deform([&](const Vector3 &X) -> Vector3 { return X + mirrored_strain() * X; });
  const auto states = plate_stress(*plate.points, nullptr);
  PointStress of_bonds(*plate.points);
  plate.for_each_free([&](const std::ptrdiff_t p, const Vector3 &)
                      { EXPECT_EQ(states[p].stress, of_bonds.of(p).stress); });
}
} // namespace
} // namespace ricochet::tests
