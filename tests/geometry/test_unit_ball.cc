// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/unit_ball.h"

#include <gtest/gtest.h>

#include <vector>

namespace ricochet::tests
{
namespace
{
/// On the surface of the cube [-1, 1]^3.
std::vector<Vector3> face_points()
{
  std::vector<Vector3> points;
  for (int d = 0; d < 3; ++d)
    for (const double side : {-1., 1.})
      for (double s = -1.; s <= 1.; s += 0.25)
        for (double t = -1.; t <= 1.; t += 0.25)
        {
          Vector3 u;
          u[d]           = side;
          u[(d + 1) % 3] = s;
          u[(d + 2) % 3] = t;
          points.push_back(u);
        }
  return points;
}

TEST(UnitBall, BlocksReachFromTheBoxToTheSphere)
{
  for (const auto &u : face_points())
  {
    EXPECT_EQ(around_box(u, 0.), in_box(u)) << "blocks share the nodes of the face";
    EXPECT_NEAR(around_box(u, 1.).norm(), 1., 1e-15);
    double before = in_box(u).norm();
    for (double s = 0.125; s <= 1.; s += 0.125)
    {
      EXPECT_GT(around_box(u, s).norm(), before);
      before = around_box(u, s).norm();
    }
  }
}

TEST(UnitBall, FacesOfTheBoxBulgeInTheirMiddle)
{
  const double middle = in_box({1., 0., 0.}).x(), edge = in_box({1., 1., 0.}).x(),
               corner = in_box({1., 1., 1.}).x();
  EXPECT_GT(middle, edge);
  EXPECT_GT(edge, corner);
  EXPECT_GT(middle, inner_half_width);
  EXPECT_NEAR(edge, inner_half_width, 1e-15) << "edges of the disc's square stay where they are";
  EXPECT_EQ(in_box(Vector3::Zero()), Vector3::Zero());
}

TEST(UnitBall, SidesAreEachOthersImages)
{
  // Half and quarter meshes are cut out of it.
  for (const auto &u : face_points())
    for (const double s : {0., 0.5, 1.})
      for (int d = 0; d < 3; ++d)
      {
        Vector3 image = u, expected = around_box(u, s);
        image[d]    = -image[d];
        expected[d] = -expected[d];
        EXPECT_LT((around_box(image, s) - expected).norm(), 1e-15);
      }
}
} // namespace
} // namespace ricochet::tests
