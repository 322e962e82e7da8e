// SPDX-License-Identifier: LGPL-2.1-or-later
// All that moves on a lattice: positions, velocities, forces, dilatation, bonds.
#pragma once

#include "ricochet/kernels/lattice_kernel.h"
#include "ricochet/peridynamics/lattice.h"

#include <memory>

namespace ricochet
{
class LatticeState
{
public:
  /// At rest in the reference configuration, all bonds intact.
  explicit LatticeState(const Lattice &lattice);

  LatticeArrays arrays; // into the storage below

  /// One of arrays' fields, where points exist.
  void zero(const Lattice &lattice, double *field) const;

  /// After the lattice has followed its zone: points of the planes first <= x < last take their
  /// weight.
  void follow_zone(const Lattice &lattice, int first, int last);

  /// Images across y = 0 take over position and velocity, or a scalar, of their originals.
  void mirror_motion(const Lattice &lattice);
  /// See mirror_motion().
  void mirror(const Lattice &lattice, double *scalar) const;

private:
  struct Free
  {
    void operator()(double *p) const;
  };
  void weigh(const Lattice &lattice, std::ptrdiff_t first, std::ptrdiff_t last);

  std::ptrdiff_t size_;
  std::unique_ptr<double[], Free> storage_;
  std::vector<std::uint8_t> bonds_;
};
} // namespace ricochet
