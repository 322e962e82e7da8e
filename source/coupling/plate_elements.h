// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite elements of a coupled plate: their mesh, material and which of them count.
#pragma once

#include "ricochet/coupling/coupled_plate.h"

namespace ricochet
{
/// Cells that so many horizons take, at least one.
int cells_in(double horizons, const Stencil &stencil, int points_per_edge);

/// `points` and `zone` must outlive the mesh's construction. Throws InputError if the plate cannot
/// be divided into cubes.
HexMesh::Box mesh_box(const PeridynamicBody &points, const Zone &zone,
                      const CoupledPlateOptions &options);

/// Elements in the zone do not count. `points` and `zone` must outlive the body's construction.
FiniteElementBody::Options element_options(const PeridynamicBody &points, const Zone &zone,
                                           const CoupledPlateOptions &options);

FiniteElementMaterial material_of(const PeridynamicBody &points);

/// Of the shear modulus, all branches together [-].
double relaxing_share(const PeridynamicBody &points);
} // namespace ricochet
