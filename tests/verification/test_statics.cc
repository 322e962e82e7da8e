// SPDX-License-Identifier: LGPL-2.1-or-later
// V5, V6: static bars across two interfaces. Interfaces that meet a free surface. V10: convergence
// of the lattice.
#include "support/plane_system.h"
#include "support/static_solution.h"
#include "support/verification.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
CoupledSample lumped(CoupledSample sample)
{
  sample.coupling.correct_mass = false;
  return sample;
}

/// Displacement of the planes under a load, the planes `held` at rest.
Eigen::VectorXd solve(const PlaneSystem &bar, const Eigen::VectorXd &load,
                      const std::vector<Eigen::Index> &held)
{
  Eigen::MatrixXd K = bar.stiffness();
  Eigen::VectorXd f = load;
  for (const auto i : held)
  {
    K.row(i).setZero();
    K(i, i) = K.diagonal().mean();
    f[i]    = 0.;
  }
  return K.partialPivLu().solve(f);
}

TEST(V5Bar, PointsElementsPointsStretchAsTheContinuum)
{
  // Points, elements, points; laterally held, so that the modulus is M. A traction of 1 MPa at the
  // last plane; the outermost planes, soft by their missing bonds, are left out.
  auto sample         = lumped(bar(48, 0, 16));
  sample.more_of_zone = {{{32, 0, 0}, {48, section_points / 2, section_points / 2}}};
  PlateModel plate(sample);
  const auto planes    = plane_system(plate);
  const auto n         = planes.size();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
  load[n - 1]          = 1e6; // [Pa]
  const auto u         = solve(planes, load, {0});
  const auto a = Eigen::Index(8), b = n - 9;
  EXPECT_TRUE(planes.is_point[a] && planes.is_point[b]);
  EXPECT_FALSE(planes.is_point[n / 2]);
  const double stretch = (u[b] - u[a]) / (planes.x[b] - planes.x[a]);
  verify_near("V5", "stretch of a bar of points, elements, points over σ/M",
              stretch / (1e6 / PlateModel::modulus), 1., 5e-3);
  // And everywhere in between.
  for (auto i = a; i < b; ++i)
    verify_near("V5", "stretch between any two neighbouring planes of that bar over σ/M",
                (u[i + 1] - u[i]) / (planes.x[i + 1] - planes.x[i]) / (1e6 / PlateModel::modulus),
                1., 5e-3);
}

TEST(V6QuadraticPatch, BarUnderItsWeightSagsAsAParabola)
{
  // Elements, points, elements between walls under a constant force per volume.
  PlateModel plate(lumped(bar(48, 16, 32)));
  const auto planes          = plane_system(plate);
  const auto n               = planes.size();
  const double b             = 1e9; // [N/m^3]
  const Eigen::VectorXd load = b / PlateModel::density * planes.mass;
  const auto u               = solve(planes, load, {0, n - 1});
  const double L             = planes.x[n - 1];
  const double largest       = b * L * L / (8. * PlateModel::modulus);
  for (Eigen::Index i = 0; i < n; ++i)
    verify_at_most(
        "V6", "deflection of a bar under its weight, error over the largest",
        std::abs(u[i] - b * planes.x[i] * (L - planes.x[i]) / (2. * PlateModel::modulus)) / largest,
        1e-3);
}

TEST(PlaneInterface, FrequenciesAreReal)
{
  for (const bool correct_mass : {false, true})
  {
    auto sample                  = bar(48, 16, 32);
    sample.coupling.correct_mass = correct_mass;
    PlateModel plate(sample);
    const auto planes = plane_system(plate);
    if (!correct_mass)
    {
      const Eigen::MatrixXd K = planes.stiffness();
      // The rows are those of the section's middle, the tensors differ a little across it.
      EXPECT_LE((K - K.transpose()).cwiseAbs().maxCoeff(), 1e-3 * K.cwiseAbs().maxCoeff());
    }
    // Frequencies are real: no growth.
    const auto squares = planes.acceleration.eigenvalues();
    EXPECT_LE(squares.imag().cwiseAbs().maxCoeff(), 1e-6 * squares.cwiseAbs().maxCoeff());
    EXPECT_LE(squares.real().maxCoeff(), 1e-6 * squares.cwiseAbs().maxCoeff());
  }
}

/// Errors of the strain in a plate with a column of points in its middle, stretched along x, free
/// along z; in units of the strain.
struct ColumnErrors
{
  double along_load    = 0.; // at mid-thickness, component 11
  double any_component = 0.; // at mid-thickness
  double anywhere      = 0.;
};
ColumnErrors column_errors(const int n_cells_thick)
{
  CoupledSample sample = lumped({});
  sample.n_cells       = {16, 14, n_cells_thick};
  sample.zone          = {{6, 5, 0}, {10, 9, n_cells_thick}};
  PlateModel plate(sample);
  const double strain = 1e-6, h = plate.edge(), nu = sample.poisson_ratio;
  // Plane stress across the thickness, held along y.
  const Vector3 stretch = strain * Vector3(1., 0., -nu / (1. - nu));
  StaticSolution solution(plate,
                          [&](const Vector3 &X, const int d)
                          {
                            const bool rim = X.x() < 0.1 * h || X.x() > 15.9 * h ||
                                             X.y() < 0.1 * h || X.y() > 13.9 * h;
                            return rim && d < 2;
                          });
  for (std::size_t i = 0; i < solution.size(); ++i)
    for (int d = 0; d < 3; ++d)
      solution.displacement(i, d) = stretch[d] * solution.reference(i)[d];
  solution.solve(1e-4);
  ColumnErrors errors;
  solution.for_each_strain(
      [&](const Zone::Cell &cell, const Eigen::Matrix3d &e)
      {
        const Eigen::Matrix3d error = (e - Eigen::Matrix3d(stretch.asDiagonal())) / strain;
        const double largest        = error.cwiseAbs().maxCoeff();
        errors.anywhere             = std::max(errors.anywhere, largest);
        if (std::abs(2 * cell[2] + 1 - n_cells_thick) > 1)
          return;
        errors.along_load    = std::max(errors.along_load, std::abs(error(0, 0)));
        errors.any_component = std::max(errors.any_component, largest);
      });
  return errors;
}

TEST(FreeSurface, StrainAlongTheLoadAtMidThickness)
{
  EXPECT_LE(column_errors(12).along_load, 5e-3); // 8 horizons thick
  EXPECT_LE(column_errors(24).along_load, 3e-3); // 16
}

TEST(FreeSurface, ContractionAcrossTheThicknessIsOffByMoreInThinPlates)
{
  // What the skin does wrong reaches deeper in the component that nothing holds.
  EXPECT_NEAR(column_errors(12).any_component, 0.0136, 0.001);
  EXPECT_LE(column_errors(24).any_component, 5e-3);
}

TEST(FreeSurface, SkinIsOffByAThirdWhereTheInterfaceMeetsIt)
{
  // Not mended by calibration: points there lack bonds, elements do not. Nothing may break there.
  const auto errors = column_errors(12);
  EXPECT_GT(errors.anywhere, 0.2);
  EXPECT_LT(errors.anywhere, 0.4);
}

TEST(V10Convergence, SineLoadIsOfSecondOrderInTheHorizon)
{
  // Static response to a sine load of wavelength lambda: b/(M k^2) in the continuum, b/(rho
  // omega^2) on the lattice, and its error falls as (delta/lambda)^2.1 down to the lattice's own
  // 0.1 per cent.
  PlateModel plate(lumped(bar(48, 0, 24)));
  const auto planes         = plane_system(plate);
  const Eigen::Index middle = 24;
  ASSERT_TRUE(planes.is_point[middle + 6]);
  const auto error = [&](const double ratio)
  {
    const double k = 2. * M_PI / (ratio * 3. * plate.spacing);
    double squared = 0.; // omega^2, by 1 - cos: no cancellation
    for (int r = -6; r <= 6; ++r)
      squared += planes.acceleration(middle, middle + r) * (1. - std::cos(k * r * plate.spacing));
    return std::pow(PlateModel::p_wave_speed * k, 2) / squared - 1.;
  };
  // Table of the method's study: 13.1, 3.1, 0.70, 0.10 per cent.
  EXPECT_NEAR(error(4.), 0.131, 0.001);
  EXPECT_NEAR(error(8.), 0.031, 0.001);
  EXPECT_NEAR(error(16.), 0.0070, 0.0003);
  EXPECT_NEAR(error(32.), 0.0010, 0.0003);
  verify_near("V10", "order of the error of a sine load, 4 to 8 horizons a wave",
              std::log2(error(4.) / error(8.)), 2.1, 0.2);
  verify_near("V10", "order of the error of a sine load, 8 to 16 horizons a wave",
              std::log2(error(8.) / error(16.)), 2.1, 0.2);
  verify_at_most("V10", "error that remains, 64 horizons a wave", std::abs(error(64.)), 0.001);
}
} // namespace
} // namespace ricochet::tests
