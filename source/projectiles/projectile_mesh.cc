// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/projectiles/projectile_mesh.h"

#include "mesh_fit.h"
#include "ricochet/geometry/revolved_hexes.h"

#include <algorithm>

namespace ricochet
{
HexSolid given_mesh(const Scene &scene)
{
  const auto &projectile = scene.projectile;
  const BodyOfRevolution body(projectile.shape);
  return projectile.mesh.cells.empty() ? revolved_hexes(body, projectile.refinement)
                                       : fitted(projectile.mesh, body, scene.symmetric);
}

HexSolid projectile_mesh(const Scene &scene)
{
  const HexSolid given = given_mesh(scene);
  return scene.symmetric && !is_half(given)
             ? upper_half(given, 1e-6 * scene.projectile.shape.diameter)
             : given;
}

bool is_half(const HexSolid &mesh)
{
  return std::all_of(mesh.nodes.begin(), mesh.nodes.end(),
                     [](const Vector3 &x) { return x.y() >= 0.; });
}
} // namespace ricochet
