// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simulation/element_frame.h"

#include "support/coupled_plate.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
const Vector3 shift(1e-4, -2e-4, 3e-4), speed(5., 6., 7.);

/// An expansion by 1 %.
Vector3 map(const Vector3 &X)
{
  return 1.01 * X + shift;
}

/// A plate that is moved so; its zone reaches down to the layer of the section.
PlateModel moved_plate()
{
  CoupledSample sample;
  sample.communicator = MPI_COMM_SELF;
  sample.zone         = {{5, 0, 5}, {9, 4, 9}};
  PlateModel model(sample);
  model.set_velocity([&](const Vector3 &) { return speed; });
  model.deform(map);
  return model;
}

/// Cells below row n_rows of y that are drawn as elements; all others have points.
std::size_t count_far(const Zone &zone, const int n_rows)
{
  std::size_t n_far = 0;
  for (int x = 0; x < 14; ++x)
    for (int y = 0; y < n_rows; ++y)
      for (int z = 0; z < 14; ++z)
        n_far += zone.layer({x, y, z}) >= zone.far();
  return n_far;
}

TEST(ElementFrame, ShowsTheElementsOutsideTheZoneWhereTheyAre)
{
  const PlateModel model = moved_plate();
  ElementFrame frame;
  add_elements(*model.far, /*body=*/3, FrameExtent::everything, frame);
  const std::size_t n_far = count_far(*model.zone, 14);
  ASSERT_LT(n_far, 14u * 14u * 14u);
  ASSERT_EQ(frame.corners.size(), n_far);
  ASSERT_EQ(frame.body, std::vector<int>(n_far, 3));
  for (std::size_t i = 0; i < n_far; ++i)
  {
    const Vector3 low = (frame.corners[i][0] - shift) / 1.01;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3 X =
          low + model.edge() * Vector3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
      EXPECT_LT((frame.corners[i][corner] - map(X)).norm(), 1e-15);
    }
    const Vector3 middle = low + Vector3::Constant(0.5 * model.edge());
    EXPECT_LT((frame.displacement[i] - (map(middle) - middle)).norm(), 1e-15);
    EXPECT_LT((frame.velocity[i] - speed).norm(), 1e-12);
    // E = (1.01^2 - 1)/2, tau = 1.01^2 K tr(E), W = K tr(E)^2/2.
    const double K = model.points->material().bulk_modulus, trace = 1.5 * (1.01 * 1.01 - 1.);
    EXPECT_NEAR(frame.state.dilatation[i], std::pow(1.01, 3) - 1., 1e-12);
    EXPECT_NEAR(frame.state.pressure[i], -1.01 * 1.01 * K * trace, 1e-10 * K * trace);
    EXPECT_NEAR(frame.state.von_mises[i], 0., 1e-10 * K * trace);
    EXPECT_NEAR(frame.state.energy_density[i], 0.5 * K * trace * trace, 1e-10 * K * trace * trace);
  }
}

TEST(ElementFrame, SectionFillsTheElementsInTheFirstLayerAsPointsWould)
{
  const PlateModel model = moved_plate();
  const auto &zone       = *model.zone;
  ElementFrame frame;
  add_elements(*model.far, /*body=*/3, FrameExtent::everything, frame);
  const std::size_t n_far_in_front = count_far(zone, 1);
  ASSERT_GT(n_far_in_front, 0u);
  const std::size_t n_per_cell = zone.points_per_edge() * zone.points_per_edge();
  ASSERT_EQ(frame.section_position.size(), n_far_in_front * n_per_cell);
  ASSERT_EQ(frame.section_body.size(), frame.section_position.size());
  ASSERT_EQ(frame.section_element.size(), frame.section_position.size());
  for (std::size_t i = 0; i < frame.section_position.size(); ++i)
  {
    // A place lies in its element.
    const auto &corners = frame.corners[frame.section_element[i]];
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_GT(frame.section_position[i][d], corners[0][d]);
      EXPECT_LT(frame.section_position[i][d], corners[7][d]);
    }
  }
  for (const auto &x : frame.section_position)
  {
    const Vector3 place = (x - shift) / 1.01 / model.spacing - Vector3::Constant(0.5);
    EXPECT_NEAR(place.y(), 0., 1e-9);
    EXPECT_NEAR(place.x(), std::round(place.x()), 1e-9);
    EXPECT_NEAR(place.z(), std::round(place.z()), 1e-9);
  }
}

TEST(ElementFrame, OfTheSectionHoldsTheElementsThatItCuts)
{
  const PlateModel model = moved_plate();
  ElementFrame all, section;
  add_elements(*model.far, /*body=*/3, FrameExtent::everything, all);
  add_elements(*model.far, /*body=*/3, FrameExtent::section, section);
  ASSERT_EQ(section.corners.size(), count_far(*model.zone, 1));
  EXPECT_EQ(section.body, std::vector<int>(section.corners.size(), 3));
  EXPECT_EQ(section.section_position, all.section_position);
  EXPECT_EQ(section.section_body, all.section_body);
  ASSERT_EQ(section.section_element.size(), all.section_element.size());
  for (std::size_t i = 0; i < section.section_element.size(); ++i)
  {
    const int one = section.section_element[i], other = all.section_element[i];
    EXPECT_EQ(section.corners[one], all.corners[other]);
    EXPECT_EQ(section.state.pressure[one], all.state.pressure[other]);
  }
}
} // namespace
} // namespace ricochet::tests
