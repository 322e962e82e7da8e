// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accepted_shape.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
constexpr double least_radius = 0.92, most_radius = 1.15; // the header says why [-]

/// Of a mesh of two layers with its corners on the shape, but round [m^3].
double volume_of_two_layers(const BodyOfRevolution &body)
{
  double volume   = 0.;
  const auto line = body.profile(body.shape().nose == NoseShape::sphere ? 4 : 2);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const double a = line[i][1], b = line[i + 1][1];
    volume += M_PI / 3. * (line[i + 1][0] - line[i][0]) * (a * a + a * b + b * b);
  }
  return volume;
}
} // namespace

double AcceptedShape::reach() const
{
  const auto &shape = body_.shape();
  return (shape.nose_length > 0. ? shape.nose_length : shape.diameter / 2.) / 8.;
}

double AcceptedShape::length_error() const
{
  return std::min(most_error * body_.shape().length, reach());
}

std::array<double, 2> AcceptedShape::radii(const double x) const
{
  // Compared with all radii within reach along the axis. They are smallest at the ends of that, and
  // largest where the shape is widest.
  const auto &shape   = body_.shape();
  const double place  = body_.base_position() + x;
  const double widest = shape.nose == NoseShape::sphere ? body_.base_position() + shape.length / 2.
                                                        : body_.tip_position() - shape.nose_length;
  return {least_radius * std::min(body_.radius(place - reach()), body_.radius(place + reach())),
          most_radius * body_.radius(std::clamp(widest, place - reach(), place + reach()))};
}

std::array<double, 2> AcceptedShape::volumes() const
{
  // A circle of a diameter that is just accepted has 0.884 of the area, less than the octagon.
  return {std::pow(1. - most_error, 2) * volume_of_two_layers(body_),
          std::pow(1. + most_error, 2) * body_.volume()};
}
} // namespace ricochet
