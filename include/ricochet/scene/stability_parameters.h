// SPDX-License-Identifier: LGPL-2.1-or-later
// A stability experiment: a block of points in a box of finite elements, released from noise and
// left alone. What the parameter file says, in SI.
#pragma once

#include "ricochet/coupling/coupling_method.h"
#include "ricochet/materials/influence_function.h"

#include <string>

namespace ricochet
{
/// In units of what the time step is given.
enum class StepLimit
{
  measured, // by power iteration of the body
  predicted // from plane waves, coupling/dispersion.h
};

struct StabilityParameters
{
  std::string title;     // of the results
  std::string directory; // results folder

  CouplingParameters coupling;          // how points and elements are tied
  bool full_quadrature         = false; // eight points per element instead of one
  double hourglass_coefficient = 1.;    // [-]

  double spacing              = 1e-3;                    // dx [m]
  double horizon_ratio        = 3.;                      // delta/dx [-]
  InfluenceFunction influence = InfluenceFunction::cone; // of the bonds
  double density              = 1190.;                   // [kg/m^3]
  double youngs_modulus       = 6e9;                     // [Pa]
  double poisson_ratio        = 0.35;                    // [-]
  int half_width              = 4; // of the block of points, in spacings; even
  int margin                  = 4; // of elements around all points, in spacings; even

  StepLimit limit  = StepLimit::measured; // see time_step
  double time_step = 0.9;                 // in units of the limit [-]
  int n_steps      = 2000;                // unless the energy runs away
  double jitter    = 0.; // random displacement of all points and nodes at the start, in spacings
};
} // namespace ricochet
