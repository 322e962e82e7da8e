// SPDX-License-Identifier: LGPL-2.1-or-later
// How stiff the elements of a FiniteElementBody are.
#pragma once

#include "ricochet/kernels/hex_kernel.h"

#include <array>

namespace ricochet
{
/// How an element integrates its energy. `one_point` takes about half the time and bends as freely
/// as a beam; `full` (2 x 2 x 2 points) is the reference: it has no hourglass modes, but locks in
/// bending: the curvature of a cube costs E/(1 - nu^2) + mu instead of E, which stiffens a plate of
/// n cubes by (1/(1 - nu^2) + 1/(2 (1 + nu)) - 1)/n^2.
enum class Quadrature
{
  one_point,
  full
};

/// A symmetric stiffness tensor as in HexTensors: upper triangle, row by row, in Voigt's order.
using StiffnessTensor   = std::array<double, HexTensors::n_entries>;
using GaussPointTensors = std::array<StiffnessTensor, 8>; // in the order of the corners

/// An element's own stiffness tensor at each Gauss point [Pa]. The eigenvalues must not be
/// negative, or the body is unstable.
struct ElementStiffness
{
  int element;               // number in mesh().elements()
  GaussPointTensors tensors; // C [Pa]
  /// The part of them that relaxes with the material, C_mu; zero: they stay elastic. Neither C_mu
  /// nor C - C_mu may have negative eigenvalues.
  GaussPointTensors shear = {};
};
} // namespace ricochet
