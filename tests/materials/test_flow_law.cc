// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/materials/flow_law.h"

#include "ricochet/peridynamics/stencil.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ricochet::tests
{
namespace
{
constexpr double mu = 2.258e9; // [Pa]
constexpr FlowLaw pmma{66.78e6, 0.06933, 0.223};

TEST(FlowLaw, NoStressMeansNoFlow)
{
  EXPECT_FALSE(FlowLaw{}.flows());
  EXPECT_TRUE(pmma.flows());
}

TEST(FlowLaw, StressAfterTheStepIsThatOfTheRate)
{
  int n_flowing = 0;
  for (const double A : {1e3, 66.78e6, 1e9})
    for (const double n : {0.005, 0.06933, 0.5, 1., 3., 8.})
      for (const double B : {0., 0.223, 1.})
        for (const double dt : {1e-12, 2e-8, 1e-4})
          for (const double p : {-1e9, 0., 3e7, 2e9})
            for (const double over : {1e5, 1e7, 1e8, 1e9})
            {
              const double tau   = B * std::max(0., p) + over;
              const double share = relaxed_by_flow({A, n, B}, tau, p, mu, dt);
              if (over <= A + mu * dt) // the rate would be below 1/s
              {
                EXPECT_EQ(share, 0.);
                continue;
              }
              ++n_flowing;
              ASSERT_GE(share, 0.);
              ASSERT_LE(share, 1.);
              const double g = share * tau / (mu * dt);
              ASSERT_GT(g, 1. - 1e-9);
              // A power n takes n times the error of the rate, whose logarithm, some tens, is
              // rounded: 1e-16 * 30.
              EXPECT_NEAR(tau - mu * g * dt, A * std::pow(g, n) + B * std::max(0., p),
                          1e-14 * (1. + n) * tau)
                  << A << ' ' << n << ' ' << B << ' ' << dt << ' ' << p << ' ' << over;
            }
  EXPECT_GT(n_flowing, 1000);
}

TEST(FlowLaw, NothingFlowsBelowYieldNorSlowerThanOnePerSecond)
{
  constexpr double dt = 2e-8, p = 100e6, yield = pmma.stress + pmma.pressure_slope * p;
  for (const double part : {0., 0.5, 1. - 1e-12})
    EXPECT_EQ(relaxed_by_flow(pmma, part * yield, p, mu, dt), 0.);
  // 1/s for one step is a stress of mu dt = 45 Pa.
  EXPECT_EQ(relaxed_by_flow(pmma, yield + 0.999 * mu * dt, p, mu, dt), 0.);
  const double tau = yield + 1.001 * mu * dt;
  const double g   = relaxed_by_flow(pmma, tau, p, mu, dt) * tau / (mu * dt);
  // The stress of the law hardly rises with a rate from 0 to some 1/s: all of the excess is
  // A n (g - 1) + mu g dt.
  EXPECT_NEAR(g, 1., 1e-4);
  EXPECT_GE(g, 1.);
}

TEST(FlowLaw, OnlyCompressionHinders)
{
  constexpr double dt = 2e-8, tau = 200e6;
  const double free = relaxed_by_flow(pmma, tau, 0., mu, dt);
  EXPECT_EQ(relaxed_by_flow(pmma, tau, -500e6, mu, dt), free);
  double before = free;
  for (const double p : {10e6, 100e6, 300e6})
  {
    const double share = relaxed_by_flow(pmma, tau, p, mu, dt);
    EXPECT_LT(share, before);
    before = share;
  }
}

TEST(FlowLaw, SteadyFlowCarriesTheStressOfItsRate)
{
  for (const double strain : {1e-5, 1e-3}) // of a step
    for (const double g : {10., 1e3, 1e5})
      for (const double p : {0., 250e6})
      {
        const double dt = strain / g;
        const double steady =
            pmma.stress * std::pow(g, pmma.rate_exponent) + pmma.pressure_slope * p;
        double tau = 0.;
        // Up to yield, and then towards the steady stress with the strain A n/mu (g/g_0)^n.
        for (double all = 0.; all < 2. * steady / mu + 40. * pmma.rate_exponent * steady / mu;
             all += strain)
        {
          const double trial = tau + mu * strain;
          tau                = trial * (1. - relaxed_by_flow(pmma, trial, p, mu, dt));
        }
        // A share of 1e-4 is rounded by 1e-12 of itself, and the stress takes n times that.
        EXPECT_NEAR(tau / steady, 1., 1e-12) << strain << ' ' << g << ' ' << p;
      }
}

TEST(FlowLaw, BondsBelowTheLeastStretchDoNotYield)
{
  const double limit = least_yielding_stretch(pmma, mu);
  for (const auto function : {InfluenceFunction::cone, InfluenceFunction::constant})
  {
    const auto stencil = make_stencil(1e-3, 3., function);
    const auto family  = family_constants(stencil, 5.9e9, mu);
    // tau^2 = 15 mu^2/m sum omega (e - theta |xi|/3)^2 V over both halves of the family.
    const auto tau     = [&](const auto &stretch)
    {
      double theta = 0., square = 0.;
      std::vector<double> s;
      for (const auto &o : stencil.offsets)
        for (const int half : {1, -1})
        {
          s.push_back(stretch(half));
          theta += 3. / family.weighted_volume * o.omega * o.length * o.length * s.back() *
                   family.volume;
        }
      std::size_t i = 0;
      for (const auto &o : stencil.offsets)
        for (int half = 0; half < 2; ++half, ++i)
          square += o.omega * std::pow(o.length * (s[i] - theta / 3.), 2) * family.volume;
      return mu * std::sqrt(15. / family.weighted_volume * square);
    };
    Random random(7);
    for (int sample = 0; sample < 100; ++sample)
      EXPECT_LE(tau([&](int) { return limit * random.uniform(); }), pmma.stress);
    // The bound is sharp: one half of the family pulled, the other pushed.
    EXPECT_NEAR(tau([&](const int half) { return half * limit; }), pmma.stress,
                1e-12 * pmma.stress);
  }
}
} // namespace
} // namespace ricochet::tests
