// SPDX-License-Identifier: LGPL-2.1-or-later
// How a free body of hexahedra vibrates: eigenmodes of K phi = omega^2 M phi and the answer to
// static loads, both without rigid motion. K is the stiffness of the very elements that
// HexahedralBody integrates, hourglass control included, at the reference configuration; M their
// lumped masses.
//
// With x = M^1/2 phi the problem is A x = omega^2 x, A = M^-1/2 K M^-1/2. The lowest modes are the
// largest eigenvalues of (A + sigma)^-1, factorised once (level_cholesky.h), and Anasazi's block
// Krylov-Schur process finds them in the complement of the rigid modes, which are known. Serial and
// from a fixed start: the same numbers wherever it is called.
#pragma once

#include "ricochet/finite_elements/hexahedral_body.h"

namespace ricochet
{
/// Of a free body, rigid ones left out.
struct FreeModes
{
  std::vector<double> squared_frequency;  // omega^2, ascending [1/s^2]
  std::vector<std::vector<double>> shape; // phi, three numbers per node; phi^T M phi = 1 with the
                                          // masses of the computed part [kg^-1/2]
};

/// The most of them that may be asked for: a third of the degrees of freedom beside rigid motion.
/// What lies above is a matter of the mesh, not of the body.
int most_free_modes(const HexahedralBody &body);

class FreeVibration
{
public:
  /// Of a body that outlives this object; with a mirror plane symmetric modes alone. Throws
  /// InputError if the body has no stiffness, or parts that nothing holds together.
  explicit FreeVibration(const HexahedralBody &body);
  ~FreeVibration();
  FreeVibration(const FreeVibration &)            = delete;
  FreeVibration &operator=(const FreeVibration &) = delete;

  /// The n lowest. Throws InputError if n is not 1 to most_free_modes(), RunError if the process
  /// does not converge.
  FreeModes lowest_modes(int n) const;

  /// Displacements at rest under forces [N], three numbers per node, that the inertia of a rigid
  /// motion balances: without a share of rigid motion [m].
  std::vector<double> static_displacement(const std::vector<double> &force) const;

private:
  struct System;
  std::unique_ptr<System> system_;
};
} // namespace ricochet
