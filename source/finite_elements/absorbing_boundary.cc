// SPDX-License-Identifier: LGPL-2.1-or-later
#include "absorbing_boundary.h"

#include <Eigen/Geometry>

#include <cmath>

namespace ricochet
{
AbsorbingBoundary::AbsorbingBoundary(const HexMesh &mesh, const FiniteElementMaterial &material,
                                     const std::array<bool, 6> &faces)
{
  const auto &box  = mesh.box();
  const double rho = material.density;
  const double c_p = std::sqrt((material.bulk_modulus + 4. / 3. * material.shear_modulus) / rho),
               c_s = std::sqrt(material.shear_modulus / rho);
  std::vector<double> coefficient(mesh.reference().size(), 0.);
  for (const auto &element : mesh.elements())
    for (int corner = 0; corner < 8; ++corner)
    {
      const int node = element.nodes[corner];
      Vector3 own    = Vector3::Zero();
      for (int face = 0; face < 6; ++face)
      {
        const int axis = face / 2, side = face % 2;
        const double plane = box.corner[axis] + side * box.n[axis] * box.edge;
        if (!faces[face] || ((corner >> axis) & 1) != side ||
            std::abs(mesh.reference_position(node)[axis] - plane) > 1e-6 * element.edge)
          continue;
        for (int d = 0; d < 3; ++d)
          own[d] += rho * (d == axis ? c_p : c_s) * element.edge * element.edge / 4.;
      }
      for (int d = 0; d < 3; ++d)
        coefficient[3 * node + d] += own[d];
    }
  mesh.add_to_owners(coefficient.data());
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    if (coefficient[3 * node] > 0.) // then so are the other two
    {
      places_.push_back(mesh.place_number(mesh.reference_position(node)));
      for (int i = 3 * node; i < 3 * node + 3; ++i)
        dashpots_.push_back({i, coefficient[i]});
    }
}

/// Of a dashpot's node, with half the dashpot's force at either end of the step [N]:
/// v+ = ((1 - q) v- + dt f/m)/(1 + q) with q = c dt/2m, stable for any c, and as accurate as the
/// leapfrog scheme around it.
double AbsorbingBoundary::damped_force(const Dashpot &dashpot, const Motion &motion,
                                       const double dt)
{
  const int i    = dashpot.entry;
  const double q = 0.5 * dashpot.coefficient * dt * motion.inverse_mass[i];
  return (motion.force[i] - dashpot.coefficient * motion.velocity[i]) / (1. + q);
}

void AbsorbingBoundary::damp(const Motion &motion, const double kick, std::vector<double> &force)
{
  for (auto &dashpot : dashpots_)
  {
    const int i           = dashpot.entry;
    const double undamped = motion.force[i], f = damped_force(dashpot, motion, kick);
    force[i]              = f;
    const double v        = motion.velocity[i] + 0.5 * kick * f * motion.inverse_mass[i];
    const Vector3 impulse = kick * (undamped - f) * Vector3::Unit(i % 3);
    dashpot.absorbed += kick * dashpot.coefficient * v * v;
    dashpot.carried_linear += impulse[i % 3];
    const double *const x = motion.position.data() + 3 * (i / 3);
    dashpot.carried_angular += Vector3(x[0], x[1], x[2]).cross(impulse);
  }
}

void AbsorbingBoundary::add_energies(const Motion &motion, const std::vector<double> &mass,
                                     const double dt, ExactSum &kinetic, ExactSum &absorbed) const
{
  for (const auto &dashpot : dashpots_)
  {
    const int i         = dashpot.entry;
    const double before = motion.velocity[i], f = damped_force(dashpot, motion, dt),
                 change = dt * motion.inverse_mass[i] * f;
    kinetic.add(0.5 * mass[i / 3] * before * dt * motion.inverse_mass[i] * (f - motion.force[i]));
    absorbed.add(dashpot.absorbed);
    // Up to the middle of the step.
    absorbed.add(0.5 * dt * dashpot.coefficient * before * (before + 0.5 * change));
  }
}

void AbsorbingBoundary::add_momenta(std::array<ExactSum, 6> &sums) const
{
  for (const auto &dashpot : dashpots_)
  {
    sums[dashpot.entry % 3].add(dashpot.carried_linear);
    for (int d = 0; d < 3; ++d)
      sums[3 + d].add(dashpot.carried_angular[d]);
  }
}

void AbsorbingBoundary::exchange_state(StateArchive &archive)
{
  constexpr std::size_t n_numbers = 5; // of a dashpot
  std::vector<double> rows;
  for (const auto &dashpot : dashpots_)
  {
    rows.insert(rows.end(), {dashpot.absorbed, dashpot.carried_linear});
    rows.insert(rows.end(), dashpot.carried_angular.data(), dashpot.carried_angular.data() + 3);
  }
  archive.rows("dashpots", places_, rows, 3 * n_numbers);
  const double *next = rows.data();
  for (auto &dashpot : dashpots_)
  {
    dashpot.absorbed        = next[0];
    dashpot.carried_linear  = next[1];
    dashpot.carried_angular = Vector3(next[2], next[3], next[4]);
    next += n_numbers;
  }
}
} // namespace ricochet
