// SPDX-License-Identifier: LGPL-2.1-or-later
// Viscoplastic flow in shear under pressure: the material yields where its equivalent shear stress
// tau = sqrt(J_2) exceeds
//   A (g/g_0)^n + B p,   g_0 = 1/s,
// g being the rate of plastic shear and p the pressure, as far as it is compression. PMMA: A =
// 66.78 MPa, n = 0.06933, B = 0.223 (Rittel and Brill 2008, J. Mech. Phys. Solids 56, for confined
// specimens). An overstress law in the sense of Perzyna (1966, Adv. Appl. Mech. 9).
#pragma once

namespace ricochet
{
struct FlowLaw
{
  double stress         = 0.; // A [Pa]; 0: the material does not flow
  double rate_exponent  = 0.; // n [-], above 0
  double pressure_slope = 0.; // B [-]

  /// Whether there is any.
  bool flows() const { return stress > 0.; }
};

/// Share of the shear stress that flow takes away in a step, from 0 to 1 [-]: backward Euler with
/// the shear modulus mu, tau' = tau - mu g dt = A (g/g_0)^n + B p. Flow slower than 1/s counts as
/// none.
///
/// @param law            Must flow.
/// @param tau            That the step would reach without flow [Pa].
/// @param pressure       Positive in compression [Pa].
/// @param shear_modulus  mu [Pa].
/// @param dt             Of the step [s].
double relaxed_by_flow(const FlowLaw &law, double tau, double pressure, double shear_modulus,
                       double dt);

/// Bonds of a linear peridynamic solid that are all extended by less than this times their length,
/// either way, leave tau below A: tau^2 = 15 mu^2/m sum omega e_dev^2 V <= 15 mu^2 max(e/|xi|)^2.
/// [-]
double least_yielding_stretch(const FlowLaw &law, double shear_modulus);
} // namespace ricochet
