// SPDX-License-Identifier: LGPL-2.1-or-later
// V11: first bending frequency of a clamped bar 100 x 10 x 10 mm, of points and of points and
// elements, by Rayleigh's quotient of Bernoulli's mode: an upper bound, near the truth because an
// error of the mode enters by its square. Elements alone, and in time, are in
// tests/finite_elements.
#include "support/coupled_plate.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double length = 0.1, thickness = 0.01; // [m]

/// Frequency in parts of Bernoulli's. The bar lies along y, clamped by symmetry at y = 0; points in
/// the first `zone_length` cells.
double frequency(const int n_cells_thick, const int zone_length)
{
  CoupledSample sample;
  sample.communicator = MPI_COMM_SELF;
  sample.spacing      = thickness / (2 * n_cells_thick);
  sample.n_cells      = {n_cells_thick, 10 * n_cells_thick, n_cells_thick};
  sample.zone         = {{0, 0, 0}, {n_cells_thick, zone_length, n_cells_thick}};
  sample.mirror_y     = true;
  PlateModel bar(sample);
  const double nu = sample.poisson_ratio, b = 1.8751 / length, sigma = 0.7341;
  const double small = 1e-6; // of the mode, whose end is at 2 [m]
  const auto w       = [&](const double y, const int derivative)
  {
    const double s = b * y, p = std::pow(b, derivative) * small;
    switch (derivative)
    {
      case 0:
        return p * (std::cosh(s) - std::cos(s) - sigma * (std::sinh(s) - std::sin(s)));
      case 1:
        return p * (std::sinh(s) + std::sin(s) - sigma * (std::cosh(s) - std::cos(s)));
      default:
        return p * (std::cosh(s) + std::cos(s) - sigma * (std::sinh(s) + std::sin(s)));
    }
  };
  // Fibres stretch by -z w'' and contract by nu times that across.
  const auto displacement = [&](const Vector3 &X) -> Vector3
  {
    const double x = X.x() - 0.5 * thickness, z = X.z() - 0.5 * thickness;
    return {nu * x * z * w(X.y(), 2), -z * w(X.y(), 1),
            w(X.y(), 0) + 0.5 * nu * (z * z - x * x) * w(X.y(), 2)};
  };
  bar.deform([&](const Vector3 &X) -> Vector3 { return X + displacement(X); });
  const auto energies = bar.far->energies(0.);
  double inertia      = 0.; // sum of m u^2
  bar.for_each_free([&](const std::ptrdiff_t, const Vector3 &X)
                    { inertia += bar.points->point_mass() * displacement(X).squaredNorm(); });
  const auto &elements = bar.far->elements();
  for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    inertia +=
        elements.mass(node) * displacement(elements.mesh().reference_position(node)).squaredNorm();
  const double squared = 2. * (energies.strain + energies.hourglass) / inertia;
  const double E       = PlateModel::modulus * (1. + nu) * (1. - 2. * nu) / (1. - nu);
  return std::sqrt(squared) /
         (b * b * std::sqrt(E / PlateModel::density) * thickness / std::sqrt(12.));
}

TEST(V11Cantilever, UpperBoundOfPointsAndElements)
{
  // 13 horizons thick; points in the first tenth, where it bends most.
  const double coupled = frequency(20, 20);
  std::printf("coupled: %.4f of Bernoulli's frequency, %.1f Hz of PMMA's 269\n", coupled,
              269. * coupled);
  verify_near("V11", "points and elements: frequency (upper bound) over Bernoulli's", coupled, 1.,
              0.03);
}

// Rayleigh's quotient of Bernoulli's mode is an upper bound: the frequency itself may lie below.
TEST(V11Cantilever, UpperBoundOfPoints)
{
  const double points = frequency(20, 199), elements = frequency(20, 1);
  std::printf("points: %.4f, elements: %.4f of Bernoulli's frequency\n", points, elements);
  verify_near("V11", "points: frequency (upper bound) over Bernoulli's", points, 1., 0.03);
  verify_near("V11", "elements: frequency (upper bound) over Bernoulli's", elements, 1., 0.01);
}
} // namespace
} // namespace ricochet::tests
