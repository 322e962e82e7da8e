// SPDX-License-Identifier: LGPL-2.1-or-later
// Points that follow nodes, and the nodes of other ranks that they need; on any number of ranks.
#include "support/coupled_plate.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
CoupledSample column(const bool mirror_y = false, const int points_per_edge = 2)
{
  CoupledSample sample;
  sample.coupling.points_per_edge = points_per_edge;
  sample.n_cells                  = {12, 10, 6};
  sample.zone                     = {{4, mirror_y ? 0 : 3, 0}, {8, 7, 6}};
  sample.mirror_y                 = mirror_y;
  return sample;
}

double sum_over_ranks(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

/// Visits the owned points that are slaved or have contact.
template <class Visitor>
void for_each_slaved(const PlateModel &plate, Visitor &&visit)
{
  const auto &lattice = plate.points->lattice();
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (!lattice.free(p))
          visit(p, lattice.reference_position(lattice.coordinates(p)));
      });
}

double noise(const Vector3 &X, const int d)
{
  return std::sin(12.9898 * 1e3 * X[0] + 78.233 * 1e3 * X[1] + 37.719 * 1e3 * X[2] + 2.1 * d);
}

TEST(SlavedPoints, FollowLinearFieldsExactly)
{
  for (const auto &[mirror_y, n_per_edge] : {std::pair(false, 2), {true, 2}, {true, 1}, {true, 4}})
  {
    PlateModel plate(column(mirror_y, n_per_edge));
    Eigen::Matrix3d F;
    F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.3, -0.2, 0.1, 1.2;
    const Vector3 c(1e-3, -2e-3, 3e-3);
    auto &elements = plate.far->elements();
    for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    {
      const Vector3 X = elements.mesh().reference_position(node), x = F * X + c, v = 1e3 * x;
      for (int d = 0; d < 3; ++d)
      {
        elements.position()[3 * node + d] = x[d];
        elements.velocity()[3 * node + d] = v[d];
      }
    }
    plate.far->lead();
    double n = 0.;
    for_each_slaved(plate,
                    [&](const std::ptrdiff_t p, const Vector3 &X)
                    {
                      const auto &a   = plate.points->state().arrays;
                      const Vector3 x = F * X + c;
                      for (int d = 0; d < 3; ++d)
                      {
                        EXPECT_NEAR(a.position[d][p], x[d], 1e-16);
                        EXPECT_NEAR(a.velocity[d][p], 1e3 * x[d], 1e-13);
                      }
                      n += 1.;
                    });
    EXPECT_EQ(sum_over_ranks(n), std::pow(n_per_edge, 3) * plate.zone->n_slaved_cells());
  }
}

void expect_transpose(const int points_per_edge)
{
  // f . (P u) = (P^T f) . u for any forces on the points and any motion of the nodes.
  PlateModel plate(column(false, points_per_edge));
  auto &elements      = plate.far->elements();
  const auto &lattice = plate.points->lattice();
  SlavedPoints slaved(MPI_COMM_WORLD, elements, lattice,
                      [&](const Zone::Cell &cell) { return plate.zone->is_slaved(cell); });
  for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    for (int d = 0; d < 3; ++d)
      elements.position()[3 * node + d] = noise(elements.mesh().reference_position(node), d);
  slaved.follow(elements, plate.points->state());
  auto &a          = plate.points->state().arrays;
  double on_points = 0., magnitude = 0.;
  Vector3 sum = Vector3::Zero();
  for_each_slaved(plate,
                  [&](const std::ptrdiff_t p, const Vector3 &X)
                  {
                    for (int d = 0; d < 3; ++d)
                    {
                      a.force[d][p] = noise(2. * X, d + 5);
                      on_points += a.force[d][p] * a.position[d][p];
                      magnitude += std::abs(a.force[d][p] * a.position[d][p]);
                      sum[d] += a.force[d][p];
                    }
                  });
  std::vector<double> nodal(elements.force().size(), 0.);
  slaved.hand_on(plate.points->state(), nodal);
  double on_nodes = 0.;
  Vector3 handed  = Vector3::Zero();
  for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    for (int d = 0; d < 3; ++d)
    {
      on_nodes += nodal[3 * node + d] * elements.position()[3 * node + d];
      handed[d] += nodal[3 * node + d];
    }
  magnitude = sum_over_ranks(magnitude);
  EXPECT_GT(magnitude, 100.);
  EXPECT_NEAR(sum_over_ranks(on_points), sum_over_ranks(on_nodes), 1e-13 * magnitude);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(sum_over_ranks(sum[d]), sum_over_ranks(handed[d]), 1e-13 * magnitude);
}

TEST(SlavedPoints, HandOnTheirForcesByTheTranspose)
{
  for (const int points_per_edge : {1, 2, 4})
    expect_transpose(points_per_edge);
}

TEST(SlavedPoints, LeaveFreePointsAlone)
{
  PlateModel plate(column());
  auto &elements = plate.far->elements();
  for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    elements.position()[3 * node] += 1e-3;
  plate.far->lead();
  plate.for_each_free([&](const std::ptrdiff_t p, const Vector3 &X)
                      { EXPECT_EQ(plate.points->state().arrays.position[0][p], X[0]); });
}

TEST(NodeLinks, FetchFromTheOwnersAndAddToThem)
{
  PlateModel plate(column());
  const auto &mesh = plate.far->elements().mesh();
  int rank, n_ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  // Every rank asks for every third node of all, its own first one another: none belongs to all.
  std::vector<std::int64_t> wanted;
  for (std::int64_t node = rank % 3; node < mesh.n_global_nodes(); node += 3)
    wanted.push_back(node);
  NodeLinks links(MPI_COMM_WORLD, mesh, wanted);
  std::vector<double> values(3 * static_cast<std::size_t>(mesh.n_nodes()), 0.),
      seen(3 * wanted.size());
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    for (int d = 0; d < 3; ++d)
      values[3 * node + d] = 10. * mesh.global_node(node) + d;
  links.fetch(values, seen);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(seen[3 * i + d], 10. * wanted[i] + d);

  std::fill(values.begin(), values.end(), 1.);
  for (double &value : seen)
    value = rank + 1.;
  links.add(seen, values);
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
  {
    double expected = 1.;
    for (int r = 0; r < n_ranks; ++r)
      expected += mesh.global_node(node) % 3 == r % 3 ? r + 1. : 0.;
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(values[3 * node + d], expected);
  }
}

TEST(V1Patch, GhostForcesAreTheSameOnAllRanks)
{
  const auto ghost = [](const MPI_Comm communicator)
  {
    CoupledSample sample;
    sample.communicator = communicator;
    sample.n_cells      = {14, 12, 12};
    sample.zone         = {{5, 4, 4}, {9, 8, 8}};
    PlateModel plate(sample);
    EXPECT_EQ(plate.far->calibration().n_elements, 8 * 8 * 8 - 4 * 4 * 4);
    return plate.far->calibration();
  };
  const auto all = ghost(MPI_COMM_WORLD), one = ghost(MPI_COMM_SELF);
  EXPECT_LE(all.ghost_after, 1e-3);
  EXPECT_EQ(all.n_iterations, one.n_iterations);
  EXPECT_NEAR(all.ghost_before, one.ghost_before, 1e-12);
  EXPECT_NEAR(all.ghost_after, one.ghost_after, 1e-9);
}
} // namespace
} // namespace ricochet::tests
