// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/units.h"
#include "sections.h"

#include <cmath>

namespace ricochet
{
namespace
{
void check_angles(const ImpactParameters &impact, const Entry &incidence, const Entry &attack,
                  const Entry &yaw)
{
  constexpr double right_angle = 90. * units::deg * (1. + 1e-12);
  if (impact.incidence_angle > right_angle)
    incidence.fail("The angle to the plate's surface is at most 90 deg.",
                   "90 deg is a shot straight down, 10 deg a grazing one.");
  if (std::abs(impact.attack_angle) >= 90. * units::deg)
    attack.fail("The projectile would fly sideways or backwards.",
                "Choose an angle between -90 deg and 90 deg.");
  if (std::abs(impact.yaw_angle) >= 90. * units::deg)
    yaw.fail("The projectile would fly sideways or backwards.",
             "Choose an angle between -90 deg and 90 deg.");
}

/// What the mirror image would not do.
void check_symmetry(const Scene &scene, const double value, const Entry &entry)
{
  if (scene.symmetric && value != 0.)
    entry.fail("A symmetric model can neither yaw nor spin.",
               "Compute the whole plate with 'set Symmetric = false', or leave this entry out.");
}

void check_entry_point(const ImpactParameters &impact, const Scene &scene, const Entry &point)
{
  const PlateParameters &plate = scene.plates.front();
  if (impact.entry_x < 0. || impact.entry_x > plate.length ||
      std::abs(impact.entry_y) > plate.width / 2.)
    point.fail("The point is not on the first plate.",
               "x lies between 0 mm and " + in_mm(plate.length) + ", y between -" +
                   in_mm(plate.width / 2.) + " and " + in_mm(plate.width / 2.) + ".");
  if (scene.symmetric && impact.entry_y != 0.)
    point.fail("A symmetric model needs an entry point with y = 0 mm.",
               "Set y to 0 mm, or compute the whole plate with 'set Symmetric = false'.");
}
} // namespace

Section impact_section(ImpactParameters &impact, const unsigned int number, const Scene &scene)
{
  Section in(number == 1 ? "Impact" : "Impact " + std::to_string(number),
             number == 1 ? "How the projectile arrives."
                         : "How projectile " + std::to_string(number) + " arrives.");
  in.required("Speed", quantity(impact.speed, Dimension::speed, Limit::positive), "720 m/s",
              "Speed of the projectile before the impact");
  const Entry &incidence = in.required(
      "Incidence angle", quantity(impact.incidence_angle, Dimension::angle, Limit::positive),
      "30 deg", "Angle between the velocity and the plate's surface, at most 90 deg");
  const Entry &attack = in.with_default(
      "Attack angle", quantity(impact.attack_angle, Dimension::angle, Limit::any), "0 deg",
      "Angle between the projectile's axis and its velocity, nose up positive");
  const Entry &yaw = in.with_default(
      "Yaw angle", quantity(impact.yaw_angle, Dimension::angle, Limit::any), "0 deg",
      "Angle of the projectile's axis out of the plane of flight, towards +y positive; needs the "
      "full model");
  const Entry &spin = in.with_default(
      "Spin", quantity(impact.spin, Dimension::angular_velocity, Limit::any), "0 rad/s",
      "Angular velocity about the projectile's axis, right-handed seen along the flight positive; "
      "needs the full model");
  const Entry &point = in.required(
      "Entry point",
      quantities({&impact.entry_x, &impact.entry_y}, {"x", "y"}, Dimension::length, Limit::any),
      "50 mm, 0 mm",
      "Where the projectile touches the plate first, from the near edge and from the mid-plane");
  in.with_default("Clearance", quantity(impact.clearance, Dimension::length, Limit::not_negative),
                  "0.05 mm",
                  "Distance between the projectile's lowest point and the plate at the start");

  in.check([&] { check_angles(impact, incidence, attack, yaw); });
  in.check_with_others([&] { check_entry_point(impact, scene, point); });
  in.check_with_others([&] { check_symmetry(scene, impact.yaw_angle, yaw); });
  in.check_with_others([&] { check_symmetry(scene, impact.spin, spin); });
  return in;
}
} // namespace ricochet
