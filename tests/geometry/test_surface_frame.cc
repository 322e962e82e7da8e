// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/surface_frame.h"

#include <gtest/gtest.h>

namespace ricochet
{
namespace
{
SurfaceFrame square_at(const double x)
{
  SurfaceFrame frame;
  frame.vertices = {{x, 0., 0.}, {x, 1., 0.}, {x, 1., 1.}, {x, 0., 1.}};
  frame.quads    = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  frame.outline  = {{x, 0., 0.}, {x, 0., 1.}};
  return frame;
}

TEST(SurfaceFrame, OfSeveralTellsThemApart)
{
  SurfaceFrame all = square_at(1.);
  EXPECT_TRUE(all.body.empty());
  all.add(square_at(2.));
  all.add(square_at(3.));
  EXPECT_EQ(all.body, (std::vector<int>{0, 0, -1, -1, -2, -2}));
  ASSERT_EQ(all.quads.size(), 6u);
  for (std::size_t quad = 0; quad < all.quads.size(); ++quad)
    for (const int vertex : all.quads[quad])
      EXPECT_EQ(all.vertices[vertex].x(), 1. - all.body[quad]);
  ASSERT_EQ(all.further_outlines.size(), 2u);
  EXPECT_EQ(all.outline[0].x(), 1.);
  EXPECT_EQ(all.further_outlines[1][0].x(), 3.);
}
} // namespace
} // namespace ricochet
