// SPDX-License-Identifier: LGPL-2.1-or-later
// Blocks that flow (bond_flow.h), strained step by step.
#include "ricochet/base/exceptions.h"
#include "ricochet/peridynamics/point_stress.h"
#include "support/failing_body.h"

#include <gtest/gtest.h>

#include <string>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3, dt = 1e-9; // [m], [s]
// Yields at strains of 1e-4: what is of second order in strains, such as the stress that a pressure
// of 50 tau gets from them, is below a per cent.
constexpr FlowLaw law{0.2e6, 0.07, 0.2};

BodySample block(const int n)
{
  BodySample sample;
  sample.n = {n, n, n};
  return sample;
}

struct Step
{
  Eigen::Matrix3d stress;
  double tau, pressure, theta; // [Pa], [Pa], [-]
};

/// A body whose points are moved, not free.
class StrainedBody
{
public:
  explicit StrainedBody(std::unique_ptr<PeridynamicBody> body) : body_(std::move(body))
  {
    body_->start_relaxation(dt);
  }

  /// One step that takes every point to map(reference position).
  template <class Map>
  void move(Map &&map)
  {
    auto &a = body_->state().arrays;
    for_each_point(*body_,
                   [&](const std::ptrdiff_t p)
                   {
                     const Vector3 x = position(*body_, p), y = map(reference(*body_, p));
                     set(a.velocity, p, (y - x) / dt);
                     set(a.position, p, y);
                     work_ -= 0.5 * force(*body_, p).dot(y - x);
                   });
    body_->update_ghosts();
    body_->break_bonds();
    body_->compute_internal_forces({true});
    for_each_point(*body_, [&](const std::ptrdiff_t p)
                   { work_ -= 0.5 * dt * force(*body_, p).dot(at(a.velocity, p)); });
    body_->end_step();
  }
  void strain(const Eigen::Matrix3d &strain)
  {
    move([&](const Vector3 &X) -> Vector3 { return X + strain * X; });
  }

  /// In the middle.
  Step look() const
  {
    const auto &n    = body_->lattice().box().n;
    const auto state = PointStress(*body_).of(body_->lattice().index(n[0] / 2, n[1] / 2, n[2] / 2));
    return {state.stress, von_mises(state.stress) / std::sqrt(3.), pressure(state.stress),
            state.dilatation};
  }

  PeridynamicBody &body() { return *body_; }
  double work() const { return work_; } // done on the points so far [J]

private:
  std::unique_ptr<PeridynamicBody> body_;
  double work_ = 0.;
};

Eigen::Matrix3d along_x(const double strain)
{
  return strain * Eigen::Vector3d::UnitX() * Eigen::Vector3d::UnitX().transpose();
}

Eigen::Matrix3d shear(const double gamma)
{
  return gamma * Eigen::Vector3d::UnitX() * Eigen::Vector3d::UnitZ().transpose();
}

/// The stress that the law allows at a rate of shear [1/s] and a pressure [Pa].
double allowed(const double rate, const double pressure)
{
  return law.stress * std::pow(rate, law.rate_exponent) +
         law.pressure_slope * std::max(0., pressure);
}

// Shares are those of one step ago: tau is above the law by what it rises in a step, and the mean
// extension of a step flows with the share that a step takes of tau. Both are some thousandths
// here.
TEST(BondFlow, UniaxialCompressionFollowsTheLaw)
{
  StrainedBody compressed(make_failing_body(block(11), law));
  const auto &m         = compressed.body().material();
  const double mu       = m.shear_modulus;
  const double per_step = 1e-6, shear_per_step = 2. / std::sqrt(3.) * per_step;
  Step before{};
  int n_flowing = 0;
  for (int n = 1; n <= 600; ++n)
  {
    compressed.strain(along_x(-per_step * n));
    if (n % 10 > 1)
      continue;
    const Step now = compressed.look();
    EXPECT_NEAR(now.pressure, -m.bulk_modulus * now.theta, 0.01 * now.pressure) << n;
    const double rate = (shear_per_step - (now.tau - before.tau) / mu) / dt;
    if (n <= 80)
    {
      EXPECT_NEAR(now.tau, mu * shear_per_step * n, 0.01 * now.tau) << n; // not yet
    }
    else if (n > 230 && n % 10 == 1) // yields at 140, and at a rate of 700/s at 230
    {
      EXPECT_NEAR(now.tau / allowed(rate, now.pressure), 1., 0.01) << n;
      ++n_flowing;
    }
    before = now;
  }
  EXPECT_EQ(n_flowing, 37);
  EXPECT_LT(before.tau, 0.7 * mu * shear_per_step * 600);
}

TEST(BondFlow, ShearUnderPressureFollowsTheLaw)
{
  StrainedBody sheared(make_failing_body(block(11), law));
  const double squeeze = 1e-4, per_step = 1e-6;
  const Eigen::Matrix3d squeezed = -squeeze * Eigen::Matrix3d::Identity();
  for (int n = 1; n <= 10; ++n)
    sheared.strain(0.1 * n * squeezed);
  EXPECT_EQ(sheared.body().energies(dt).plastic, 0.) << "pressure alone";
  for (int n = 1; n <= 1000; ++n)
    sheared.strain(squeezed + shear(per_step * n));
  const Step now = sheared.look();
  const double p = 3. * sheared.body().material().bulk_modulus * squeeze;
  EXPECT_NEAR(now.pressure / p, 1., 0.01);
  // At a constant rate all of the shear flows.
  EXPECT_NEAR(now.tau / allowed(per_step / dt, p), 1., 0.01);
  EXPECT_NEAR(now.stress(0, 2) / now.tau, 1., 0.01) << "shear it is";
}

TEST(BondFlow, HeatIsTheWorkThatIsNotStored)
{
  StrainedBody block_of(make_failing_body(block(9), law));
  for (int n = 1; n <= 60; ++n)
    block_of.strain(along_x(-1e-5 * n));
  for (int n = 1; n <= 60; ++n)
    block_of.strain(along_x(-6e-4) + shear(1e-5 * n));
  for (int n = 1; n <= 60; ++n) // and some of it back
    block_of.strain(along_x(-6e-4 + 4e-6 * n) + shear(6e-4 - 1e-5 * n));
  const auto energies = block_of.body().energies(dt);
  EXPECT_GT(energies.plastic, 0.2 * block_of.work());
  EXPECT_NEAR(energies.strain + energies.plastic, block_of.work(), 1e-6 * block_of.work());
}

TEST(BondFlow, NothingHappensBelowYield)
{
  StrainedBody flowing(make_failing_body(block(9), law)), elastic(make_failing_body(block(9)));
  // tau = 2/sqrt(3) mu eps, and no pressure in the law's favour.
  for (int n = 1; n <= 10; ++n)
    for (auto *const body : {&flowing, &elastic})
      body->strain(along_x(7e-6 * n));
  EXPECT_GT(elastic.look().tau, 0.8 * law.stress);
  EXPECT_EQ(flowing.body().energies(dt).plastic, 0.);
  for_each_point(flowing.body(),
                 [&](const std::ptrdiff_t p)
                 {
                   EXPECT_EQ(force(flowing.body(), p), force(elastic.body(), p));
                   for (std::size_t k = 0; k < flowing.body().bond_constants().size(); ++k)
                     ASSERT_EQ(flowing.body().flow()->plastic_extension(p, k), 0.);
                 });
}

TEST(BondFlow, LookBetweenStepsLetsNothingFlow)
{
  StrainedBody block_of(make_failing_body(block(7), law));
  for (int n = 1; n <= 40; ++n)
    block_of.strain(along_x(-2e-5 * n));
  auto &body        = block_of.body();
  const double heat = body.energies(dt).plastic;
  EXPECT_GT(heat, 0.);
  const auto f = force(body, body.lattice().index(2, 3, 3));
  for (int look = 0; look < 3; ++look)
    body.compute_internal_forces({true, /*is_step=*/false});
  EXPECT_EQ(body.energies(dt).plastic, heat);
  EXPECT_EQ(force(body, body.lattice().index(2, 3, 3)), f);
}

/// A body, or half of it, that flies apart.
std::unique_ptr<PeridynamicBody> burst(const bool mirrored, const double speed, const int n_steps,
                                       const double step)
{
  BodySample sample;
  sample.n                = {8, mirrored ? 4 : 8, 6};
  sample.mirror_y         = mirrored;
  sample.critical_stretch = 0.006;
  if (!mirrored)
    sample.corner.y() = -4. * dx;
  auto body = make_failing_body(sample, {10e6, 0.07, 0.2});
  body->start_relaxation(step);
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   const Vector3 X   = 1e3 * reference(*body, p);
                   const double side = X.y() > 0. ? 1. : -1.;
                   const Vector3 v(std::sin(3. * X.x() + X.z()) + std::cos(2. * X.y()),
                                   side * std::sin(2. * X.x() + std::abs(X.y())),
                                   std::cos(X.x() * X.z()) - std::abs(X.y()));
                   set(body->state().arrays.velocity, p, speed * v);
                 });
  for (int n = 0; n < n_steps; ++n)
  {
    body->update_ghosts();
    body->break_bonds();
    body->compute_internal_forces({n == n_steps - 1});
    if (n < n_steps - 1)
      body->advance(step, step);
  }
  return body;
}

TEST(BondFlow, HalfABodyFlowsAsTheWholeOne)
{
  const double speed = 20., step = 2e-8;
  const int n_steps = 40;
  const auto half = burst(true, speed, n_steps, step), whole = burst(false, speed, n_steps, step);
  const double cracked = whole->count_sound_bonds() - whole->count_bonds();
  EXPECT_GT(cracked, 100.);
  EXPECT_EQ(2. * (half->count_sound_bonds() - half->count_bonds()), cracked);
  // Plastic extensions are rounded to 6e-8 of themselves, which may be another number where sums
  // were made in another order.
  double largest = 0.;
  for_each_point(*half,
                 [&](const std::ptrdiff_t p)
                 {
                   const auto c = half->lattice().coordinates(p);
                   const auto q = whole->lattice().index(c[0], c[1] + 4, c[2]);
                   largest = std::max(largest, (position(*half, p) - reference(*half, p)).norm());
                   EXPECT_LT((position(*half, p) - position(*whole, q)).norm(),
                             1e-6 * speed * n_steps * step);
                 });
  EXPECT_GT(largest, 0.01 * dx);
  const double heat = whole->energies(step).plastic;
  EXPECT_GT(heat, 0.05 * whole->energies(step).kinetic);
  EXPECT_NEAR(2. * half->energies(step).plastic, heat, 1e-6 * heat);
}

void expect_refusal(const std::string &law_name, const RelaxationSeries &relaxation,
                    const std::vector<std::string> &parts)
{
  BodySample sample = block(4);
  for (const auto &of_menu : bond_law_samples)
    if (of_menu.law == law_name)
      sample.family.law = of_menu;
  const auto body = make_failing_body(sample, law, true, relaxation);
  try
  {
    body->start_relaxation(dt);
    FAIL() << "it was not refused";
  }
  catch (const InputError &error)
  {
    for (const auto &part : parts)
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(BondFlow, IsRefusedWithRelaxationAndWithoutAShearModulus)
{
  expect_refusal("linear peridynamic solid", {{0.5, 1e-6}},
                 {"relaxes cannot flow", "relaxation times", "flow stress"});
  expect_refusal("microelastic brittle", {},
                 {"'microelastic brittle'", "no shear modulus of its own", "leave out"});
}
} // namespace
} // namespace ricochet::tests
