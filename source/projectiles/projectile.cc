// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/projectiles/projectile.h"

#include "finite_element_projectile.h"
#include "modal_projectile.h"
#include "peridynamic_projectile.h"
#include "ricochet/projectiles/projectile_mesh.h"
#include "rigid_projectile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
/// The motion at the start; where the centroid is remains open.
Projectile::Motion start_of(const ImpactParameters &impact)
{
  const double inclination = impact.incidence_angle - impact.attack_angle; // of the axis, nose down
  Projectile::Motion start;
  start.position    = Vector3::Zero();
  start.orientation = Eigen::AngleAxisd(inclination, Vector3::UnitY());
  if (impact.yaw_angle != 0.)
    start.orientation = start.orientation * Eigen::AngleAxisd(impact.yaw_angle, Vector3::UnitZ());
  start.velocity = impact.speed *
                   Vector3(std::cos(impact.incidence_angle), 0., -std::sin(impact.incidence_angle));
  start.spin = impact.spin * (start.orientation * Vector3::UnitX());
  return start;
}

/// From the centroid to the lowest point [m].
Vector3 lowest_point(const BodyOfRevolution &body, const Eigen::Quaterniond &orientation)
{
  const Vector3 axis = orientation * Vector3::UnitX();
  Vector3 down       = -(Vector3::UnitZ() - axis.z() * axis);
  down               = down.norm() > 1e-9 ? Vector3(down.normalized()) : Vector3(Vector3::Zero());
  Vector3 lowest     = Vector3::Constant(std::numeric_limits<double>::max());
  for (const auto &[x, r] : body.profile(200))
    if (const Vector3 point = x * axis + r * down; point.z() < lowest.z())
      lowest = point;
  return lowest;
}

/// Height of the lowest node above the origin of the body axes [m].
double lowest_node(const HexSolid &mesh, const Eigen::Quaterniond &orientation)
{
  double lowest = std::numeric_limits<double>::max();
  for (const auto &X : mesh.nodes)
    lowest = std::min(lowest, (orientation * X).z());
  return lowest;
}
} // namespace

void Projectile::follow_pitch()
{
  const Vector3 axis = motion().orientation * Vector3::UnitX();
  pitch_ += std::remainder(std::atan2(axis.z(), axis.x()) - pitch_, 2. * M_PI);
}

std::unique_ptr<Projectile> make_projectile(const MPI_Comm communicator, const Scene &scene,
                                            const FrictionLaw &law,
                                            const std::vector<PlateContact> &plates)
{
  const auto &impact = scene.impact;
  auto start         = start_of(impact);
  // Where the origin of the body axes, the centroid of the shape, is: the lowest point flies
  // straight to the entry point.
  start.position =
      Vector3(impact.entry_x, impact.entry_y, 0.) -
      impact.clearance / std::sin(impact.incidence_angle) * start.velocity.normalized() -
      lowest_point(BodyOfRevolution(scene.projectile.shape), start.orientation);
  if (scene.projectile.model == ProjectileModel::rigid)
    return std::make_unique<RigidProjectile>(communicator, scene, start, law, plates);

  // In the same place; farther back only if a corner of the facets, which stands out from the
  // shape, would lie in the plate.
  const HexSolid mesh = projectile_mesh(scene);
  const double buried = -lowest_node(mesh, start.orientation) - start.position.z(); // [m]
  if (buried > 0.)
    start.position -= buried / std::sin(impact.incidence_angle) * start.velocity.normalized();
  if (scene.projectile.model == ProjectileModel::peridynamic ||
      scene.projectile.model == ProjectileModel::peridynamic_nose)
    return std::make_unique<PeridynamicProjectile>(communicator, scene, mesh, start, law, plates);
  Vector3 centre = centroid(mesh);
  if (scene.symmetric)
    centre.y() = 0.;
  start.position += start.orientation * centre;
  if (scene.projectile.model == ProjectileModel::modal)
    return std::make_unique<ModalProjectile>(communicator, scene, mesh, start, law, plates);
  return std::make_unique<FiniteElementProjectile>(communicator, scene, mesh, start, law, plates);
}
} // namespace ricochet
