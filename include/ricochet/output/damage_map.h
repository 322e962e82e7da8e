// SPDX-License-Identifier: LGPL-2.1-or-later
// Damage of the plates seen from above, in the reference configuration: what the picture of the
// damaged faces is drawn from.
#pragma once

#include <filesystem>
#include <mpi.h>
#include <vector>

namespace ricochet
{
/// One plate as a grid of n_x times n_y columns of points, y fastest; NaN where holes and notches
/// have left none.
struct DamageMap
{
  int plate;                // number, from 1
  int n_x;                  // columns along x
  int n_y;                  // and along y
  double spacing;           // of the grid [m]
  double corner[2];         // of lowest x and y [m]
  bool mirrored;            // y > 0 is shown, y < 0 is its mirror image
  std::vector<float> front; // damage of the uppermost point of each column [-]
  std::vector<float> rear;  // and of the lowest one [-]
  std::vector<float> mean;  // through the thickness [-]
};

/// Writes DIRECTORY/damage.h5: for plate 1 the datasets plate_1_front, plate_1_rear and
/// plate_1_mean (n_x rows of n_y), and plate_1_grid with spacing, corner x, corner y [m] and 1 if
/// mirrored; and so on. The content of rank 0 counts. Collective; throws FileError on all ranks.
void write_damage_maps(MPI_Comm comm, const std::filesystem::path &directory,
                       const std::vector<DamageMap> &maps);
} // namespace ricochet
