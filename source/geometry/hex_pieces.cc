// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/hex_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

namespace ricochet
{
namespace
{
// Corners of the faces, in any order.
constexpr int faces[6][4] = {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5},
                             {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};

/// Groups of numbers that grow together.
class Groups
{
public:
  explicit Groups(const std::size_t n) : parent_(n)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The member that stands for the group.
  int of(int member)
  {
    while (parent_[member] != member)
      member = parent_[member] = parent_[parent_[member]]; // shortens the way for the next
    return member;
  }

  void join(const int a, const int b) { parent_[of(a)] = of(b); }

private:
  std::vector<int> parent_;
};
} // namespace

std::vector<int> piece_sizes(const HexSolid &solid)
{
  const int n_cells = static_cast<int>(solid.cells.size());
  Groups groups(solid.cells.size());
  std::map<std::array<int, 4>, int> first; // cell that has a face, by its sorted nodes
  for (int cell = 0; cell < n_cells; ++cell)
    for (const auto &face : faces)
    {
      std::array<int, 4> nodes;
      for (int i = 0; i < 4; ++i)
        nodes[i] = solid.cells[cell][face[i]];
      std::sort(nodes.begin(), nodes.end());
      groups.join(cell, first.emplace(nodes, cell).first->second);
    }
  std::map<int, int> count;
  for (int cell = 0; cell < n_cells; ++cell)
    ++count[groups.of(cell)];
  std::vector<int> sizes;
  sizes.reserve(count.size());
  for (const auto &[group, size] : count)
    sizes.push_back(size);
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return sizes;
}

int n_coincident_nodes(const HexSolid &solid, const double tolerance)
{
  std::set<int> used; // a file may hold further nodes, for instance of surfaces
  for (const auto &cell : solid.cells)
    used.insert(cell.begin(), cell.end());

  // In cells of twice the tolerance what is near a node lies in its own or in the next one on the
  // nearer side: eight in all.
  const double edge = 2. * tolerance; // [m]
  std::map<std::array<long, 3>, std::vector<int>> grid;
  int n_coincident = 0;
  for (const int node : used)
  {
    const Vector3 &x = solid.nodes[node];
    std::array<long, 3> own, next;
    for (int d = 0; d < 3; ++d)
    {
      own[d]  = std::lround(std::floor(x[d] / edge));
      next[d] = x[d] / edge - double(own[d]) < 0.5 ? own[d] - 1 : own[d] + 1;
    }
    bool coincides = false;
    for (int corner = 0; corner < 8 && !coincides; ++corner)
    {
      std::array<long, 3> key = own;
      for (int d = 0; d < 3; ++d)
        if ((corner >> d) & 1)
          key[d] = next[d];
      if (const auto others = grid.find(key); others != grid.end())
        coincides = std::any_of(others->second.begin(), others->second.end(),
                                [&](const int other)
                                { return (solid.nodes[other] - x).norm() <= tolerance; });
    }
    n_coincident += coincides ? 1 : 0;
    grid[own].push_back(node);
  }
  return n_coincident;
}
} // namespace ricochet
