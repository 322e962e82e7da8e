// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads a scene, builds it, and says how long a step it would take.
#include <ricochet/base/version.h>
#include <ricochet/scene/scene_reader.h>
#include <ricochet/simulation/simulation.h>

#include <iostream>
#include <mpi.h>

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  {
    const ricochet::ParameterFile file(argv[1]);
    const ricochet::Simulation simulation(MPI_COMM_WORLD, ricochet::read_scene(file));
    std::cout << "ricochet " << ricochet::version() << ": " << simulation.n_points()
              << " points, steps of " << simulation.dt() << " s\n";
  }
  MPI_Finalize();
}
