// SPDX-License-Identifier: LGPL-2.1-or-later
// A solid cut into eight-node hexahedra of any shape, as plain arrays, with the measures that
// decide whether it can be computed with: Jacobians, quality, smallest edge, volume, surface.
#pragma once

#include "ricochet/base/vector.h"

#include <array>
#include <vector>

namespace ricochet
{
struct HexSolid
{
  std::vector<Vector3> nodes;            // [m]
  std::vector<std::array<int, 8>> cells; // corner = x + 2 y + 4 z of the unit cube
};

/// Four nodes around a face of the surface, counter-clockwise seen from outside.
using SurfaceQuad = std::array<int, 4>;

/// Volume of one cell, by Gauss quadrature, which is exact [m^3].
double cell_volume(const HexSolid &solid, int cell);
double volume(const HexSolid &solid); // [m^3]

/// Integrals over one cell by 2 x 2 x 2 Gauss points, which are exact for them.
struct CellIntegrals
{
  double volume                        = 0.;                                  // [m^3]
  Eigen::Matrix<double, 8, 3> gradient = Eigen::Matrix<double, 8, 3>::Zero(); // of dN_a/dX [m^2]
  Eigen::Matrix<double, 8, 1> shape    = Eigen::Matrix<double, 8, 1>::Zero(); // of N_a [m^3]
};
/// Of one cell.
CellIntegrals integrals(const HexSolid &solid, int cell);

/// The shape functions N_a at natural coordinates, -1 to 1 in the cell [-].
std::array<double, 8> shape_functions(const Vector3 &natural);
/// Natural coordinates of a place in the cell or near it: sum N_a X_a is the place. Newton's
/// method; not a number where it does not converge.
Vector3 natural_coordinates(const HexSolid &solid, int cell, const Vector3 &place);

Vector3 centroid(const HexSolid &solid); // [m]

/// Smallest triple product of the unit vectors along the three edges that meet in a corner: 1 for a
/// box, not positive for a cell that is folded or inside out [-].
double scaled_jacobian(const HexSolid &solid, int cell);

double smallest_edge(const HexSolid &solid); // [m]

/// Faces that belong to one cell only. Throws InputError if more than two cells share a face.
std::vector<SurfaceQuad> surface_of(const HexSolid &solid);

/// The cells at y >= 0 with their nodes, those within `tolerance` of the plane moved onto it.
/// Throws InputError if a cell lies on both sides.
HexSolid upper_half(const HexSolid &solid, double tolerance);
} // namespace ricochet
