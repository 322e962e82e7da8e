// SPDX-License-Identifier: LGPL-2.1-or-later
#include "level_cholesky.h"

#include "ricochet/base/exceptions.h"

namespace ricochet
{
namespace
{
/// Rows in the order in which a wave from one of them reaches them, and where each front begins.
struct Levels
{
  std::vector<int> order, starts;

  Levels(const SparseRows &matrix, const int first) : order{first}, starts{0}
  {
    std::vector<char> reached(matrix.size(), 0);
    reached[first] = 1;
    for (std::size_t begin = 0; begin < order.size();)
    {
      const std::size_t end = order.size();
      starts.push_back(static_cast<int>(end));
      for (; begin < end; ++begin)
        for (int k = matrix.starts[order[begin]]; k < matrix.starts[order[begin] + 1]; ++k)
          if (const int next = matrix.columns[k]; !reached[next])
          {
            reached[next] = 1;
            order.push_back(next);
          }
    }
  }
};
} // namespace

LevelCholesky::LevelCholesky(const SparseRows &matrix)
{
  // From the end that is farthest from anywhere.
  const Levels levels(matrix, Levels(matrix, 0).order.back());
  order_  = levels.order;
  starts_ = levels.starts;
  if (static_cast<int>(order_.size()) != matrix.size())
    throw RunError("A matrix of loose parts was to be factorised.");
  std::vector<int> place(order_.size()); // in the order
  for (std::size_t i = 0; i < order_.size(); ++i)
    place[order_[i]] = static_cast<int>(i);

  const std::size_t n_levels = starts_.size() - 1;
  diagonal_.resize(n_levels);
  above_.resize(n_levels);
  Eigen::MatrixXd block;
  for (std::size_t level = 0; level < n_levels; ++level)
  {
    const int start = starts_[level], end = starts_[level + 1];
    const int beyond = level + 1 < n_levels ? size_of(level + 1) : 0;
    block.setZero(end - start, end - start);
    above_[level].setZero(end - start, beyond);
    for (int i = start; i < end; ++i)
      for (int k = matrix.starts[order_[i]]; k < matrix.starts[order_[i] + 1]; ++k)
      {
        const int j = place[matrix.columns[k]];
        if (j >= end)
          above_[level](i - start, j - end) = matrix.values[k];
        else if (j >= start)
          block(i - start, j - start) = matrix.values[k];
      }
    if (level > 0)
      block.selfadjointView<Eigen::Lower>().rankUpdate(above_[level - 1].transpose(), -1.);
    diagonal_[level].compute(block);
    if (diagonal_[level].info() != Eigen::Success)
      throw RunError("The stiffness of the projectile's mesh is not positive: it cannot be "
                     "factorised.\n  Mesh the body again with better elements.");
    diagonal_[level].matrixL().solveInPlace(above_[level]);
  }
}

void LevelCholesky::solve(Eigen::Ref<Eigen::MatrixXd> columns) const
{
  Eigen::MatrixXd x(columns.rows(), columns.cols());
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    x.row(i) = columns.row(order_[i]);
  const auto part = [&](const std::size_t level)
  { return x.middleRows(starts_[level], size_of(level)); };
  for (std::size_t level = 0; level < diagonal_.size(); ++level)
  {
    auto mine = part(level);
    diagonal_[level].matrixL().solveInPlace(mine);
    if (level + 1 < diagonal_.size())
      part(level + 1) -= above_[level].transpose() * mine;
  }
  for (std::size_t level = diagonal_.size(); level-- > 0;)
  {
    auto mine = part(level);
    if (level + 1 < diagonal_.size())
      mine -= above_[level] * part(level + 1);
    diagonal_[level].matrixU().solveInPlace(mine);
  }
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    columns.row(order_[i]) = x.row(i);
}
} // namespace ricochet
