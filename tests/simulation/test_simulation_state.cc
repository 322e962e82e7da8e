// SPDX-License-Identifier: LGPL-2.1-or-later
// What frames show, on any number of ranks.
#include "support/coupled_scene.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
/// After so many steps, before the next.
PointFrame points_after(const MPI_Comm communicator, const Scene &scene, const int n_steps,
                        const FrameExtent extent = FrameExtent::everything)
{
  Simulation simulation(communicator, scene);
  for (int i = 0; i < n_steps; ++i)
  {
    simulation.compute_forces(false);
    simulation.advance();
  }
  simulation.compute_forces(false);
  return simulation.points(extent);
}

double sum_over_ranks(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

TEST(SimulationState, SectionIsOneLayerWhateverTheNumberOfLayers)
{
  for (const double width : {16e-3, 15e-3})
    for (const bool half : {false, true})
    {
      if (half && width < 16e-3)
        continue; // a half has whole layers
      Scene scene           = small_scene();
      scene.symmetric       = half;
      scene.plates[0].width = width;
      const auto points     = points_after(MPI_COMM_WORLD, scene, 0);
      double n              = 0.;
      for (std::size_t i = 0; i < points.in_section.size(); ++i)
        if (points.in_section[i])
        {
          n += 1.;
          const double y = (points.position[i] - points.displacement[i]).y();
          EXPECT_NEAR(y, width < 16e-3 ? 0. : 0.5e-3, 1e-12);
        }
      EXPECT_EQ(sum_over_ranks(n), 30. * 9.) << width << half;
    }
}

TEST(SimulationState, SectionAloneIsThatOfTheWholeFrame)
{
  for (const auto &scene :
       {relaxing(symmetric(small_scene()), HistoryPrecision::double_precision), coupled_scene()})
  {
    const auto all     = points_after(MPI_COMM_WORLD, scene, 40),
               section = points_after(MPI_COMM_WORLD, scene, 40, FrameExtent::section);
    std::size_t n      = 0; // points of the section so far
    for (std::size_t i = 0; i < all.position.size(); ++i)
      if (all.in_section[i])
      {
        ASSERT_LT(n, section.position.size());
        EXPECT_EQ(section.in_section[n], 1);
        EXPECT_EQ(section.position[n], all.position[i]);
        EXPECT_EQ(section.displacement[n], all.displacement[i]);
        EXPECT_EQ(section.velocity[n], all.velocity[i]);
        EXPECT_EQ(section.damage[n], all.damage[i]);
        EXPECT_EQ(section.body[n], all.body[i]);
        EXPECT_EQ(section.state.dilatation[n], all.state.dilatation[i]);
        EXPECT_EQ(section.state.pressure[n], all.state.pressure[i]);
        EXPECT_EQ(section.state.von_mises[n], all.state.von_mises[i]);
        EXPECT_EQ(section.state.energy_density[n], all.state.energy_density[i]);
        ++n;
      }
    EXPECT_EQ(n, section.position.size());
    EXPECT_GT(sum_over_ranks(static_cast<double>(n)), 0.);
  }
}

TEST(SimulationState, PointsFeelTheSameOnAnyNumberOfRanks)
{
  for (const auto &scene :
       {relaxing(symmetric(small_scene()), HistoryPrecision::double_precision), coupled_scene()})
  {
    const auto all   = points_after(MPI_COMM_WORLD, scene, 40),
               one   = points_after(MPI_COMM_SELF, scene, 40);
    const auto place = [](const PointFrame &frame, const std::size_t i)
    {
      const Vector3 X = (frame.position[i] - frame.displacement[i]) / 0.5e-3;
      return std::array<long, 3>{std::lround(X.x()), std::lround(X.y()), std::lround(X.z())};
    };
    std::map<std::array<long, 3>, std::size_t> number;
    for (std::size_t i = 0; i < one.position.size(); ++i)
      number[place(one, i)] = i;
    ASSERT_EQ(number.size(), one.position.size());
    EXPECT_EQ(sum_over_ranks(static_cast<double>(all.position.size())),
              static_cast<double>(one.position.size()));
    double largest = 0.;
    for (const double stress : one.state.von_mises)
      largest = std::max(largest, stress);
    EXPECT_GT(largest, 1e6); // a blow
    for (std::size_t i = 0; i < all.position.size(); ++i)
    {
      const std::size_t j = number.at(place(all, i));
      // Means of elements are summed in another order.
      EXPECT_NEAR(all.state.von_mises[i], one.state.von_mises[j], 1e-12 * largest);
      EXPECT_NEAR(all.state.pressure[i], one.state.pressure[j], 1e-12 * largest);
      EXPECT_NEAR(all.state.dilatation[i], one.state.dilatation[j], 1e-14);
      EXPECT_NEAR(all.state.energy_density[i], one.state.energy_density[j], 1e-12 * largest);
    }
  }
}

TEST(SimulationState, DilatationIsThereForLawsThatDoNotNeedIt)
{
  Scene scene                      = small_scene();
  scene.materials[0].bond_model    = "microelastic brittle";
  scene.materials[0].shear_modulus = 0.6 * scene.materials[0].bulk_modulus;
  const auto points                = points_after(MPI_COMM_WORLD, scene, 40);
  double largest = 0., pressure = 0.;
  for (std::size_t i = 0; i < points.position.size(); ++i)
  {
    largest  = std::max(largest, -points.state.dilatation[i]);
    pressure = std::max(pressure, points.state.pressure[i]);
  }
  const double bulk_modulus = scene.materials[0].bulk_modulus;
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &pressure, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  // Compressed under the nose; damage and surfaces take something of the pressure.
  EXPECT_GT(largest, 1e-3);
  EXPECT_GT(pressure, 0.3 * bulk_modulus * largest);
  EXPECT_LT(pressure, 2. * bulk_modulus * largest);
}
} // namespace
} // namespace ricochet::tests
