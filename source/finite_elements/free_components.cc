// SPDX-License-Identifier: LGPL-2.1-or-later
#include "free_components.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>

namespace ricochet
{
namespace
{
/// All nodes of cells must be reached from the first.
void refuse_loose_parts(const std::vector<std::vector<int>> &neighbours)
{
  std::vector<char> reached(neighbours.size(), 0);
  std::vector<int> border;
  for (std::size_t node = 0; node < neighbours.size() && border.empty(); ++node)
    if (!neighbours[node].empty())
      border.push_back(static_cast<int>(node));
  while (!border.empty())
  {
    const int node = border.back();
    border.pop_back();
    if (reached[node]++)
      continue;
    border.insert(border.end(), neighbours[node].begin(), neighbours[node].end());
  }
  for (std::size_t node = 0; node < neighbours.size(); ++node)
    if (!neighbours[node].empty() && !reached[node])
      throw InputError(
          "The projectile's mesh has parts that nothing holds together.\n  Mesh the body "
          "as one piece, whose cells share faces.");
}
} // namespace

std::vector<int> number_free(const HexahedralBody &body)
{
  std::vector<int> number(3 * body.n_nodes());
  int n = 0;
  for (int i = 0; i < static_cast<int>(number.size()); ++i)
    number[i] = body.inverse_mass(i) > 0. ? n++ : -1;
  return number;
}

int degrees_of_freedom(const HexahedralBody &body)
{
  int n = body.mirrored() ? -3 : -6;
  for (int i = 0; i < 3 * body.n_nodes(); ++i)
    n += body.inverse_mass(i) > 0. ? 1 : 0;
  return n;
}

std::vector<std::vector<int>> neighbours_of(const HexahedralBody &body)
{
  std::vector<std::vector<int>> neighbours(body.n_nodes());
  for (const auto &corners : body.solid().cells)
    for (const int node : corners)
      neighbours[node].insert(neighbours[node].end(), corners.begin(), corners.end());
  for (auto &near : neighbours)
  {
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
  refuse_loose_parts(neighbours);
  return neighbours;
}
} // namespace ricochet
