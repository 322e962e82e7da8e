// SPDX-License-Identifier: LGPL-2.1-or-later
// The rigid motion that a deforming body's is closest to, for output and for the verdict.
#pragma once

#include "ricochet/bodies/rigid_body.h"

namespace ricochet
{
/**
 * Centroid, its velocity, the rotation that takes the reference configuration nearest to the
 * present one (mass-weighted least squares), and the spin with the present angular momentum.
 *
 * @param mass       Of each node or point [kg].
 * @param reference  Their reference positions [m].
 * @param position   Present positions, three numbers each [m].
 * @param velocity   Likewise [m/s].
 * @param mirrored   They are the half y >= 0 of a body that is symmetric about y = 0.
 */
RigidBody::Motion nearest_rigid_motion(const std::vector<double> &mass,
                                       const std::vector<Vector3> &reference,
                                       const std::vector<double> &position,
                                       const std::vector<double> &velocity, bool mirrored);
} // namespace ricochet
