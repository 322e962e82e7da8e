// SPDX-License-Identifier: LGPL-2.1-or-later
// One element of kernels/general_hex_kernel.h at its reference configuration: what blocks of the
// kernel and assembled stiffnesses are made of.
#pragma once

#include "ricochet/geometry/hex_solid.h"

#include <Eigen/Core>

namespace ricochet
{
struct Hexahedron
{
  double volume;                           // V [m^3]
  Eigen::Matrix<double, 8, 3> gradient;    // B_a, the means of dN_a/dX [1/m]
  Eigen::Matrix<double, 8, 7> mode;        // Gamma of r, s, t, st, rt, rs, rst [-]
  Eigen::Matrix<double, 3, 4> reference;   // sum_a Gamma_alpha,a X_a of st, rt, rs, rst [m]
  double bending, warping;                 // k of st, rt, rs and of rst [N/m]
  Eigen::Matrix<double, 8, 1> node_volume; // integrals of N_a [m^3]

  /// `hourglass_stiffness`: coefficient times Young's modulus [Pa]. Throws InputError if the cell
  /// is folded.
  Hexahedron(const HexSolid &solid, int cell, double hourglass_stiffness);

  /// dF/dx = -K at the reference configuration, entry 3 corner + component; the strain energy
  /// counts by `share` [N/m].
  Eigen::Matrix<double, 24, 24> stiffness(double lambda, double mu, double share) const;
};
} // namespace ricochet
