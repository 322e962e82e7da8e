// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/element_stress.h"

#include "ricochet/materials/relaxation.h"
#include "support/element_body.h"
#include "support/some_strain.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
using Matrix = Eigen::Matrix3d;

int n_elements(const FiniteElementBody &body)
{
  return static_cast<int>(body.mesh().elements().size());
}

TEST(ElementStress, IsHookesLawInAHomogeneousDeformationOfAnyElement)
{
  constexpr double size = 1e-6;
  FiniteElementBody body(MPI_COMM_SELF, refined_box(), pmma());
  // Tensors of their own are the share of the element, not the material.
  Random random(3);
  ElementStiffness own{1, {}};
  own.tensors.fill(upper_triangle(random_tensor(random, 1e8)));
  body.set_stiffness({own});
  const Matrix strain = some_strain(size), R = some_rotation(),
               expected = hooke(body.material(), strain);
  for (const bool turned : {false, true})
  {
    const Matrix turn = turned ? R : Matrix(Matrix::Identity());
    deform(body, [&](const Vector3 &X) -> Vector3 { return turn * (X + strain * X); });
    for (int e = 0; e < n_elements(body); ++e)
    {
      const auto state       = element_stress(body, e);
      // Small strains are meant by Hooke's law; positions of 1e-3 m round to 1e-19, extensions of
      // the smallest cubes, 1e-6 of a quarter of that, to 1e-9 of themselves.
      const double tolerance = 5. * size + 1e-8;
      EXPECT_LT((turn.transpose() * state.stress * turn - expected).norm(),
                tolerance * expected.norm());
      EXPECT_NEAR(state.dilatation, strain.trace(), tolerance * strain.norm());
      const double energy = 0.5 * expected.cwiseProduct(strain).sum();
      EXPECT_NEAR(state.energy_density, energy, tolerance * energy);
    }
  }
}

TEST(ElementStress, IsZeroInRigidMotion)
{
  FiniteElementBody body(MPI_COMM_SELF, refined_box(), pmma());
  const Matrix R = some_rotation();
  deform(body, [&](const Vector3 &X) -> Vector3 { return R * X + Vector3(5e-3, -2e-3, 1e-3); });
  for (int e = 0; e < n_elements(body); ++e)
  {
    const auto state = element_stress(body, e);
    EXPECT_LT(state.stress.norm(), 1e-13 * pmma_youngs_modulus);
    EXPECT_LT(std::abs(state.dilatation), 1e-13);
    EXPECT_LT(state.energy_density, 1e-26 * pmma_youngs_modulus);
  }
}

TEST(ElementStress, IsThatOfTheForcesAndItsEnergyThatOfTheBalance)
{
  // Large and irregular strains, elastic and with a history of some steps; one-point elements.
  for (const bool relaxing : {false, true})
  {
    auto material = pmma();
    if (relaxing)
      material.relaxation = {{0.3, 2e-6}, {0.4, 0.5e-6}};
    FiniteElementBody body(MPI_COMM_SELF, refined_box(), material);
    body.start_relaxation(0.3e-6);
    for (const double size : {0., 5e-5, -3e-5, 8e-5})
    {
      deform(body, [&](const Vector3 &X) -> Vector3 { return X + size * noise_at(X, 1e-3); });
      for (int e = 0; e < n_elements(body); ++e)
      {
        const auto state   = element_stress(body, e);
        const Matrix F     = body.deformation_gradient(e);
        const Matrix known = F * body.stress(e) * F.transpose();
        EXPECT_LT((state.stress - known).norm(), 1e-12 * known.norm() + 1e-6) << size;
        EXPECT_NEAR(state.dilatation, F.determinant() - 1., 1e-14);
        const double volume = std::pow(body.mesh().elements()[e].edge, 3);
        EXPECT_NEAR(volume * state.energy_density, body.strain_energy(e),
                    1e-12 * body.strain_energy(e) + 1e-20)
            << size;
      }
    }
  }
}

TEST(ElementStress, RelaxesToWhatTheSeriesLeaves)
{
  // Held for ten times the slowest branch, a small strain has the shear modulus of the equilibrium.
  auto material       = pmma();
  material.relaxation = {{0.3, 2e-6}, {0.4, 0.5e-6}};
  FiniteElementBody body(MPI_COMM_SELF, refined_box(), material);
  constexpr double dt = 0.1e-6;
  body.start_relaxation(dt);
  const Matrix strain = some_strain(1e-6);
  for (int step = 0; step < 201; ++step)
    deform(body, [&](const Vector3 &X) -> Vector3 { return X + strain * X; });
  auto left = material;
  left.shear_modulus *= 1. - 0.3 - 0.4;
  const Matrix expected = hooke(left, strain);
  // exp(-10) of a branch of 0.3 is left, besides the square of the strain.
  for (int e = 0; e < n_elements(body); ++e)
    EXPECT_LT((element_stress(body, e).stress - expected).norm(), 5e-5 * expected.norm());
}
} // namespace
} // namespace ricochet::tests
