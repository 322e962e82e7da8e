// SPDX-License-Identifier: LGPL-2.1-or-later
// The points of the bench of the contact searches, and how many pairs they have.
#pragma once

#include "ricochet/base/vector.h"

#include <string>
#include <vector>

namespace ricochet
{
/// In a cube of this edge [m]. "lattice": of the cubic number next to n_points; "random": the same
/// with every standard library.
std::vector<Vector3> search_points(const std::string &arrangement, int n_points, double edge);

/// Points along the edge of such a lattice.
int lattice_size(int n_points);

/**
 * Expected number of pairs closer than the radius among points spread uniformly over a cube.
 *
 * @param n_points   At least 0.
 * @param edge       Of the cube [m].
 * @param radius     Not above the edge [m].
 */
double expected_random_pairs(double n_points, double edge, double radius);

/// Number of pairs closer than the radius among the n^3 points of a cubic lattice [m].
double lattice_pairs(int n, double spacing, double radius);

/// Of search_points(); a mean if they are random.
double expected_pairs(const std::string &arrangement, int n_points, double edge, double radius);
} // namespace ricochet
