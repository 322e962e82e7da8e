// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh.h"

#include "ricochet/base/units.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/finite_elements/hexahedral_body.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/projectiles/projectile_mesh.h"
#include "ricochet/scene/mesh_file.h"
#include "ricochet/scene/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace ricochet
{
namespace
{
using namespace units;

/// Smallest and mean scaled Jacobian of all cells.
std::pair<double, double> quality_of(const HexSolid &solid)
{
  double worst = 1., mean = 0.;
  for (int cell = 0; cell < static_cast<int>(solid.cells.size()); ++cell)
  {
    const double quality = scaled_jacobian(solid, cell);
    worst                = std::min(worst, quality);
    mean += quality / static_cast<double>(solid.cells.size());
  }
  return {worst, mean};
}

/// The part of the projectile that the mesh is.
double share_of(const HexSolid &solid)
{
  return is_half(solid) ? 0.5 : 1.;
}

void print_stable_step(const HexSolid &solid, const ProjectileParameters &projectile)
{
  // Steel, if the scene says nothing else.
  const bool is_given  = projectile.youngs_modulus > 0.;
  const double E       = is_given ? projectile.youngs_modulus : 202. * GPa;
  const double nu      = is_given ? projectile.poissons_ratio : 0.3;
  const double density = share_of(solid) * projectile.mass / volume(solid);
  HexahedralBody elastic(solid, {density, E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu))},
                         /*mirrored=*/is_half(solid));
  const double step = 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, elastic).squared_frequency);
  std::printf("stable step    %.4f us (E %.4g GPa, nu %.3f, %.0f kg/m3)\n", step / us, E / GPa, nu,
              density);
}

void print_mesh(const HexSolid &solid, const BodyOfRevolution &body)
{
  const auto [worst, mean] = quality_of(solid);
  std::printf("mesh           %zu hexahedra, %zu nodes, %zu faces on the surface\n",
              solid.cells.size(), solid.nodes.size(), surface_of(solid).size());
  std::printf("scaled Jacobian  smallest %.3f, mean %.3f (limit %.2f)\n", worst, mean,
              smallest_scaled_jacobian);
  std::printf("volume         %.2f mm3, %+.2f %% against the %s\n", volume(solid) / (mm * mm * mm),
              100. * (volume(solid) / (share_of(solid) * body.volume()) - 1.),
              is_half(solid) ? "half of the shape that it is" : "shape");
  std::printf("smallest edge  %.3f mm\n", smallest_edge(solid) / mm);
}
} // namespace

void mesh_projectile(const MPI_Comm communicator, const ParameterFile &file,
                     const MeshOptions &options)
{
  const Scene scene = read_scene(file);
  const BodyOfRevolution body(scene.projectile.shape);
  const HexSolid solid = given_mesh(scene);
  on_first_rank(communicator,
                [&]
                {
                  print_mesh(solid, body);
                  print_stable_step(solid, scene.projectile);
                  if (options.write.empty())
                    return;
                  std::ostringstream text;
                  write_mesh(solid, body, mm, text);
                  write_file(options.write, text.str());
                  std::printf("written        %s (gmsh 2.2, mm)\n", options.write.c_str());
                });
}
} // namespace ricochet
