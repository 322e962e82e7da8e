// SPDX-License-Identifier: LGPL-2.1-or-later
// What the elements of one group remember while their shear stiffness relaxes, in the layout of
// HexRelaxation: eight elements side by side.
#pragma once

#include "ricochet/base/vector.h"

#include <Eigen/Core>

#include <vector>

namespace ricochet
{
class ElementHistory
{
public:
  static constexpr int block_size = 8; // of HexBlock

  /// What one element remembers, in whatever group it is.
  struct Memory
  {
    /// Per Gauss point (one or eight): 2 E and 2 (E - E_b,k) of each branch, as voigt.h; empty: no
    /// history [-].
    std::vector<std::vector<double>> points;
    double dissipated = 0.; // [J]
  };

  ElementHistory() = default;
  /// No history yet. `n_points`: Gauss points of an element.
  ElementHistory(std::size_t n_elements, int n_points, int n_branches);

  Memory memory(int index) const;
  /// With another number of Gauss points than before, an element spreads its history or takes the
  /// mean.
  void restore(int index, const Memory &memory);

  // Means of the Gauss points [-].
  Eigen::Matrix3d strain(int index) const;                  // E, one step ago
  Eigen::Matrix3d back_strain(int index, int branch) const; // E_b,k

  double *values() { return values_.data(); }
  double *dissipated() { return dissipated_.data(); }
  const std::vector<double> &dissipated() const { return dissipated_; } // per element [J]

private:
  std::size_t row(int index, int point, int branch) const;

  int n_points_ = 0, n_branches_ = 0;
  std::vector<double> values_, dissipated_;
};
} // namespace ricochet
