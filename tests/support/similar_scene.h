// SPDX-License-Identifier: LGPL-2.1-or-later
// The same impact with other units of length, speed and density.
#pragma once

#include "support/small_scene.h"

#include <map>
#include <string>

namespace ricochet::tests
{
/// Units of one scene in those of another.
struct Scale
{
  double length = 1., speed = 1., density = 1.;

  double time() const { return length / speed; }
  double stress() const { return density * speed * speed; }
  double mass() const { return density * length * length * length; }
  double force() const { return stress() * length * length; }
  double energy() const { return force() * length; }

  /// Of a column of the history, by its unit.
  double of(const std::string &unit) const
  {
    const std::map<std::string, double> units{
        {"us", time()},  {"mm", length},         {"m/s", speed},  {"deg", 1.},
        {"kN", force()}, {"rad/s", 1. / time()}, {"J", energy()}, {"-", 1.}};
    return units.at(unit);
  }
};

inline void scale_plate(PlateParameters &plate, const double length)
{
  for (const auto member :
       {&PlateParameters::length, &PlateParameters::width, &PlateParameters::thickness,
        &PlateParameters::gap, &PlateParameters::spacing})
    plate.*member *= length;
  for (auto &box : plate.zone_boxes)
    for (double &x : box)
      x *= length;
}

inline void scale_material(MaterialParameters &material, const Scale &scale)
{
  material.density *= scale.density;
  material.bulk_modulus *= scale.stress();
  material.shear_modulus *= scale.stress();
  material.energy_release *= scale.stress() * scale.length;
  for (auto &branch : material.relaxation)
    branch.time *= scale.time();
}

inline void scale_shot(ProjectileParameters &projectile, ImpactParameters &impact,
                       const Scale &scale)
{
  auto &shape = projectile.shape;
  for (double *const length :
       {&shape.diameter, &shape.length, &shape.nose_length, &projectile.spacing,
        &projectile.peridynamic_length, &impact.entry_x, &impact.entry_y, &impact.clearance})
    *length *= scale.length;
  projectile.mass *= scale.mass();
  projectile.youngs_modulus *= scale.stress();
  impact.speed *= scale.speed;
}

/// Results are to be the same, in the units of `scale`; with powers of two, of four for the
/// density, to the last bit.
inline Scene similar(Scene scene, const Scale &scale)
{
  scale_shot(scene.projectile, scene.impact, scale);
  for (auto &shot : scene.further_shots)
    scale_shot(shot.projectile, shot.impact, scale);
  for (auto &plate : scene.plates)
  {
    scale_plate(plate, scale.length);
    plate.joint_tension *= scale.stress();
    plate.joint_shear *= scale.stress();
  }
  for (auto &material : scene.materials)
    scale_material(material, scale);
  auto friction = std::get<ExponentialFriction::Parameters>(scene.contact.friction);
  friction.decay /= scale.speed;
  scene.contact.friction = friction;
  scene.contact.regularisation_speed *= scale.speed;
  scene.contact.shank_resistance *= scale.stress();
  scene.time.end_time *= scale.time();
  scene.time.free_time *= scale.time();
  return scene;
}
} // namespace ricochet::tests
