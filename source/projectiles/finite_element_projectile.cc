// SPDX-License-Identifier: LGPL-2.1-or-later
#include "finite_element_projectile.h"

#include "ricochet/dynamics/elastic_body_time_step.h"

#include <algorithm>

namespace ricochet
{
namespace
{
FiniteElementMaterial material_of(const Scene &scene, const HexSolid &mesh)
{
  const auto &p  = scene.projectile;
  const double E = p.youngs_modulus, nu = p.poissons_ratio;
  const double own = scene.symmetric ? p.mass / 2. : p.mass;
  return {own / volume(mesh), E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu))};
}
} // namespace

FiniteElementProjectile::FiniteElementProjectile(const MPI_Comm communicator, const Scene &scene,
                                                 const HexSolid &mesh, const Motion &start,
                                                 const FrictionLaw &law,
                                                 const std::vector<PlateContact> &plates) :
  DeformableProjectile(communicator, scene, mesh.nodes, outer_faces(mesh, scene.symmetric), law,
                       plates),
  elastic_(mesh, material_of(scene, mesh), scene.symmetric)
{
  double contact = 0.; // largest squared frequency of a node on the plates' springs
  for (int node = 0; node < elastic_.n_nodes(); ++node)
    contact = std::max(contact, contact_stiffness(node) / elastic_.node_mass(node));
  const auto estimate = estimate_largest_frequency(elastic_);
  squared_frequency_  = estimate.squared_frequency + contact;
  seconds_per_step_   = estimate.seconds_per_force;
  elastic_.set_motion(start);
  begin_motion();
}

Projectile::Energies FiniteElementProjectile::energies(const Reaction &, const double dt) const
{
  const auto e = elastic_.energies(dt);
  return {multiplicity() * e.kinetic, multiplicity() * (e.strain + e.hourglass)};
}

Projectile::Momenta FiniteElementProjectile::momenta() const
{
  const auto m = elastic_.momenta();
  if (multiplicity() == 1.)
    return {m.linear, m.angular};
  return {2. * Vector3(m.linear.x(), 0., m.linear.z()), 2. * Vector3(0., m.angular.y(), 0.)};
}
} // namespace ricochet
