// SPDX-License-Identifier: LGPL-2.1-or-later
// A bar in uniaxial stress whose shear modulus relaxes: the analytic solution that bonds, elements
// and both together are compared with.
#pragma once

#include "ricochet/materials/relaxation.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ricochet::tests
{
/// PMMA (Wang, Foundations of Stress Waves, ZWT constants split at a bulk modulus of 5.9 GPa).
inline const RelaxationSeries pmma{{0.146, 15.3}, {0.541, 95.4e-6}};

/// Uniaxial stress with elastic volume: sigma = 3 [mu_inf e' + sum mu_k (e' - b_k)], e' = epsilon -
/// sigma/9K, db_k/dt = (e' - b_k)/theta_k; small strain at a constant rate.
class PronyBar
{
public:
  PronyBar(const double bulk_modulus, const double shear_modulus, const RelaxationSeries &series,
           const double rate) :
    K_(bulk_modulus),
    mu_(shear_modulus), series_(series), rate_(rate), back_(series.size(), 0.)
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
  double lateral() const { return (stress() / (3. * K_) - strain()) / 2.; }

private:
  double stress(const double t, const std::vector<double> &back) const
  {
    double held = 0.; // sum lambda_k b_k
    for (std::size_t k = 0; k < back.size(); ++k)
      held += series_[k].share * back[k];
    // sigma = 3 mu (epsilon - sigma/9K - held)
    return 3. * mu_ * (rate_ * t - held) / (1. + mu_ / (3. * K_));
  }
  std::vector<double> slope(const double t, const std::vector<double> &back) const
  {
    const double axial = rate_ * t - stress(t, back) / (9. * K_);
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

  double K_, mu_; // [Pa]
  RelaxationSeries series_;
  double rate_, time_ = 0.;
  std::vector<double> back_;
};
} // namespace ricochet::tests
