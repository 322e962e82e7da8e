// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/geometry/body_of_revolution.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::tests
{
namespace
{
using Shape = BodyOfRevolution::Shape;

struct Sample
{
  const char *name;
  Shape shape;
};

void PrintTo(const Sample &sample, std::ostream *out)
{
  *out << sample.name;
}

// A slender ogive (CRH 3), the bluntest ogive allowed, and everything else in the sizes of a rifle
// core.
const std::vector<Sample> samples{
    {"Ogive", {NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3}},
    {"OgiveWithoutShank", {NoseShape::ogive, 6e-3, 10e-3, 10e-3}},
    {"BluntOgive", {NoseShape::ogive, 8e-3, 12e-3, 4e-3}},
    {"Cone", {NoseShape::cone, 6e-3, 20e-3, 9e-3}},
    {"ConeWithoutShank", {NoseShape::cone, 6e-3, 4e-3, 4e-3}},
    {"Hemisphere", {NoseShape::hemisphere, 6e-3, 15e-3, 0.}},
    {"Flat", {NoseShape::flat, 6e-3, 15e-3, 0.}},
    {"Sphere", {NoseShape::sphere, 6e-3, 0., 0.}},
};

/// Radius at x from the base, straight from the definition of the shape; negative outside.
double radius(const Shape &s, const double x)
{
  const double R = s.diameter / 2., length = s.nose == NoseShape::sphere ? s.diameter : s.length;
  const double nose = s.nose == NoseShape::hemisphere ? R
                      : s.nose == NoseShape::flat     ? 0.
                                                      : s.nose_length;
  if (x < 0. || x > length)
    return -1.;
  if (s.nose == NoseShape::sphere)
    return std::sqrt(std::max(0., R * R - (x - R) * (x - R)));
  const double behind_tip = length - x;
  if (behind_tip >= nose)
    return R;
  if (s.nose == NoseShape::cone)
    return R * behind_tip / nose;
  // Tangent ogive: an arc of radius rho = (R^2 + l^2)/(2R) that leaves the shank without a kink.
  const double rho = (R * R + nose * nose) / (2. * R), from_shoulder = nose - behind_tip;
  return std::max(0., std::sqrt(rho * rho - from_shoulder * from_shoulder) - (rho - R));
}

class Body : public testing::TestWithParam<Sample>
{
};

INSTANTIATE_TEST_SUITE_P(Shapes, Body, testing::ValuesIn(samples),
                         [](const auto &info) { return info.param.name; });

TEST_P(Body, SignedDistanceIsThatOfADenseSampling)
{
  const Shape &s = GetParam().shape;
  const BodyOfRevolution body(s);
  const double length = body.tip_position() - body.base_position();
  const int n         = 40000;
  std::vector<std::array<double, 2>> line; // the generating line, from the base's centre
  for (int i = 0; i <= 2000; ++i)
    line.push_back({0., radius(s, 0.) * i / 2000});
  for (int i = 0; i <= n; ++i)
  {
    // Denser at both ends, where a circle is steep.
    const double x = 0.5 * length * (1. - std::cos(M_PI * i / n));
    line.push_back({x, radius(s, x)});
  }
  for (int i = 0; i <= 2000; ++i)
    line.push_back({length, radius(s, length) * i / 2000});
  if (s.nose == NoseShape::cone)
    line.push_back(
        {length - s.nose_length, s.diameter / 2.}); // a corner, which must not lie between samples

  Random random(17);
  int n_inside = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    const Vector3 point(0.7 * length * random.uniform(), 0.8 * s.diameter * random.uniform(),
                        0.8 * s.diameter * random.uniform());
    const double x = point.x() - body.base_position(), r = std::hypot(point.y(), point.z());
    double nearest = std::numeric_limits<double>::max();
    for (const auto &[xs, rs] : line)
      nearest = std::min(nearest, std::hypot(x - xs, r - rs));
    const bool inside = r <= radius(s, x);
    n_inside += inside;
    const auto hit = body.hit(point);
    // Samples lie 3 um apart or less: beside a line at the distance h the error is (1.5 um)^2/(2h).
    EXPECT_NEAR(hit.distance, inside ? -nearest : nearest, std::min(2e-6, 2e-12 / nearest + 1e-9))
        << point.transpose();
  }
  EXPECT_GT(n_inside, 20);
  EXPECT_LT(n_inside, 280);
}

TEST_P(Body, NormalIsTheGradientOfTheDistance)
{
  const BodyOfRevolution body(GetParam().shape);
  Random random(19);
  const double h = 1e-8; // metres; truncation h/R, rounding 1e-16 * 1e-2/1e-8
  int n_tested   = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    const Vector3 point(20e-3 * random.uniform(), 6e-3 * random.uniform(), 6e-3 * random.uniform());
    const auto hit = body.hit(point);
    EXPECT_NEAR(hit.normal.norm(), 1., 1e-12);
    Vector3 gradient;
    bool smooth = true;
    for (int d = 0; d < 3; ++d)
    {
      const auto above = body.hit(point + h * Vector3::Unit(d)),
                 below = body.hit(point - h * Vector3::Unit(d));
      gradient[d]      = (above.distance - below.distance) / (2. * h);
      smooth           = smooth && above.surface == hit.surface && below.surface == hit.surface;
    }
    // On the medial axis the distance has a kink: there only its neighbours have a gradient.
    if (!smooth || std::abs(gradient.norm() - 1.) > 1e-3)
      continue;
    EXPECT_LT((gradient - hit.normal).norm(), 1e-5) << point.transpose();
    ++n_tested;
  }
  EXPECT_GT(n_tested, 290);
}

TEST_P(Body, SurfacePointHasDistanceZeroAndAnOutwardNormal)
{
  const Shape &s = GetParam().shape;
  const BodyOfRevolution body(s);
  const double length = body.tip_position() - body.base_position();
  for (const double share : {0.05, 0.3, 0.5, 0.8, 0.95})
  {
    const double x = share * length, r = radius(s, x);
    const Vector3 point(x + body.base_position(), 0.6 * r, -0.8 * r);
    EXPECT_NEAR(body.hit(point).distance, 0., 1e-12 * s.diameter);
    const Vector3 n = body.hit(point).normal;
    // A little outwards is outside, by as much.
    EXPECT_NEAR(body.hit(point + 1e-6 * n).distance, 1e-6, 1e-10);
    EXPECT_NEAR(body.hit(point - 1e-6 * n).distance, -1e-6, 1e-10);
    EXPECT_EQ(body.hit(point).surface, r < 0.4999 * s.diameter || s.nose == NoseShape::sphere
                                           ? BodyOfRevolution::Surface::nose
                                           : BodyOfRevolution::Surface::shank);
  }
}

TEST_P(Body, CentresOfCurvatureAndAxisAreInside)
{
  const Shape &s = GetParam().shape;
  const BodyOfRevolution body(s);
  const double length = body.tip_position() - body.base_position();
  for (int i = 1; i < 20; ++i)
  {
    const auto hit = body.hit({body.base_position() + length * i / 20., 0., 0.});
    EXPECT_LT(hit.distance, 0.);
    EXPECT_NEAR(hit.normal.norm(), 1., 1e-12);
  }
  // The centre of a hemisphere is as far from everywhere.
  const Vector3 centre(body.tip_position() - s.diameter / 2., 0., 0.);
  if (s.nose == NoseShape::hemisphere || s.nose == NoseShape::sphere)
  {
    EXPECT_NEAR(body.hit(centre).distance, -s.diameter / 2., 1e-15);
  }
}

TEST_P(Body, VolumeCentroidAndInertiaAreThoseOfASampling)
{
  // Midpoint rule over slices, independent of the library's quadrature.
  const Shape &s = GetParam().shape;
  const BodyOfRevolution body(s);
  const double length = body.tip_position() - body.base_position();
  double V = 0., first = 0., second = 0., fourth = 0.;
  const int n = 200000;
  for (int i = 0; i < n; ++i)
  {
    const double x = (i + 0.5) * length / n, r2 = std::pow(radius(s, x), 2), w = M_PI * length / n;
    V += w * r2;
    first += w * r2 * x;
    second += w * r2 * x * x;
    fourth += w * r2 * r2;
  }
  const double c = first / V;
  EXPECT_NEAR(body.volume() / V, 1., 1e-6);
  EXPECT_NEAR(-body.base_position() / c, 1., 1e-6);
  EXPECT_NEAR(body.gyration_squared()[0] / (fourth / V / 2.), 1., 1e-6);
  EXPECT_NEAR(body.gyration_squared()[1] / (fourth / V / 4. + second / V - c * c), 1., 1e-6);
}

TEST_P(Body, RadiusIsThatOfTheDefinitionAndZeroOutside)
{
  const BodyOfRevolution body(GetParam().shape);
  const double length = body.tip_position() - body.base_position();
  for (int i = 1; i < 200; ++i)
  {
    const double x = length * i / 200.;
    EXPECT_NEAR(body.radius(body.base_position() + x), radius(GetParam().shape, x), 1e-12);
  }
  EXPECT_EQ(body.radius(body.base_position() - 1e-6), 0.);
  EXPECT_EQ(body.radius(body.tip_position() + 1e-6), 0.);
}

TEST_P(Body, ProfileRunsAlongTheSurfaceFromTheBaseToTheTip)
{
  const BodyOfRevolution body(GetParam().shape);
  const auto line = body.profile(40);
  EXPECT_NEAR(line.front()[0], body.base_position(), 1e-12);
  EXPECT_EQ(line.front()[1], 0.);
  EXPECT_NEAR(line.back()[0], body.tip_position(), 1e-12);
  EXPECT_EQ(line.back()[1], 0.);
  double widest = 0.;
  for (const auto &[x, r] : line)
  {
    EXPECT_NEAR(body.hit({x, 0., r}).distance, 0., 1e-9 * 1e-3);
    widest = std::max(widest, r);
  }
  EXPECT_NEAR(widest, GetParam().shape.diameter / 2., 1e-12);
}

TEST(BodyOfRevolution, CylinderHasItsClosedForm)
{
  const double R = 3e-3, L = 15e-3;
  const BodyOfRevolution body({NoseShape::flat, 2. * R, L, 0.});
  EXPECT_NEAR(body.volume() / (M_PI * R * R * L), 1., 1e-12);
  EXPECT_NEAR(body.tip_position(), L / 2., 1e-15);
  EXPECT_NEAR(body.gyration_squared()[0] / (R * R / 2.), 1., 1e-12);
  EXPECT_NEAR(body.gyration_squared()[1] / (R * R / 4. + L * L / 12.), 1., 1e-12);
}

TEST(BodyOfRevolution, ConeHasItsClosedForm)
{
  const double R = 3e-3, H = 8e-3;
  const BodyOfRevolution body({NoseShape::cone, 2. * R, H, H});
  EXPECT_NEAR(body.volume() / (M_PI * R * R * H / 3.), 1., 1e-12);
  EXPECT_NEAR(-body.base_position() / (H / 4.), 1., 1e-12);
  EXPECT_NEAR(body.gyration_squared()[0] / (0.3 * R * R), 1.,
              1e-10); // Simpson's rule on a fourth power
  EXPECT_NEAR(body.gyration_squared()[1] / (0.15 * R * R + 3. / 80. * H * H), 1., 1e-10);
}

TEST(BodyOfRevolution, HemisphereHasItsClosedForm)
{
  const double R = 4e-3;
  const BodyOfRevolution body({NoseShape::hemisphere, 2. * R, R, 0.});
  EXPECT_NEAR(body.volume() / (2. / 3. * M_PI * R * R * R), 1., 1e-12);
  EXPECT_NEAR(-body.base_position() / (3. / 8. * R), 1., 1e-12);
  EXPECT_NEAR(body.gyration_squared()[0] / (0.4 * R * R), 1., 1e-10);
  EXPECT_NEAR(body.gyration_squared()[1] / (83. / 320. * R * R), 1., 1e-10);
}

TEST(BodyOfRevolution, SphereNeedsItsDiameterOnlyAndHasItsClosedForm)
{
  const double R = 5e-3;
  const BodyOfRevolution body({NoseShape::sphere, 2. * R, 123., 456.});
  EXPECT_EQ(body.shape().length, 2. * R);
  EXPECT_NEAR(body.volume() / (4. / 3. * M_PI * R * R * R), 1., 1e-12);
  EXPECT_NEAR(body.tip_position(), R, 1e-15);
  EXPECT_NEAR(body.gyration_squared()[0] / (0.4 * R * R), 1., 1e-10);
  EXPECT_NEAR(body.gyration_squared()[1] / (0.4 * R * R), 1., 1e-10);
  const auto hit = body.hit({0., 7e-3, 0.});
  EXPECT_NEAR(hit.distance, 2e-3, 1e-17);
  EXPECT_EQ(hit.normal, Vector3(0., 1., 0.));
  EXPECT_EQ(hit.surface, BodyOfRevolution::Surface::nose);
}

TEST(BodyOfRevolution, SteelCoreWeighsWhatTheTheoryNoteSays)
{
  // d 6.17 mm, L 27.6 mm, tangent ogive CRH 3 with l = d sqrt(CRH - 1/4) = 10.23 mm: 5.39 g at 7850
  // kg/m^3 (design note on theory and data, section 1.3, numerical integration).
  EXPECT_NEAR(6.17 * std::sqrt(2.75), 10.23, 0.005);
  const BodyOfRevolution body({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});
  EXPECT_NEAR(7850. * body.volume(), 5.39e-3, 0.005e-3);
}

TEST(BodyOfRevolution, ImpossibleShapesAreRefused)
{
  for (const Shape &shape :
       {Shape{NoseShape::flat, 0., 1e-2, 0.}, Shape{NoseShape::flat, 1e-2, -1e-2, 0.},
        Shape{NoseShape::ogive, 6e-3, 1e-2, 1.1e-2}, Shape{NoseShape::ogive, 6e-3, 1e-2, 2e-3},
        Shape{NoseShape::cone, 6e-3, 1e-2, 0.}, Shape{NoseShape::hemisphere, 6e-3, 2e-3, 0.},
        Shape{NoseShape::sphere, 0., 0., 0.}})
    EXPECT_THROW(BodyOfRevolution{shape}, InputError);
}
} // namespace
} // namespace ricochet::tests
