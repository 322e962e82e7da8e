// SPDX-License-Identifier: LGPL-2.1-or-later
// The hot loop of a mesh of eight-node hexahedra of any shape, total Lagrangian, one quadrature
// point, with Flanagan and Belytschko's (1981) uniform gradient and hourglass control in its
// stiffness form. With F = sum_a x_a B_a, B_a the mean of dN_a/dX over the element, E = (F^T F -
// 1)/2 and S = lambda tr(E) 1 + 2 mu E (St Venant-Kirchhoff), the energy of an element is
//   V/2 S : E + sum_alpha k_alpha/2 |q_alpha|^2,   q_alpha = sum_a gamma_alpha,a x_a,
//   gamma_alpha,a = Gamma_alpha,a - B_a . sum_b Gamma_alpha,b X_b
// with Gamma_alpha the four products of corner coordinates: q vanishes for every linear motion, on
// elements of any shape. Forces are minus the gradient. On cubes it is the one-point element of
// kernels/hex_kernel.h. Numbers in, numbers out; free of library headers.
#pragma once

#include "ricochet/kernels/hex_kernel.h"

namespace ricochet
{
/// Eight elements side by side. Lanes beyond the last element must hold one that exists: they are
/// read, not written. All but `entry` is fixed by the reference configuration.
struct GeneralHexBlock
{
  int32_t entry[8][8]; // [corner][lane]: 3 * local node; corner = x + 2 y + 4 z of the unit cube
  double gradient[7][3][8];  // sum_a Gamma_m,a B_a / 8 of the modes r, s, t, st, rt, rs, rst [1/m]
  double reference[4][3][8]; // sum_a Gamma_alpha,a X_a of st, rt, rs, rst [m]
  double volume[8];          // V [m^3]
  double bending[8];         // k of st, rt and rs [N/m]
  double warping[8];         // k of rst [N/m]
};

/// Elements of one material.
struct GeneralHexGroup
{
  const GeneralHexBlock *blocks; // of eight elements each
  int64_t n_elements;            // in all blocks; the last may not be full
  double lambda;                 // [Pa]
  double mu;                     // [Pa]
};

struct GeneralHexKernel
{
  using ForceLoop = void (*)(const HexArrays &, const GeneralHexGroup &); // adds to the forces

  const char *instruction_set;    // that the loops are compiled for
  ForceLoop one_point;            // forces alone
  ForceLoop one_point_and_energy; // and both energies of each element
};

/// As hex_kernel().
const GeneralHexKernel *general_hex_kernel(const char *instruction_set = nullptr);
} // namespace ricochet
