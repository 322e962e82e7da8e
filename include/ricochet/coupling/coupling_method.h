// SPDX-License-Identifier: LGPL-2.1-or-later
// How the peridynamic zone and the finite elements around it are made one body. In all methods the
// points around the zone follow the elements' nodes; they differ in whose energy or force counts
// there.
#pragma once

#include "ricochet/peridynamics/zone.h"

#include <array>

namespace ricochet
{
enum class CouplingMethod
{
  calibrated_energy_blend, // elements carry what the bonds lack, found by least squares (default)
  energy_blend,            // energies weighted with a and 1 - a over a chosen width
  force_blend,             // forces weighted so: no energy exists, unstable in the long run
  none                     // both in full, for comparison
};

/// A method and how it is called.
struct CouplingMethodName
{
  CouplingMethod method; // which one
  const char *name;      // in parameter files
};

/// All of them.
constexpr std::array<CouplingMethodName, 4> coupling_methods{
    {{CouplingMethod::calibrated_energy_blend, "calibrated energy blend"},
     {CouplingMethod::energy_blend, "energy blend"},
     {CouplingMethod::force_blend, "force blend"},
     {CouplingMethod::none, "none"}}};

/// When the least squares end.
struct CalibrationOptions
{
  /// At most: blocks and columns take about 80, with a horizon of four spacings 160
  /// (tests/coupling/test_calibration.cc prints them), a zone through 48 points 220; more says that
  /// the zone does not converge.
  int n_iterations = 300;
  /// Iterations between two looks at the eigenvalues: from 7 to 20 their number changes by a fifth
  /// in columns of 24 points, and falls by two fifths in those of 48.
  int round        = 20;
  /// Stop when all nodal forces are below, in units of M h^2: a tenth of what an interface may have
  /// (simulation/interface_report.h). In the softened layer under a free face five times as much is
  /// allowed, half of that [-].
  double tolerance = 2e-4;
  bool clip        = true; // false for studies of what happens then
};

/// How points and elements are tied to each other.
struct CouplingParameters
{
  CouplingMethod method = CouplingMethod::calibrated_energy_blend; // whose energy or force counts
  // Of energy_blend and force_blend:
  BlendFunction blend   = BlendFunction::cubic; // linear or cubic
  double blend_width    = 2.;                   // in horizons
  bool correct_mass     = true;                 // consistent mass of the pad, to first order
  /// Of the elements next to the zone, in grid spacings: 1, 2 or 4.
  int points_per_edge   = Zone::usual_points_per_edge;
  CalibrationOptions calibration; // of calibrated_energy_blend
};
} // namespace ricochet
