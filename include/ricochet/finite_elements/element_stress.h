// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress, dilatation and energy density of elements, for pictures: nothing here enters a step. Of
// the material at the deformation gradient F in the middle of the element: St Venant-Kirchhoff with
// the moduli and what its branches hold (kernels/hex_kernel.h), and tau = F S F^T. Stiffness
// tensors of an element's own do not count: beside a zone of points they are the part of the
// material that the bonds there leave to the element.
#pragma once

#include "ricochet/base/stress_state.h"
#include "ricochet/finite_elements/finite_element_body.h"

namespace ricochet
{
/// Ghosts must be up to date; with relaxation the forces of the present step must have been
/// computed, and advance() not. Hourglass modes do not count.
StressState element_stress(const FiniteElementBody &elements, int element);
} // namespace ricochet
