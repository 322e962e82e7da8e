// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/revolved_nose.h"
#include "geometry/unit_ball.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
struct Sample
{
  BodyOfRevolution::Shape shape;
  double length; // of the nose [m]
};

const Sample samples[] = {{{NoseShape::ogive, 8e-3, 30e-3, 12e-3}, 12e-3},
                          {{NoseShape::cone, 8e-3, 30e-3, 10e-3}, 10e-3},
                          {{NoseShape::hemisphere, 8e-3, 30e-3, 4e-3}, 4e-3}};
constexpr double widen = 1.01;
constexpr int n        = 8;

TEST(RevolvedNose, ReachesFromTheShoulderToTheTip)
{
  for (const auto &sample : samples)
  {
    const BodyOfRevolution body(sample.shape);
    const RevolvedNose nose(body, sample.length, n, widen);
    const double radius = sample.shape.diameter / 2.;
    EXPECT_NEAR(nose.shoulder(), body.tip_position() - sample.length, 1e-15);
    EXPECT_LT((nose.place({1., 0., 0.}) - Vector3(body.tip_position(), 0., 0.)).norm(), 1e-15);
    EXPECT_EQ(nose.place(Vector3::Zero()), Vector3(nose.shoulder(), 0., 0.));
    // The base is the shank's widened circle.
    for (double angle = 0.; angle < 6.; angle += 0.5)
    {
      const Vector3 x = nose.place({0., std::cos(angle), std::sin(angle)});
      EXPECT_NEAR(x.x(), nose.shoulder(), 1e-15);
      EXPECT_NEAR(std::hypot(x.y(), x.z()), widen * radius, 1e-12 * radius);
      EXPECT_NEAR(std::atan2(x.z(), x.y()), std::remainder(angle, 2. * M_PI), 1e-12);
    }
  }
}

TEST(RevolvedNose, FacetsLieAsFarOutsideTheShapeAsInside)
{
  // With nodes on the surface the facets' middles would all lie inside.
  for (const auto &sample : samples)
  {
    const BodyOfRevolution body(sample.shape);
    const RevolvedNose nose(body, sample.length, n, widen);
    const auto on_side = [&](const int i, const int j) {
      return nose.place(around_box({double(i) / n, 1., 2. * j / n - 1.}, 1.));
    };
    double inside = 0., outside = 0.;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
      {
        EXPECT_GT(body.hit(on_side(i, j)).distance, 0.) << "nodes lie outside";
        const Vector3 middle =
            0.25 * (on_side(i, j) + on_side(i + 1, j) + on_side(i, j + 1) + on_side(i + 1, j + 1));
        const double distance = body.hit(middle).distance;
        (distance > 0. ? outside : inside) += std::abs(distance);
      }
    EXPECT_GT(inside, 0.);
    EXPECT_LT(inside + outside, 0.02 * n * n * sample.shape.diameter);
  }
}
} // namespace
} // namespace ricochet::tests
