// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/element_body.h"

#include "ricochet/base/exceptions.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace ricochet::tests
{
namespace
{
template <class T>
T sum_over_ranks(T value, const MPI_Datatype type)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, type, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

int n_ranks()
{
  int n;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

TEST(HexMesh, UniformBoxHasTheNodesAndElementsOfItsGrid)
{
  // 3 x 2 x 4 roots, each halved once.
  const HexMesh mesh(MPI_COMM_WORLD, {Vector3(1., 2., 3.), 0.5, {6, 4, 8}, false, {}});
  EXPECT_EQ(mesh.n_global_elements(), 6 * 4 * 8);
  EXPECT_EQ(mesh.n_global_nodes(), 7 * 5 * 9);
  EXPECT_EQ(sum_over_ranks(mesh.n_owned_nodes(), MPI_INT), 7 * 5 * 9);
  EXPECT_EQ(sum_over_ranks(static_cast<int>(mesh.elements().size()), MPI_INT), 6 * 4 * 8);
  EXPECT_EQ(sum_over_ranks(static_cast<int>(mesh.hanging_nodes().node.size()), MPI_INT), 0);
  for (const auto &element : mesh.elements())
  {
    EXPECT_EQ(element.edge, 0.5);
    for (int a = 0; a < 8; ++a)
      EXPECT_EQ(mesh.reference_position(element.nodes[a]) -
                    mesh.reference_position(element.nodes[0]),
                0.5 * Vector3(a & 1, (a >> 1) & 1, a >> 2));
  }
  EXPECT_EQ(sum_over_ranks(mesh.n_nodes() - mesh.n_owned_nodes(), MPI_INT) > 0, n_ranks() > 1);
}

TEST(HexMesh, RefinedBoxFillsItsVolumeWithTheEdgesAskedFor)
{
  const auto box = refined_box();
  const HexMesh mesh(MPI_COMM_WORLD, box);
  double volume = 0.;
  std::array<int, 3> n_of_level{};
  for (const auto &element : mesh.elements())
  {
    volume += std::pow(element.edge, 3);
    const int level = static_cast<int>(std::lround(std::log2(box.edge / element.edge)));
    ASSERT_LE(level, 2);
    ++n_of_level[level];
    EXPECT_EQ(element.edge, std::ldexp(box.edge, -level));
    const Vector3 centre = mesh.centre(element);
    for (const auto &region : box.regions)
      if ((centre.array() > region.low.array()).all() &&
          (centre.array() < region.high.array()).all())
      {
        EXPECT_GE(level, region.levels);
      }
  }
  EXPECT_NEAR(sum_over_ranks(volume, MPI_DOUBLE), 60e-9, 1e-14 * 60e-9); // 5 x 4 x 3 mm^3
  // The first region covers 3 x 2 x 2 half cubes, which become quarter cubes; they touch 2 x 2 x 2
  // cubes of the box, which are halved. The second one is one cube.
  EXPECT_EQ(sum_over_ranks(n_of_level[2], MPI_INT), 8 * 12);
  EXPECT_EQ(sum_over_ranks(n_of_level[1], MPI_INT), 8 * (8 + 1) - 12);
  EXPECT_EQ(sum_over_ranks(n_of_level[0], MPI_INT), 60 - 8 - 1);
  EXPECT_EQ(mesh.n_global_elements(), 96 + 60 + 51);
}

TEST(HexMesh, HangingNodesLieInTheMiddleOfTheirMasters)
{
  const HexMesh mesh(MPI_COMM_WORLD, refined_box());
  const auto &hanging = mesh.hanging_nodes();
  const std::set<int> nodes(hanging.node.begin(), hanging.node.end());
  EXPECT_EQ(nodes.size(), hanging.node.size());
  int n_on_edges = 0, n_on_faces = 0;
  for (std::size_t k = 0; k < hanging.node.size(); ++k)
  {
    const int n_masters = hanging.first[k + 1] - hanging.first[k];
    ASSERT_TRUE(n_masters == 2 || n_masters == 4);
    (n_masters == 2 ? n_on_edges : n_on_faces) += hanging.node[k] < mesh.n_owned_nodes();
    Vector3 middle = Vector3::Zero();
    for (int i = hanging.first[k]; i < hanging.first[k + 1]; ++i)
    {
      EXPECT_EQ(hanging.weight[i], 1. / n_masters);
      EXPECT_EQ(nodes.count(hanging.master[i]), 0u) << "a master hangs itself";
      middle += hanging.weight[i] * mesh.reference_position(hanging.master[i]);
    }
    EXPECT_LT((middle - mesh.reference_position(hanging.node[k])).norm(), 1e-18); // of 1e-3
  }
  n_on_edges = sum_over_ranks(n_on_edges, MPI_INT);
  n_on_faces = sum_over_ranks(n_on_faces, MPI_INT);
  // Counted by hand. A halved block in a corner of the box shows three faces to larger neighbours;
  // the middles of its cubes' faces and edges on them hang. One cube: 3 faces, 3 * 4 edges less
  // the 3 shared ones. 2 x 2 x 2 cubes: 3 * 4 faces, 3 * 12 edges less 3 * 2 shared. 3 x 2 x 2 half
  // cubes: faces 4 + 6 + 6, edges 12 + 17 + 17 less 2 + 2 + 3 shared.
  EXPECT_EQ(n_on_faces, 3 + 12 + 16);
  EXPECT_EQ(n_on_edges, 9 + 30 + 39);
}

TEST(HexMesh, GhostsAndHangingNodesTakeTheValuesOfOwnersAndMasters)
{
  const HexMesh mesh(MPI_COMM_WORLD, refined_box());
  // Linear, so that following masters gives the value of the place.
  const auto value = [](const Vector3 &X) -> Vector3 {
    return {1. + X[0] - 2. * X[1], 3. * X[2] - X[0], 0.5 * X[1] + X[2] - 2.};
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values(3 * mesh.n_nodes(), nan);
  const auto &hanging = mesh.hanging_nodes();
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    set(values, node, value(mesh.reference_position(node)));
  for (const int node : hanging.node)
    set(values, node, Vector3::Constant(nan));
  mesh.update_ghosts(values.data());
  mesh.follow_masters(values.data());
  for (int node = 0; node < mesh.n_nodes(); ++node)
    EXPECT_LT((at(values, node) - value(mesh.reference_position(node))).norm(), 1e-15);
}

TEST(HexMesh, AddToOwnersIsTheTransposeOfUpdateAndFollow)
{
  const HexMesh mesh(MPI_COMM_WORLD, refined_box());
  const auto &hanging = mesh.hanging_nodes();
  std::vector<char> free(mesh.n_nodes(), 1);
  for (const int node : hanging.node)
    free[node] = 0;
  // y . (A x) = (A^T y) . x
  std::vector<double> x(3 * mesh.n_nodes(), 0.), y = x;
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    if (free[node])
      set(x, node, noise_at(mesh.reference_position(node), 1e-3));
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  Random random(20 + rank);
  // Owned nodes and what elements add to: ghosts themselves take nothing.
  for (int i = 0; i < 3 * mesh.n_owned_nodes(); ++i)
    y[i] = random.uniform();
  for (const auto &element : mesh.elements())
    for (const int node : element.nodes)
      for (int d = 0; d < 3; ++d)
        y[3 * node + d] = random.uniform();
  auto Ax = x, transposed_y = y;
  mesh.update_ghosts(Ax.data());
  mesh.follow_masters(Ax.data());
  mesh.add_to_owners(transposed_y.data());
  double left = 0., right = 0.;
  for (int i = 0; i < 3 * mesh.n_nodes(); ++i)
    left += y[i] * Ax[i];
  for (int i = 0; i < 3 * mesh.n_owned_nodes(); ++i)
    right += transposed_y[i] * x[i];
  left  = sum_over_ranks(left, MPI_DOUBLE);
  right = sum_over_ranks(right, MPI_DOUBLE);
  EXPECT_NEAR(left, right, 1e-11); // sums of about 2000 terms of order one
  EXPECT_GT(std::abs(left), 1.);
  for (int node = 0; node < mesh.n_nodes(); ++node)
    if (!free[node] || node >= mesh.n_owned_nodes())
    {
      EXPECT_EQ(at(transposed_y, node), Vector3(Vector3::Zero()));
    }
}

TEST(HexMesh, ImpossibleMeshesAreRefusedWithARemedy)
{
  const auto message = [](const HexMesh::Box &box) -> std::string
  {
    try
    {
      const HexMesh mesh(MPI_COMM_WORLD, box);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "accepted";
  };
  const Vector3 o = Vector3::Zero();
  EXPECT_NE(message({o, 1e-3, {4, 0, 4}, false, {}}).find("at least one cube"), std::string::npos);
  EXPECT_NE(message({o, 0., {4, 4, 4}, false, {}}).find("positive edge"), std::string::npos);
  EXPECT_NE(
      message({o, 1e-3, {4, 4, 4}, false, {{Vector3::Constant(5e-3), Vector3::Constant(6e-3), 1}}})
          .find("must overlap"),
      std::string::npos);
  EXPECT_NE(message({o, 1e-3, {4, 4, 4}, false, {{o, Vector3::Constant(1e-3), 0}}})
                .find("at least one level"),
            std::string::npos);
  EXPECT_NE(message({o, 1e-3, {1001, 1001, 3}, false, {}}).find("multiples of 2"),
            std::string::npos);
  EXPECT_EQ(message({o, 1e-3, {1, 1, 1}, false, {}}) == "accepted", n_ranks() == 1);
}
} // namespace
} // namespace ricochet::tests
