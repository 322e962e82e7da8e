// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes of hexahedra in gmsh's ASCII formats 2.2 and 4.1.
#pragma once

#include "ricochet/geometry/body_of_revolution.h"
#include "ricochet/geometry/hex_solid.h"

#include <filesystem>
#include <ostream>

namespace ricochet
{
/// Hexahedra with a scaled Jacobian below this are refused [-].
constexpr double smallest_scaled_jacobian = 0.1;

/// Reads a mesh; coordinates in the file times `unit` [m]. Throws FileError if the file cannot be
/// read, InputError if it is no gmsh file in ASCII, holds anything but hexahedra as volumes, or a
/// folded or very distorted one.
HexSolid read_mesh(const std::filesystem::path &path, double unit);

/// Writes format 2.2 with coordinates divided by `unit` [m]; the physical surfaces 1 base, 2 shank
/// and 3 nose tell where on `body` the faces lie (4 plane: cut open at y = 0), 1 is the volume.
void write_mesh(const HexSolid &solid, const BodyOfRevolution &body, double unit,
                std::ostream &out);
} // namespace ricochet
