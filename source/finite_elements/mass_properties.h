// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ricochet/finite_elements/hexahedral_body.h"

namespace ricochet
{
/// Mass, centroid and inertia of a mesh with both its halves.
struct MassProperties
{
  double mass          = 0.;                          // [kg]
  Vector3 centre       = Vector3::Zero();             // [m]
  Vector3 inertia      = Vector3::Zero();             // about the principal axes [kg m^2]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); // the principal ones, in columns

  explicit MassProperties(const HexahedralBody &mesh);

private:
  void turn_to_principal_axes(Eigen::Matrix3d tensor, bool mirrored);
};
} // namespace ricochet
