// SPDX-License-Identifier: LGPL-2.1-or-later
#include "finite_element_projectile.h"

#include "ricochet/dynamics/largest_frequency.h"
#include "skin.h"

#include <algorithm>

namespace ricochet
{
FiniteElementMaterial elastic_material(const Scene &scene, const HexSolid &mesh)
{
  const auto &p  = scene.projectile;
  const double E = p.youngs_modulus, nu = p.poissons_ratio;
  const double own = scene.symmetric ? p.mass / 2. : p.mass;
  return {own / volume(mesh), E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu))};
}

FiniteElementProjectile::FiniteElementProjectile(const MPI_Comm communicator, const Scene &scene,
                                                 const HexSolid &mesh, const Motion &start,
                                                 const FrictionLaw &law,
                                                 const std::vector<PlateContact> &plates) :
  DeformableProjectile(communicator, scene, mesh.nodes, outer_faces(mesh, scene.symmetric), law,
                       plates),
  elastic_(mesh, elastic_material(scene, mesh), scene.symmetric)
{
  for (int node = 0; node < elastic_.n_nodes(); ++node)
  {
    const bool halved = elastic_.inverse_mass(3 * node + 1) == 0.; // on the mirror plane
    mobility_.push_back((halved ? 0.5 : 1.) / elastic_.node_mass(node));
  }
  double contact = 0.; // largest squared frequency of a node on the plates' springs
  for (int node = 0; node < elastic_.n_nodes(); ++node)
    contact = std::max(contact, contact_stiffness(node) / elastic_.node_mass(node));
  const auto estimate = frequency_bound(MPI_COMM_SELF, elastic_);
  squared_frequency_  = estimate.squared_frequency + contact;
  seconds_per_step_   = estimate.seconds_per_force;
  elastic_.set_motion(start);
  begin_motion();
}

std::vector<double> FiniteElementProjectile::present_velocities(const double kick)
{
  return elastic_.velocity_after(kick / 2.);
}
} // namespace ricochet
