// SPDX-License-Identifier: LGPL-2.1-or-later
// A bar of points on the left and elements on the right, as long as a wave packet needs: rows next
// to the interface as measured, all others as those in the middle of either side.
#pragma once

#include "support/plane_system.h"

#include <Eigen/Sparse>

namespace ricochet::tests
{
class LongBar
{
public:
  enum Side
  {
    points,
    nodes
  };

  /// Of so many planes. The interface is at x = 0.
  LongBar(const CoupledSample &sample, const int n_points, const int n_nodes)
  {
    const int n          = sample.coupling.points_per_edge;
    const int n_cells    = 96 / n;
    auto short_bar       = bar(n_cells, 0, n_cells / 2, n);
    short_bar.coupling   = sample.coupling;
    short_bar.pad_layers = sample.pad_layers;
    PlateModel plate(short_bar);
    const auto s          = plane_system(plate);
    spacing_              = {plate.spacing, plate.edge()};
    const auto first_node = std::find(s.is_point.begin(), s.is_point.end(), 0) - s.is_point.begin();
    const Eigen::Index middle[2] = {first_node / 2, (s.size() + first_node) / 2};
    for (const Side side : {points, nodes})
      for (int r = 0; r <= 6; ++r)
        row_[side].push_back(s.acceleration(middle[side], middle[side] + r));

    const int n_planes = n_points + n_nodes;
    x.resize(n_planes);
    mass.resize(n_planes);
    std::vector<Eigen::Triplet<double>> entries;
    const double negligible = 1e-8 * s.acceleration.cwiseAbs().maxCoeff();
    for (int i = 0; i < n_planes; ++i)
    {
      const int offset = i - n_points;
      const Side side  = offset < 0 ? points : nodes;
      x[i]    = side == points ? (offset + 0.5) * spacing_[points] : offset * spacing_[nodes];
      mass[i] = offset == 0 ? s.mass[first_node] : PlateModel::density * spacing_[side];
      const auto add = [&](const int j, const double value)
      {
        if (j >= 0 && j < n_planes && std::abs(value) > negligible)
          entries.emplace_back(i, j, value);
      };
      if (offset >= -14 && offset < (n == 1 ? 16 : 8))
        for (Eigen::Index j = 0; j < s.size(); ++j)
          add(static_cast<int>(j - first_node) + n_points, s.acceleration(first_node + offset, j));
      else
        for (int r = -6; r <= 6; ++r)
          add(i + r, row_[side][std::abs(r)]);
    }
    matrix_.resize(n_planes, n_planes);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(n_planes, 0., 1e4).array().sin();
    for (int i = 0; i < 300; ++i)
      q = (matrix_ * q).normalized();
    dt_ = 0.9 * 2. / std::sqrt((matrix_ * q).norm());
    u   = Eigen::VectorXd::Zero(n_planes);
    v   = u;
  }

  double dt() const { return dt_; }

  /// Of a wave of the leapfrog scheme with this wave number on this side [1/s].
  double frequency(const Side side, const double k) const
  {
    double squared = -row_[side][0];
    for (int r = 1; r <= 6; ++r)
      squared -= 2. * row_[side][r] * std::cos(k * r * spacing_[side]);
    return 2. / dt_ * std::asin(0.5 * dt_ * std::sqrt(std::max(0., squared)));
  }
  double group_velocity(const Side side, const double k) const
  {
    return (frequency(side, 1.001 * k) - frequency(side, 0.999 * k)) / (0.002 * k);
  }

  /// A packet about x0 that travels towards the interface and nowhere else: a sum of the side's own
  /// waves, exp(-(x - x0)^2/2 width^2) cos(k (x - x0)).
  void start(const Side side, const double k, const double width, const double x0)
  {
    u.setZero();
    Eigen::VectorXd before = u;
    constexpr int n_waves  = 401;
    for (int i = 0; i < n_waves; ++i)
    {
      const double here   = k + (i - n_waves / 2) * 8. / width / n_waves;
      const double weight = std::exp(-0.5 * std::pow((here - k) * width, 2));
      const double turn   = (side == points ? 1. : -1.) * frequency(side, std::abs(here)) * dt_ *
                          (here < 0. ? -1. : 1.);
      for (Eigen::Index j = 0; j < x.size(); ++j)
        if ((x[j] < -0.1 * spacing_[0]) == (side == points))
        {
          u[j] += weight * std::cos(here * (x[j] - x0));
          before[j] += weight * std::cos(here * (x[j] - x0) + turn);
        }
    }
    v = (u - before) / dt_;
  }

  void run(const int n_steps)
  {
    for (int step = 0; step < n_steps; ++step)
    {
      v += dt_ * (matrix_ * u);
      u += dt_ * v;
    }
  }

  /// Sum of m v^2 on a side, without the ten spacings next to the interface: the energy of a
  /// packet.
  double energy(const Side side) const
  {
    double sum = 0.;
    for (Eigen::Index j = 0; j < x.size(); ++j)
      if (side == points ? x[j] < -10. * spacing_[0] : x[j] > 10. * spacing_[0])
        sum += mass[j] * v[j] * v[j];
    return sum;
  }
  /// Where that energy is.
  double centre(const Side side) const
  {
    double sum = 0.;
    for (Eigen::Index j = 0; j < x.size(); ++j)
      if (side == points ? x[j] < -10. * spacing_[0] : x[j] > 10. * spacing_[0])
        sum += mass[j] * v[j] * v[j] * x[j];
    return sum / energy(side);
  }

  Eigen::VectorXd x, mass, u, v;

private:
  std::array<double, 2> spacing_; // of planes
  std::array<std::vector<double>, 2> row_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_;
  double dt_;
};
} // namespace ricochet::tests
