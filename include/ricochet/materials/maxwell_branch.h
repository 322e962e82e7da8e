// SPDX-License-Identifier: LGPL-2.1-or-later
// A Maxwell branch of the shear stiffness, and how its history goes on over one time step. This
// header must stay free of library headers: it is compiled once per instruction set.
//
// A branch is a spring of the modulus mu_k and a dashpot in a row. Of the strain e it holds back
// e_b, which follows
//   d e_b / dt = (e - e_b) / theta_k,    stress = 2 mu_k (e - e_b).
// For an e that is linear within the step the solution is exact (Mitchell 2011, SAND2011-8064):
//   e_b(n+1) = r e_b(n) + (1 - r - beta) e(n) + beta e(n+1),
//   r = exp(-dt/theta_k),   beta = 1 - (1 - r) theta_k/dt.
// Kept is g(n) = e_b(n) - beta e(n) alone, because then neither e(n) nor e_b(n) has to be:
//   g(n+1) = r g(n) + (1 - r) (1 - beta) e(n).
#pragma once

namespace ricochet
{
struct MaxwellBranch
{
  double share; // lambda_k = mu_k / mu of the instantaneous shear modulus [-]
  double time;  // theta_k [s]
};

/// The numbers above for one length of the time step.
struct MaxwellStep
{
  double share; // lambda_k [-]
  double decay; // r [-]
  double lag;   // beta [-]
  double feed;  // (1 - r) (1 - beta) [-]
};
} // namespace ricochet
