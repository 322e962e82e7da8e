// SPDX-License-Identifier: LGPL-2.1-or-later
// The layer of points next to the plane y = 0 and the outline of the projectile, gathered and
// written in single precision: enough for the section picture, without VTK.
#pragma once

#include "ricochet/output/frame.h"

#include <filesystem>
#include <mpi.h>

namespace ricochet
{
/// DIRECTORY/section.h5 has one group per frame, "frame_0000" and so on, with the attribute time_s
/// [s] and the datasets position [m] (n x 3), damage [-], body [-], pressure [Pa], von_mises [Pa],
/// energy_density [J/m3] (frame_fields.h says what they are) and outline [m] (k x 3), and, of
/// further projectiles, "outline 2" and so on. The groups are links into the files of the folder
/// section/, so that a frame is never changed once it is written and the file may be read during
/// the run.
class SectionWriter
{
public:
  /// Creates DIRECTORY/section. Collective, as write(); both throw FileError on all ranks.
  SectionWriter(MPI_Comm comm, const std::filesystem::path &directory);

  /// Writes frame number `number`, counted from 0 without gaps, at the time [s]; of the points only
  /// those in the section.
  void write(unsigned int number, double time, const PointFrame &points,
             const SurfaceFrame &surface, const ElementFrame &elements = {});

private:
  MPI_Comm comm_;
  std::filesystem::path directory_;
};
} // namespace ricochet
