// SPDX-License-Identifier: LGPL-2.1-or-later
// Makes and judges the hexahedral mesh of a projectile.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <mpi.h>
#include <string>

namespace ricochet
{
struct MeshOptions
{
  std::string write; // gmsh file to write, 2.2 ASCII in mm; empty: none
};

/// Builds the deformable projectile of a scene, whatever its model, prints what the mesh is worth
/// and writes it. Computes and prints on rank 0. Throws InputError and FileError.
void mesh_projectile(MPI_Comm communicator, const ParameterFile &file, const MeshOptions &options);
} // namespace ricochet
