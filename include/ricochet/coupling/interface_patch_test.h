// SPDX-License-Identifier: LGPL-2.1-or-later
// The patch test on a plate as it is: under a uniform strain nothing should move. What lies less
// than twice the reach of the bonds below a free face is held in the strained position (points
// there lack neighbours, or have neighbours that do, and would relax whatever the coupling);
// everything else is released and comes to rest by conjugate gradients with the very forces that a
// run integrates.
#pragma once

#include "ricochet/coupling/coupled_plate.h"

namespace ricochet
{
/// What patch_test() finds.
struct PatchReport
{
  double ghost_force;  // largest, on a node or point, in units of strain times M h^2 [-]
  double strain_error; // largest difference from the strain, in units of it [-]
  int n_iterations;    // of all strains together
  int n_strains;       // six, or four with a symmetry plane, which forbids two shears
  bool converged;      // all of them: the strain error is what it is said to be
};

/// The plate is left at rest in its reference configuration. Without relaxation (no iterations) the
/// strain error is not a number. `residual_left`: forces at the end of the relaxation, in the
/// preconditioner's norm and in units of those at its start; with 1e-2 the strain error is right to
/// 1 %, with 3e-2 to 3 %. Collective.
PatchReport patch_test(MPI_Comm communicator, CoupledPlate &plate, int most_iterations = 200,
                       double residual_left = 1e-2);
} // namespace ricochet
