// SPDX-License-Identifier: LGPL-2.1-or-later
// What the points of a lattice hold together, the same to the last bit on any number of ranks.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/peridynamics/lattice_state.h"

#include <mpi.h>
#include <string>

namespace ricochet
{
struct PointEnergies
{
  double kinetic, strain; // [J]
};

/// Kinetic energy of the free points, each of that mass [kg], 1/2 m v- . v+ with the v+ that the
/// forces lead to in a step dt [s]; and the strain energy of all owned ones. Collective.
PointEnergies point_energies(MPI_Comm communicator, const Lattice &lattice,
                             const LatticeArrays &arrays, double mass, double dt);

/// Of the free points. Collective.
Momenta point_momenta(MPI_Comm communicator, const Lattice &lattice, const LatticeArrays &arrays,
                      double mass);

/// As Body::first_not_finite(). Not collective.
std::string first_point_not_finite(const Lattice &lattice, const LatticeArrays &arrays);
} // namespace ricochet
