// SPDX-License-Identifier: LGPL-2.1-or-later
// Cholesky's factors of a sparse matrix of a slender body. Rows are taken level by level as a wave
// from one end reaches them, so a level couples with the next alone and the matrix is block
// tridiagonal, with dense blocks of a cross-section's size: sums over few and large blocks, which
// is what a processor does fast. (Debian's Amesos offers KLU, whose LU of 32 600 unknowns takes ten
// times as long, and MUMPS, which it can start on MPI_COMM_WORLD only.)
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace ricochet
{
/// A symmetric matrix, row by row.
struct SparseRows
{
  std::vector<int> starts;  // of each row, and the end
  std::vector<int> columns; // of each entry
  std::vector<double> values;

  int size() const { return static_cast<int>(starts.size()) - 1; }
};

class LevelCholesky
{
public:
  /// Of a positive definite matrix that does not fall apart. Throws RunError if it is not positive
  /// definite.
  explicit LevelCholesky(const SparseRows &matrix);

  /// Replaces each column by the solution for it.
  void solve(Eigen::Ref<Eigen::MatrixXd> columns) const;

private:
  int size_of(const std::size_t level) const { return starts_[level + 1] - starts_[level]; }

  std::vector<int> order_, starts_; // rows in the order of levels; where each level begins
  std::vector<Eigen::LLT<Eigen::MatrixXd>> diagonal_; // L_l L_l^T
  std::vector<Eigen::MatrixXd> above_;                // L_l^-1 A_(l,l+1)
};
} // namespace ricochet
