// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/element_body.h"

#include "ricochet/finite_elements/node_links.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// Every rank asks for other nodes, some of them its own, and some for the same ones.
std::vector<std::int64_t> wanted(const HexMesh &mesh)
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::vector<std::int64_t> nodes;
  for (std::int64_t node = rank; node < mesh.n_global_nodes(); node += 2 + rank)
    nodes.push_back(node);
  return nodes;
}

double value_of(const std::int64_t global, const int d)
{
  return static_cast<double>(3 * global + d);
}

TEST(NodeLinks, FetchWhatTheOwnersHave)
{
  const HexMesh mesh(MPI_COMM_WORLD, refined_box());
  const auto nodes = wanted(mesh);
  NodeLinks links(MPI_COMM_WORLD, mesh, nodes);
  std::vector<double> values(mesh.reference().size(), -1.), seen(3 * nodes.size());
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    for (int d = 0; d < 3; ++d)
      values[3 * node + d] = value_of(mesh.global_node(node), d);
  links.fetch(values, seen);
  ASSERT_FALSE(nodes.empty());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(seen[3 * i + d], value_of(nodes[i], d));
}

TEST(NodeLinks, AddToTheOwnersWhatAllRanksHave)
{
  const HexMesh mesh(MPI_COMM_WORLD, refined_box());
  const auto nodes = wanted(mesh);
  NodeLinks links(MPI_COMM_WORLD, mesh, nodes);
  std::vector<double> seen(3 * nodes.size(), 1.), values(mesh.reference().size(), 10.);
  links.add(seen, values);
  int n_ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
  {
    const auto global = mesh.global_node(node);
    double n_asking   = 0.;
    for (int rank = 0; rank < n_ranks; ++rank)
      n_asking += global >= rank && (global - rank) % (2 + rank) == 0;
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(values[3 * node + d], 10. + n_asking);
  }
}
} // namespace
} // namespace ricochet::tests
