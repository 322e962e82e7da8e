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

std::vector<std::ptrdiff_t> owned_points(const PlateModel &plate)
{
  std::vector<std::ptrdiff_t> indices;
  plate.points->lattice().for_each_owned([&](const std::ptrdiff_t p) { indices.push_back(p); });
  return indices;
}

/// Of the lattice, and so of its elements: Hooke's law but for the anisotropy of shear.
Matrix lattice_stress(const PlateModel &plate, const double shear_modulus, const Matrix &strain)
{
  auto m                = plate.points->material();
  const auto anisotropy = lattice_anisotropy(plate.points->lattice().stencil(), *m.law,
                                             m.bulk_modulus, m.shear_modulus);
  m.shear_modulus       = shear_modulus;
  Matrix stress         = hooke(m, strain);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      stress(i, j) += 2. * shear_modulus *
                      (i == j ? (anisotropy.tetragonal - 1.) * (strain(i, i) - strain.trace() / 3.)
                              : (anisotropy.diagonal - 1.) * strain(i, j));
  return stress;
}

void expect_homogeneous(PlateModel &plate)
{
  const Matrix strain   = mirrored_strain();
  const Matrix expected = lattice_stress(plate, plate.points->material().shear_modulus, strain);
  const double energy   = 0.5 * expected.cwiseProduct(strain).sum();
  const auto points     = owned_points(plate);
  const auto states     = plate_stress(*plate.points, plate.far.get(), points);
  ASSERT_EQ(states.size(), points.size());
  double n[2] = {0., 0.};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // Exact but for the square of the strain.
    const bool free            = plate.points->lattice().free(points[i]);
    constexpr double tolerance = 2e-5;
    EXPECT_LT((states[i].stress - expected).norm(), tolerance * expected.norm()) << free;
    EXPECT_NEAR(states[i].dilatation, strain.trace(), 1e-5 * strain.norm()) << free;
    EXPECT_NEAR(states[i].energy_density, energy, tolerance * energy) << free;
    n[free] += 1.;
  }
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
      const auto points     = owned_points(plate);
      const auto states     = plate_stress(*plate.points, plate.far.get(), points);
      const double left     = (1. - 0.4 * back) * plate.points->material().shear_modulus;
      const Matrix expected = lattice_stress(plate, left, mirrored_strain());
      for (const auto &state : states)
        EXPECT_LT((state.stress - expected).norm(), 2e-5 * expected.norm());
    }
  }
}

TEST(PlateStress, WithoutElementsIsThatOfThePoints)
{
  PlateModel plate(sample_of(false));
  plate.deform([&](const Vector3 &X) -> Vector3 { return X + mirrored_strain() * X; });
  std::vector<std::ptrdiff_t> points;
  plate.for_each_free([&](const std::ptrdiff_t p, const Vector3 &) { points.push_back(p); });
  const auto states = plate_stress(*plate.points, nullptr, points);
  PointStress of_bonds(*plate.points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(states[i].stress, of_bonds.of(points[i]).stress);
}

TEST(PlateStress, OfSomePointsIsThatOfAll)
{
  PlateModel plate(sample_of(true));
  plate.deform([&](const Vector3 &X) -> Vector3 { return X + X.y() * mirrored_strain() * X; });
  const auto all = owned_points(plate);
  std::vector<std::ptrdiff_t> some; // on three ranks and fewer of both kinds
  for (std::size_t i = 0; i < all.size(); i += 7)
    some.push_back(all[i]);
  const auto of_all  = plate_stress(*plate.points, plate.far.get(), all),
             of_some = plate_stress(*plate.points, plate.far.get(), some);
  ASSERT_EQ(of_some.size(), some.size());
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    EXPECT_EQ(of_some[i].stress, of_all[7 * i].stress);
    EXPECT_EQ(of_some[i].dilatation, of_all[7 * i].dilatation);
    EXPECT_EQ(of_some[i].energy_density, of_all[7 * i].energy_density);
  }
}
} // namespace
} // namespace ricochet::tests
