// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/clamped_edges.h"

#include "support/coupled_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// Largest displacement of the points and nodes that are nearer than 4 mm to an end [m].
double largest_in_frame(const Simulation &simulation)
{
  const auto &points   = *simulation.plates()[0];
  const auto &lattice  = points.lattice();
  const double length  = lattice.box().n[0] * lattice.box().spacing;
  double largest       = 0.;
  const auto is_in     = [&](const Vector3 &X) { return X.x() < 4e-3 || X.x() > length - 4e-3; };
  const auto &position = points.state().arrays.position;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 X = lattice.reference_position(lattice.coordinates(p));
        if (is_in(X))
          largest = std::max(largest,
                             (Vector3(position[0][p], position[1][p], position[2][p]) - X).norm());
      });
  if (const auto *const coupled = simulation.coupled_plate(0))
    for (int node = 0; node < coupled->elements().mesh().n_owned_nodes(); ++node)
    {
      const Vector3 X = coupled->elements().mesh().reference_position(node);
      if (is_in(X))
        largest = std::max(
            largest,
            (Vector3(Eigen::Map<const Vector3>(coupled->elements().position().data() + 3 * node)) -
             X)
                .norm());
    }
  return largest;
}

TEST(ClampedEdges, DoNotMoveAndTakeUpTheMomentum)
{
  for (const Scene &base : {small_scene(), coupled_scene()})
    for (const bool half : {false, true})
    {
      Scene scene                         = base;
      scene.symmetric                     = half;
      scene.plates[0].clamped_sides       = ClampedSides::ends;
      scene.plates[0].clamp_width         = 4e-3;
      scene.contact.shank_resistance      = 0.;
      scene.materials[0].critical_stretch = 10.; // what holds must not break
      Simulation simulation(MPI_COMM_SELF, scene);
      const auto start = simulation.momenta();
      double largest   = 0.;
      for (int step = 0; step < 150; ++step)
      {
        simulation.compute_forces(false);
        largest = std::max(largest, simulation.support_reaction().norm());
        simulation.advance();
      }
      EXPECT_LT(largest_in_frame(simulation), 1e-16) << "rounding of points that follow nodes";
      EXPECT_GT(largest, 100.) << "waves have reached the ends";
      const auto now = simulation.momenta();
      EXPECT_LT((now.linear - start.linear).norm(), 1e-12 * start.linear.norm());
      EXPECT_LT((now.angular - start.angular).norm(), 1e-11 * start.angular.norm());
    }
}

TEST(ClampedEdges, WithoutThemThePlateMoves)
{
  Simulation simulation(MPI_COMM_SELF, coupled_scene());
  for (int step = 0; step < 150; ++step)
  {
    simulation.compute_forces(false);
    simulation.advance();
  }
  EXPECT_GT(largest_in_frame(simulation), 1e-6);
  EXPECT_EQ(simulation.support_reaction().norm(), 0.);
}

TEST(ClampedEdges, HoldsWhatTheirSidesSay)
{
  // A plate thrown downwards as a whole: in the next step its frame rests, the rest flies on.
  for (const auto &[sides, ends_rest, sides_rest] : {std::tuple{ClampedSides::ends, true, false},
                                                     {ClampedSides::sides, false, true},
                                                     {ClampedSides::all, true, true}})
  {
    Scene scene                   = small_scene(); // 30 mm x 16 mm
    scene.plates[0].clamped_sides = sides;
    scene.plates[0].clamp_width   = 2e-3;
    Simulation simulation(MPI_COMM_SELF, scene);
    auto &points = *simulation.plates()[0];
    auto &a      = points.state().arrays;
    points.lattice().for_each_owned([&](const std::ptrdiff_t p) { a.velocity[2][p] = -1.; });
    simulation.compute_forces(false);
    simulation.advance();
    points.lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 X = points.lattice().reference_position(points.lattice().coordinates(p));
          const bool held = (ends_rest && (X.x() < 2e-3 || X.x() > 28e-3)) ||
                            (sides_rest && std::abs(X.y()) > 6e-3);
          EXPECT_EQ(a.velocity[2][p] == 0., held) << X.transpose();
        });
  }
}
} // namespace
} // namespace ricochet::tests
