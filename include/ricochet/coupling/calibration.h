// SPDX-License-Identifier: LGPL-2.1-or-later
// Stiffness of the elements around a zone, such that peridynamic points and elements together are
// in equilibrium under any uniform strain, as the plate of elements alone would be.
//
// Peridynamic energy ends gradually: bonds reach out of the zone into the pad and the halo. What is
// missing there to the full stiffness is left to the elements, as a symmetric tensor C_g at every
// Gauss point. Starting from C_g = w C, where w is the share of the bond stress that is missing,
// the smallest change of all C_g (in the sense of least squares) is sought that makes the nodal
// forces under six unit strains those of the plate of elements alone: zero inside, tractions on
// free surfaces. The solution is found by conjugate gradients on the normal equations, matrix-free,
// and made non-negative: a sum of energies none of which is negative cannot become unstable. If the
// shear modulus relaxes, the same is done for the volumetric and the shear part of all stiffness
// one by one; the report then gives the worse of the two, each in units of its own K + 4 mu/3.
#pragma once

#include "ricochet/forces/finite_element_force.h"
#include "ricochet/forces/peridynamic_force.h"

namespace ricochet
{
struct CalibrationReport
{
  // Largest force at a node under a unit strain, in units of (K + 4 mu/3) h^2 [-].
  double ghost_before, ghost_after; // of the scaled C alone, and of the result
  double smallest_eigenvalue;       // of any C_g before it is made non-negative, per K + 4 mu/3 [-]
  int n_iterations;
  std::int64_t n_elements;
};

struct CalibrationOptions
{
  int n_iterations = 60;   // at most
  int round        = 7;    // iterations between two looks at the eigenvalues
  double tolerance = 1e-3; // stop when all nodal forces are below [-]
  bool clip        = true; // false for studies of what happens then
};

/// The tensors of this rank's elements in the pad and halo of the points' zone. Collective.
std::vector<ElementStiffness> calibrate(MPI_Comm communicator, const PeridynamicForce &points,
                                        const FiniteElementForce &elements,
                                        const CalibrationOptions &options,
                                        CalibrationReport &report);
} // namespace ricochet
