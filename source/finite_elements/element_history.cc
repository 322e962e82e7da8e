// SPDX-License-Identifier: LGPL-2.1-or-later
#include "element_history.h"

#include "ricochet/base/voigt.h"

namespace ricochet
{
namespace
{
void complete(Eigen::Matrix3d &upper)
{
  for (int k = 0; k < voigt::n; ++k)
    if (voigt::is_shear(k))
      upper(voigt::column[k], voigt::row[k]) = upper(voigt::row[k], voigt::column[k]);
}
} // namespace

ElementHistory::ElementHistory(const std::size_t n_elements, const int n_points,
                               const int n_branches) :
  n_points_(n_points),
  n_branches_(n_branches)
{
  const std::size_t n_blocks = (n_elements + block_size - 1) / block_size;
  values_.assign(n_blocks * block_size * n_points * voigt::n * (1 + n_branches), 0.);
  dissipated_.assign(n_elements, 0.);
}

/// Where the six numbers of a branch begin, each `block_size` after the other; branch 0 is 2 E.
std::size_t ElementHistory::row(const int index, const int point, const int branch) const
{
  const std::size_t block = index / block_size;
  return ((block * n_points_ + point) * (1 + n_branches_) + branch) * voigt::n * block_size +
         index % block_size;
}

ElementHistory::Memory ElementHistory::memory(const int index) const
{
  Memory memory;
  memory.dissipated = dissipated_[index];
  for (int point = 0; point < n_points_; ++point)
  {
    auto &values = memory.points.emplace_back();
    for (int i = 0; i < voigt::n * (1 + n_branches_); ++i)
      values.push_back(values_[row(index, point, 0) + i * block_size]);
  }
  return memory;
}

void ElementHistory::restore(const int index, const Memory &memory)
{
  if (memory.points.empty())
    return;
  dissipated_[index] = memory.dissipated;
  const int n_before = static_cast<int>(memory.points.size());
  for (int point = 0; point < n_points_; ++point)
    for (int i = 0; i < voigt::n * (1 + n_branches_); ++i)
    {
      double value = 0.;
      if (n_before == n_points_)
        value = memory.points[point][i];
      else
        for (const auto &there : memory.points)
          value += there[i] / n_before;
      values_[row(index, point, 0) + i * block_size] = value;
    }
}

Eigen::Matrix3d ElementHistory::strain(const int index) const
{
  Eigen::Matrix3d E = Eigen::Matrix3d::Zero();
  for (int point = 0; point < n_points_; ++point)
    for (int k = 0; k < voigt::n; ++k)
      E(voigt::row[k], voigt::column[k]) +=
          0.5 * values_[row(index, point, 0) + k * block_size] / n_points_;
  complete(E);
  return E;
}

Eigen::Matrix3d ElementHistory::back_strain(const int index, const int branch) const
{
  Eigen::Matrix3d E_b = Eigen::Matrix3d::Zero();
  for (int point = 0; point < n_points_; ++point)
    for (int k = 0; k < voigt::n; ++k)
    {
      const double twice = values_[row(index, point, 0) + k * block_size] -
                           values_[row(index, point, 1 + branch) + k * block_size];
      E_b(voigt::row[k], voigt::column[k]) += 0.5 * twice / n_points_;
    }
  complete(E_b);
  return E_b;
}
} // namespace ricochet
