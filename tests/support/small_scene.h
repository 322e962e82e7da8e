// SPDX-License-Identifier: LGPL-2.1-or-later
// An impact of a few thousand points that breaks bonds, throws debris and takes a second.
#pragma once

#include "ricochet/base/units.h"
#include "ricochet/simulation/simulation.h"

#include <ostream>

namespace ricochet::tests
{
inline Scene small_scene()
{
  using namespace units;
  Scene scene{};
  scene.title      = "small oblique impact";
  scene.symmetric  = false;
  scene.projectile = {{NoseShape::ogive, 4. * mm, 10. * mm, 5. * mm}, 0.8 * g};
  scene.impact     = {300., 30. * deg, 0., 8. * mm, 0., 0.1 * mm};
  scene.plates = {{30. * mm, 16. * mm, 9. * mm, 0., 1. * mm, 3., InfluenceFunction::cone, "plate"}};
  // PMMA at high rate; the critical stretch is round and low, so that much of the plate breaks.
  scene.materials = {
      {"plate", "linear peridynamic solid", 1190., 5.9 * GPa, 2.258 * GPa, 0.01, 0.}};
  scene.contact.stiffness_factor       = 1.;
  scene.contact.friction               = ExponentialFriction::Parameters{0.3, 0.05, 0.01};
  scene.contact.regularisation_speed   = 5.;
  scene.contact.shank_resistance       = 100. * MPa;
  scene.contact.shank_contact_fraction = 0.1;
  scene.contact.debris_factor          = 1.;
  scene.time                           = {1000. * us, 0.8, true, 10. * us};
  scene.output                         = {"", 0., 1. * us, false, false};
  return scene;
}

inline Scene two_plates()
{
  Scene scene               = small_scene();
  scene.plates[0].thickness = 4e-3;
  scene.plates.push_back(scene.plates[0]);
  scene.plates[1].gap = 0.;
  return scene;
}

/// With plates joined to each other, more weakly than they hold together themselves (63 MPa).
inline Scene joined(Scene scene)
{
  for (std::size_t i = 1; i < scene.plates.size(); ++i)
    scene.plates[i].joint_tension = 30e6;
  return scene;
}

/// The same projectile of finite elements, coarse.
inline Scene deformable(Scene scene)
{
  scene.projectile.model          = ProjectileModel::finite_elements;
  scene.projectile.youngs_modulus = 202e9;
  scene.projectile.poissons_ratio = 0.3;
  scene.projectile.refinement     = 1;
  return scene;
}

/// The same with as many modes as cost no time step.
inline Scene modal(Scene scene)
{
  scene                  = deformable(scene);
  scene.projectile.model = ProjectileModel::modal;
  return scene;
}

/// The same of peridynamic points.
inline Scene peridynamic(Scene scene)
{
  scene.projectile.model          = ProjectileModel::peridynamic;
  scene.projectile.youngs_modulus = 202e9;
  scene.projectile.poissons_ratio = 0.3;
  scene.projectile.spacing        = 0.5e-3;
  scene.projectile.refinement     = 1;
  return scene;
}

/// The same of points in the nose and elements behind.
inline Scene peridynamic_nose(Scene scene)
{
  scene                               = peridynamic(scene);
  scene.projectile.model              = ProjectileModel::peridynamic_nose;
  scene.projectile.peridynamic_length = scene.projectile.shape.nose_length;
  return scene;
}

inline const char *model_name(const Scene &scene)
{
  switch (scene.projectile.model)
  {
    case ProjectileModel::rigid:
      return "Rigid";
    case ProjectileModel::modal:
      return "Modes";
    case ProjectileModel::finite_elements:
      return "Elements";
    case ProjectileModel::peridynamic_nose:
      return "Nose";
    case ProjectileModel::peridynamic:
      return "Points";
  }
  return "";
}

/// With branches that relax during the few tens of microseconds of such a scene.
inline Scene relaxing(Scene scene, const HistoryPrecision precision)
{
  scene.materials[0].relaxation        = {{0.146, 15.3}, {0.3, 20e-6}, {0.241, 2e-6}};
  scene.materials[0].history_precision = precision;
  return scene;
}

inline Scene symmetric(Scene scene)
{
  scene.symmetric = true;
  return scene;
}
} // namespace ricochet::tests

namespace ricochet
{
/// How GoogleTest shows a scene.
inline void PrintTo(const Scene &scene, std::ostream *out)
{
  *out << (scene.symmetric ? "half model of " : "full model of ") << scene.plates.size()
       << (scene.materials[0].relaxation.empty() ? " plates" : " relaxing plates");
}
} // namespace ricochet
