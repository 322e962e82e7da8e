// SPDX-License-Identifier: LGPL-2.1-or-later
#include "finite_elements/level_cholesky.h"
#include "ricochet/base/exceptions.h"
#include "support/random.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// A chain with bonds to the second neighbours, `diagonal` on the diagonal; rows in a mixed order.
Eigen::MatrixXd chain(const int n, const double diagonal)
{
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  const auto place  = [n](const int i) { return (7 * i) % n; }; // n is no multiple of 7
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - 2); j <= std::min(n - 1, i + 2); ++j)
      A(place(i), place(j)) = i == j ? diagonal : -1.;
  return A;
}

SparseRows rows_of(const Eigen::MatrixXd &A)
{
  SparseRows rows{{0}, {}, {}};
  for (int i = 0; i < A.rows(); ++i)
  {
    for (int j = 0; j < A.cols(); ++j)
      if (A(i, j) != 0.)
      {
        rows.columns.push_back(j);
        rows.values.push_back(A(i, j));
      }
    rows.starts.push_back(static_cast<int>(rows.columns.size()));
  }
  return rows;
}

TEST(LevelCholesky, SolvesForEveryColumn)
{
  const Eigen::MatrixXd A = chain(50, 4.5);
  Random random(5);
  Eigen::MatrixXd b(50, 3);
  for (int i = 0; i < b.size(); ++i)
    b.data()[i] = random.uniform();
  Eigen::MatrixXd x = b;
  LevelCholesky(rows_of(A)).solve(x);
  EXPECT_LT((A * x - b).norm(), 1e-13 * b.norm()); // rounding of some dozen sums
}

TEST(LevelCholesky, RefusesWhatIsNotPositiveOrFallsApart)
{
  EXPECT_THROW(LevelCholesky(rows_of(chain(50, 1.))), RunError);
  EXPECT_THROW(LevelCholesky(rows_of(Eigen::MatrixXd::Identity(4, 4))), RunError);
}
} // namespace
} // namespace ricochet::tests
