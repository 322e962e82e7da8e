// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/nearest_rigid_motion.h"

#include <Eigen/Dense>

namespace ricochet
{
namespace
{
Eigen::Map<const Vector3> at(const std::vector<double> &values, const std::size_t node)
{
  return Eigen::Map<const Vector3>(values.data() + 3 * node);
}
} // namespace

RigidBody::Motion nearest_rigid_motion(const std::vector<double> &mass,
                                       const std::vector<Vector3> &reference,
                                       const std::vector<double> &position,
                                       const std::vector<double> &velocity, const bool mirrored)
{
  RigidBody::Motion motion;
  motion.position = motion.velocity = Vector3::Zero();
  Vector3 centre                    = Vector3::Zero(); // in the reference configuration
  double total                      = 0.;
  for (std::size_t node = 0; node < mass.size(); ++node)
  {
    total += mass[node];
    centre += mass[node] * reference[node];
    motion.position += mass[node] * at(position, node);
    motion.velocity += mass[node] * at(velocity, node);
  }
  for (Vector3 *mean : {&centre, &motion.position, &motion.velocity})
  {
    *mean /= total;
    if (mirrored)
      mean->y() = 0.;
  }

  // The rotation nearest to sum m (x - c) (X - C)^T; the inertia of the present shape.
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero(), inertia = Eigen::Matrix3d::Zero();
  Vector3 spin_momentum = Vector3::Zero();
  for (std::size_t node = 0; node < mass.size(); ++node)
  {
    const Vector3 arm = at(position, node) - motion.position;
    correlation += mass[node] * arm * (reference[node] - centre).transpose();
    inertia +=
        mass[node] * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    spin_momentum += mass[node] * arm.cross(at(velocity, node) - motion.velocity);
  }
  if (mirrored) // what is odd in y cancels against the other half
  {
    for (int d : {0, 2})
      correlation(1, d) = correlation(d, 1) = inertia(1, d) = inertia(d, 1) = 0.;
    spin_momentum.x() = spin_momentum.z() = 0.;
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3 signs = Vector3::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.)
    signs.z() = -1.;
  motion.orientation = Eigen::Quaterniond(
      Eigen::Matrix3d(svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose()));
  motion.spin = inertia.ldlt().solve(spin_momentum);
  return motion;
}
} // namespace ricochet
