// SPDX-License-Identifier: LGPL-2.1-or-later
// A peridynamic bar whose shear modulus relaxes, pulled at a constant rate, against the Prony
// solution of uniaxial stress.
#include "body.h"

#include <gtest/gtest.h>

#include <iostream>

namespace ricochet::tests
{
namespace
{
// PMMA (Wang, Foundations of Stress Waves, ZWT constants split at a bulk modulus of 5.9 GPa).
constexpr double K = 5.9e9, mu = 2.258e9, density = 1190.;
const RelaxationSeries pmma{{0.146, 15.3}, {0.541, 95.4e-6}};

/// Uniaxial stress with elastic volume: sigma = 3 [mu_inf e' + sum mu_k (e' - b_k)], e' = epsilon -
/// sigma/9K, db_k/dt = (e' - b_k)/theta_k; small strain at a constant rate.
class PronyBar
{
public:
  PronyBar(const RelaxationSeries &series, const double rate) :
    series_(series), rate_(rate), back_(series.size(), 0.)
  {
  }

  void advance(const double duration)
  {
    // Runge and Kutta of fourth order, steps of a thousandth of the shortest time at most.
    double shortest = duration;
    for (const auto &branch : series_)
      shortest = std::min(shortest, branch.time);
    const int n    = static_cast<int>(std::ceil(100. * duration / shortest));
    const double h = duration / n;
    for (int i = 0; i < n; ++i)
    {
      const auto k1 = slope(time_, back_), k2 = slope(time_ + h / 2., shifted(k1, h / 2.)),
                 k3 = slope(time_ + h / 2., shifted(k2, h / 2.)),
                 k4 = slope(time_ + h, shifted(k3, h));
      for (std::size_t k = 0; k < back_.size(); ++k)
        back_[k] += h / 6. * (k1[k] + 2. * k2[k] + 2. * k3[k] + k4[k]);
      time_ += h;
    }
  }

  double strain() const { return rate_ * time_; }
  double stress() const { return stress(time_, back_); }
  /// Lateral strain: epsilon_v = sigma/3K.
  double lateral() const { return (stress() / (3. * K) - strain()) / 2.; }

private:
  double stress(const double t, const std::vector<double> &back) const
  {
    double held = 0.; // sum lambda_k b_k
    for (std::size_t k = 0; k < back.size(); ++k)
      held += series_[k].share * back[k];
    // sigma = 3 mu (epsilon - sigma/9K - held)
    return 3. * mu * (rate_ * t - held) / (1. + mu / (3. * K));
  }
  std::vector<double> slope(const double t, const std::vector<double> &back) const
  {
    const double axial = rate_ * t - stress(t, back) / (9. * K);
    std::vector<double> result;
    for (std::size_t k = 0; k < back.size(); ++k)
      result.push_back((axial - back[k]) / series_[k].time);
    return result;
  }
  std::vector<double> shifted(const std::vector<double> &slope, const double h) const
  {
    auto result = back_;
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] += h * slope[k];
    return result;
  }

  RelaxationSeries series_;
  double rate_, time_ = 0.;
  std::vector<double> back_;
};

std::unique_ptr<PeridynamicForce> bar(const std::array<int, 3> &n, const double spacing,
                                      const RelaxationSeries &series, const double dt,
                                      const HistoryPrecision precision)
{
  const PeridynamicMaterial material{
      &bond_law("linear peridynamic solid"), density, K, mu, unbreakable, series, precision};
  auto body = std::make_unique<PeridynamicForce>(
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
    PronyBar expected(pmma, rate);
    const auto &l = body->lattice();
    for (int i = 1; i <= n; ++i)
    {
      expected.advance(dt);
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
      body->evaluate(false, false);
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
    body->evaluate(false, false);
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
    PronyBar expected(pmma, rate), comparison({}, rate);
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
