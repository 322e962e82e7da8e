// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mass_properties.h"

#include <Eigen/Jacobi>
#include <Eigen/LU>

namespace ricochet
{
MassProperties::MassProperties(const HexahedralBody &mesh)
{
  const double halves = mesh.multiplicity();
  for (int node = 0; node < mesh.n_nodes(); ++node)
  {
    mass += halves * mesh.node_mass(node);
    centre += halves * mesh.node_mass(node) * mesh.solid().nodes[node];
  }
  centre /= mass;
  if (mesh.mirrored())
    centre.y() = 0.;
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (int node = 0; node < mesh.n_nodes(); ++node)
  {
    const Vector3 arm = mesh.solid().nodes[node] - centre;
    tensor += halves * mesh.node_mass(node) *
              (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  if (mesh.mirrored()) // what is odd in y cancels against the other half
    for (const int d : {0, 2})
      tensor(1, d) = tensor(d, 1) = 0.;
  inertia           = tensor.diagonal();
  // The axes of a generated mesh are principal ones but for rounding, and two of them arbitrary.
  const double skew = (tensor - Eigen::Matrix3d(inertia.asDiagonal())).norm();
  if (skew > 1e-9 * inertia.maxCoeff())
    turn_to_principal_axes(tensor, mesh.mirrored());
}

/// Near those of the mesh, y kept if it is a mirror's normal: Jacobi's rotations.
void MassProperties::turn_to_principal_axes(Eigen::Matrix3d tensor, const bool mirrored)
{
  for (int sweep = 0; sweep < 20; ++sweep)
    for (const auto &[p, q] : {std::pair(0, 2), {0, 1}, {1, 2}})
      if (!mirrored || (p == 0 && q == 2))
      {
        Eigen::JacobiRotation<double> rotation;
        rotation.makeJacobi(tensor, p, q);
        tensor.applyOnTheLeft(p, q, rotation.adjoint());
        tensor.applyOnTheRight(p, q, rotation);
        axes.applyOnTheRight(p, q, rotation);
      }
  inertia = tensor.diagonal();
}
} // namespace ricochet
