// SPDX-License-Identifier: LGPL-2.1-or-later
// A peridynamic bar whose shear modulus relaxes, pulled at a constant rate, against the Prony
// solution of uniaxial stress.
#include "support/body.h"
#include "support/prony_bar.h"

#include <gtest/gtest.h>

#include <iostream>

namespace ricochet::tests
{
namespace
{
constexpr double K = 5.9e9, mu = 2.258e9, density = 1190.;

std::unique_ptr<PeridynamicBody> bar(const std::array<int, 3> &n, const double spacing,
                                     const RelaxationSeries &series, const double dt,
                                     const HistoryPrecision precision)
{
  const PeridynamicMaterial material{
      &bond_law("linear peridynamic solid"), density, K, mu, unbreakable, series, precision};
  auto body = std::make_unique<PeridynamicBody>(
      MPI_COMM_SELF, 0, Lattice::Box{Vector3::Zero(), spacing, n, false},
      make_stencil(spacing, 3., InfluenceFunction::cone), material);
  body->start_relaxation(dt);
  return body;
}

TEST(RelaxingBar, CarriesThePronyStressAtAnyRate)
{
  // The inside of a thick bar that is strained as the solution says, 1e-3 to 1e4 per second: the
  // response is linear, so a thousandth of the strain shows it, and small strains keep geometry
  // out.
  constexpr double scale = 1e-3;
  for (double rate = 1e-3; rate < 2e4; rate *= 10.)
  {
    const double duration = std::min(0.2, 0.02 / rate);
    const int n           = std::max(200, static_cast<int>(std::ceil(duration / 95e-6)));
    const double dt       = duration / n;
    const auto body       = bar({12, 12, 12}, 1e-3, pmma, dt, HistoryPrecision::single_precision);
    PronyBar expected(K, mu, pmma, rate);
    const auto &l = body->lattice();
    for (int i = 1; i <= n; ++i)
    {
      expected.advance(dt);
      body->end_step();
      const double axial = scale * expected.strain(), lateral = scale * expected.lateral();
      for_each_point(
          *body,
          [&](const std::ptrdiff_t p)
          {
            const Vector3 X = reference(*body, p);
            set(body->state().arrays.position, p,
                Vector3((1. + axial) * X.x(), (1. + lateral) * X.y(), (1. + lateral) * X.z()));
          });
      body->update_ghosts();
      body->compute_internal_forces({false});
      if (i % (n / 10) != 0)
        continue;
      // Tractions on cuts through the middle: the forces on one half of a column.
      double stress = 0., sideways = 0.;
      for (int x = 0; x < 6; ++x)
        stress += force(*body, l.index(x, 6, 6)).x() / 1e-6;
      for (int y = 0; y < 6; ++y)
        sideways += force(*body, l.index(6, y, 6)).y() / 1e-6;
      // Isotropy of the lattice: 0.5 % in either direction.
      EXPECT_NEAR(stress / (scale * expected.stress()), 1., 0.005) << "rate " << rate;
      EXPECT_NEAR(sideways / (scale * expected.stress()), 0., 0.005) << "rate " << rate;
    }
  }
}

/// Force at the end of a thin bar that is pulled by its ends in true time steps, per step [N].
std::vector<double> pulled_bar(const RelaxationSeries &series, const HistoryPrecision precision,
                               const double rate, const double dt, const int n_steps)
{
  constexpr double spacing = 0.1e-3;
  constexpr int length = 40, clamp = 3;
  const auto body = bar({length, 6, 6}, spacing, series, dt, precision);
  auto &a         = body->state().arrays;
  // From rest in strain, but with the velocities of uniform strain: no wave starts from the ends.
  for_each_point(*body, [&](const std::ptrdiff_t p)
                 { set(a.velocity, p, Vector3(rate * reference(*body, p).x(), 0., 0.)); });
  std::vector<double> history;
  for (int i = 0; i < n_steps; ++i)
  {
    body->update_ghosts();
    body->compute_internal_forces({false});
    double end = 0.;
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     if (body->lattice().coordinates(p)[0] >= length - clamp)
                       end -= force(*body, p).x();
                   });
    history.push_back(end);
    body->advance(dt, dt);
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     const int x     = body->lattice().coordinates(p)[0];
                     const Vector3 X = reference(*body, p);
                     if (x < clamp || x >= length - clamp)
                     {
                       a.position[0][p] = X.x() * (1. + rate * (i + 1) * dt);
                       a.velocity[0][p] = X.x() * rate;
                     }
                   });
  }
  return history;
}

TEST(RelaxingBar, PulledInTrueStepsItSoftensLikeThePronySeries)
{
  const double dt = 0.04e-6;
  for (const double rate : {100., 1000.})
  {
    const int n         = static_cast<int>(std::lround(std::min(100e-6, 0.02 / rate) / dt));
    const auto elastic  = pulled_bar({}, HistoryPrecision::single_precision, rate, dt, n);
    const auto relaxing = pulled_bar(pmma, HistoryPrecision::single_precision, rate, dt, n);
    PronyBar expected(K, mu, pmma, rate), comparison(K, mu, {}, rate);
    expected.advance((n - 1) * dt);
    comparison.advance((n - 1) * dt);
    // Skin, clamps and finite strain are the same in both.
    const double share = expected.stress() / comparison.stress();
    EXPECT_LT(share, 0.96);
    EXPECT_NEAR(relaxing.back() / elastic.back(), share, 0.005) << "rate " << rate;
  }
}

TEST(RelaxingBar, SinglePrecisionHistoryHardlyShowsInTheForce)
{
  const double dt   = 0.04e-6;
  const int n       = 2500; // 100 us
  const auto exact  = pulled_bar(pmma, HistoryPrecision::double_precision, 100., dt, n),
             single = pulled_bar(pmma, HistoryPrecision::single_precision, 100., dt, n);
  double worst      = 0.;
  for (int i = 0; i < n; ++i)
    worst = std::max(worst, std::abs(single[i] - exact[i]));
  std::cout << "[ MEASURED ] single-precision history: force of a pulled bar off by at most "
            << worst / exact.back() << " of its largest in " << n << " steps" << std::endl;
  EXPECT_LT(worst, 1e-6 * exact.back());
  EXPECT_GT(worst, 0.);
}
} // namespace
} // namespace ricochet::tests
