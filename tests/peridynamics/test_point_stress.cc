// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/point_stress.h"

#include "support/body.h"
#include "support/some_strain.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
using Matrix = Eigen::Matrix3d;

BodySample block(const BondLawSample &law)
{
  BodySample sample;
  sample.family = {law, InfluenceFunction::cone, 3.};
  sample.n      = {9, 9, 9}; // the point in the middle and its family are whole
  return sample;
}

std::ptrdiff_t middle(const PeridynamicBody &body)
{
  return body.lattice().index(4, 4, 4);
}

/// A shaken block that has lost bonds, the same for every call.
std::unique_ptr<PeridynamicBody> torn_body(const BondLawSample &law)
{
  BodySample sample       = block(law);
  sample.n                = {7, 6, 5};
  sample.critical_stretch = 0.03;
  auto body               = make_body(sample);
  Random random(11);
  deform(
      *body, [&](const Vector3 &X) -> Vector3 { return X + 0.03e-3 * random.vector(); },
      /*breaking=*/true);
  return body;
}

TEST(PointStress, IsHookesLawInAHomogeneousDeformation)
{
  constexpr double size = 1e-6;
  for (const auto &law : bond_law_samples)
  {
    // The elastic constants of a lattice with this influence function: of the linear peridynamic
    // solid they are off by 0.2 % (ElasticConstantsTable), of the microelastic one, whose bonds
    // weigh omega |xi|, C11 by 1.9 % and C12 = C44 by -2.9 %.
    const double lattice = bond_law(law.law).has_dilatation ? 2e-3 : 2.9e-2;
    const auto body      = make_body(block(law));
    const auto &material = body->material();
    const Matrix strain = some_strain(size), R = some_rotation();
    const Matrix expected = hooke(material, strain);
    for (const bool turned : {false, true})
    {
      const Matrix turn = turned ? R : Matrix(Matrix::Identity());
      deform(*body, [&](const Vector3 &X) -> Vector3 { return turn * (X + strain * X); });
      const auto state  = PointStress(*body).of(middle(*body));
      const Matrix back = turn.transpose() * state.stress * turn;
      // The trace is exact; Hooke's law is that of small strains.
      EXPECT_LT((back - expected).norm(), lattice * expected.norm()) << law.law;
      EXPECT_NEAR(pressure(state.stress), -material.bulk_modulus * strain.trace(),
                  3. * size * expected.norm())
          << law.law;
      EXPECT_NEAR(state.dilatation, strain.trace(), 3. * size * size) << law.law;
      const double energy = 0.5 * expected.cwiseProduct(strain).sum();
      EXPECT_NEAR(state.energy_density, energy, lattice * energy) << law.law;
      EXPECT_NEAR(von_mises(state.stress), von_mises(expected), lattice * expected.norm())
          << law.law;
    }
  }
}

TEST(PointStress, IsZeroInRigidMotion)
{
  for (const auto &law : bond_law_samples)
  {
    const auto body = make_body(block(law));
    const Matrix R  = some_rotation();
    deform(*body, [&](const Vector3 &X) -> Vector3 { return R * X + Vector3(5e-3, -2e-3, 1e-3); });
    PointStress stress(*body);
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     // Positions of 1e-2 m round to 1e-18, strains of spacings to 1e-15.
                     const auto state = stress.of(p);
                     EXPECT_LT(state.stress.norm(), 1e-13 * law.bulk_modulus);
                     EXPECT_LT(std::abs(state.dilatation), 1e-13);
                     EXPECT_LT(state.energy_density, 1e-26 * law.bulk_modulus);
                   });
  }
}

TEST(PointStress, OfAllPointsIsTheVirialOfTheirForces)
{
  for (const auto &law : bond_law_samples)
  {
    const auto body = torn_body(law);
    PointStress stress(*body);
    Matrix sum = Matrix::Zero(), virial = Matrix::Zero();
    double energy = 0., magnitude = 0.;
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     const auto state = stress.of(p);
                     sum += body->point_volume() * state.stress;
                     energy += body->point_volume() * state.energy_density;
                     virial -= force(*body, p) * position(*body, p).transpose();
                     magnitude += force(*body, p).norm() * position(*body, p).norm();
                   });
    EXPECT_LT(body->count_bonds(), body->count_sound_bonds());
    EXPECT_GT(sum.norm(), 1e-3 * magnitude);
    EXPECT_LT((sum - virial).norm(), 1e-12 * magnitude) << law.law;
    EXPECT_NEAR(energy, strain_energy(*body), 1e-12 * energy) << law.law;
  }
}

TEST(PointStress, IsTheDerivativeOfTheEnergyDensity)
{
  // Also of torn families: all positions as they are, and then strained a little more.
  for (const auto &law : bond_law_samples)
  {
    const auto body     = torn_body(law);
    auto &a             = body->state().arrays;
    const auto strained = [&](const Matrix &direction, const double size)
    {
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       const Vector3 x = position(*body, p);
                       set(a.position, p, x + size * direction * x);
                     });
    };
    const Matrix direction = some_strain(1.);
    constexpr double size  = 1e-6;
    std::map<std::ptrdiff_t, StressState> now, before, after;
    PointStress stress(*body);
    const auto note = [&](auto &states)
    { for_each_point(*body, [&](const std::ptrdiff_t p) { states[p] = stress.of(p); }); };
    note(now);
    strained(direction, size);
    note(after);
    strained(direction, -2. * size);
    note(before);
    for (const auto &[p, state] : now)
    {
      const double slope = (after[p].energy_density - before[p].energy_density) / (2. * size);
      // Strains of 0.03 are large beside 1e-6, whose square is left.
      EXPECT_NEAR(state.stress.cwiseProduct(direction).sum(), slope,
                  1e-5 * (state.stress.norm() + std::abs(slope)))
          << law.law;
    }
  }
}

TEST(PointStress, TraceSaysWhatDamageLeaves)
{
  // tr(tau) = [3 K r + 5 mu (1 - r)] theta of a linear peridynamic solid, r the share of the
  // weighted volume that is left, for small strains.
  constexpr double size = 1e-7;
  BodySample sample     = block(bond_law_samples[0]);
  const auto body       = make_body(sample);
  const Matrix strain   = some_strain(size);
  deform(*body, [&](const Vector3 &X) -> Vector3 { return X + strain * X; });
  PointStress stress(*body);
  const auto &offsets = body->lattice().stencil().offsets;
  double whole        = 0.;
  for (const auto &o : offsets)
    whole += 2. * o.omega * o.length * o.length;
  int n_incomplete = 0;
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   double left = 0.;
                   for (std::size_t k = 0; k < offsets.size(); ++k)
                   {
                     const std::ptrdiff_t q = p - body->lattice().shift(offsets[k]);
                     left += (is_intact(*body, p, k) + (q >= 0 && is_intact(*body, q, k))) *
                             offsets[k].omega * offsets[k].length * offsets[k].length;
                   }
                   const double r   = left / whole;
                   const auto state = stress.of(p);
                   n_incomplete += r < 0.9;
                   EXPECT_NEAR(state.stress.trace(),
                               (3. * body->material().bulk_modulus * r +
                                5. * body->material().shear_modulus * (1. - r)) *
                                   state.dilatation,
                               10. * size * state.stress.norm());
                 });
  EXPECT_GT(n_incomplete, 100); // points at the surface
}

TEST(PointStress, OfAHalfIsThatOfTheWhole)
{
  BodySample whole = block(bond_law_samples[0]), half = whole;
  whole.n         = {8, 10, 7};
  whole.corner    = {0., -5e-3, 0.};
  half.n          = {8, 5, 7};
  half.mirror_y   = true;
  const auto bend = [](const Vector3 &X) -> Vector3
  { return X + Vector3(3. * X.z() * X.x(), 2. * X.y() * X.x(), 5. * X.y() * X.y()); };
  const auto a = make_body(whole), b = make_body(half);
  deform(*a, bend);
  deform(*b, bend);
  PointStress of_whole(*a), of_half(*b);
  for_each_point(*b,
                 [&](const std::ptrdiff_t p)
                 {
                   auto c = b->lattice().coordinates(p);
                   c[1] += 5;
                   const auto one   = of_half.of(p),
                              other = of_whole.of(a->lattice().index(c[0], c[1], c[2]));
                   EXPECT_LT((one.stress - other.stress).norm(), 1e-10 * other.stress.norm());
                   EXPECT_NEAR(one.dilatation, other.dilatation, 1e-13);
                 });
}

TEST(PointStress, OfARelaxingBodyIsWhatItsBranchesHold)
{
  // Against the kernel's forces and energy after steps of any kind, some of which break bonds.
  constexpr double dt = 0.3e-6;
  BodySample sample   = block(bond_law_samples[0]);
  sample.n            = {7, 6, 5};
  const auto &law     = sample.family.law;
  PeridynamicBody body(MPI_COMM_SELF, 0, {sample.corner, sample.spacing, sample.n, false},
                       make_stencil(sample.spacing, 3., InfluenceFunction::cone),
                       {&bond_law(law.law),
                        law.density,
                        law.bulk_modulus,
                        law.shear_modulus,
                        0.03,
                        {{0.2, 9e-6}, {0.3, 0.9e-6}, {0.1, 0.4e-6}},
                        HistoryPrecision::double_precision});
  body.start_relaxation(dt);
  auto &a = body.state().arrays;
  Random random(5);
  for (int step = 0; step < 6; ++step)
  {
    body.end_step();
    for_each_point(body,
                   [&](const std::ptrdiff_t p)
                   {
                     const Vector3 x = reference(body, p) + 0.03e-3 * random.vector();
                     set(a.velocity, p, (x - position(body, p)) / dt);
                     set(a.position, p, x);
                   });
    body.update_ghosts();
    body.break_bonds();
    body.compute_internal_forces({/*energy=*/true});
    PointStress stress(body);
    Matrix sum = Matrix::Zero(), virial = Matrix::Zero();
    double energy = 0., magnitude = 0.;
    for_each_point(body,
                   [&](const std::ptrdiff_t p)
                   {
                     const auto state = stress.of(p);
                     sum += body.point_volume() * state.stress;
                     energy += body.point_volume() * state.energy_density;
                     virial -= force(body, p) * position(body, p).transpose();
                     magnitude += force(body, p).norm() * position(body, p).norm();
                   });
    EXPECT_LT((sum - virial).norm(), 1e-12 * magnitude) << step;
    EXPECT_NEAR(energy, strain_energy(body), 1e-12 * energy) << step;
  }
  EXPECT_LT(body.count_bonds(), body.count_sound_bonds());
}
} // namespace
} // namespace ricochet::tests
