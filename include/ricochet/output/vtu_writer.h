// SPDX-License-Identifier: LGPL-2.1-or-later
// Points, elements and projectile for ParaView: a VTU file per rank and a PVTU file for the points
// and for the elements, a VTU file for the projectile, and results.pvd, which opens all times and
// all bodies as one time series.
#pragma once

#include "ricochet/base/state_archive.h"
#include "ricochet/output/frame.h"

#include <filesystem>
#include <mpi.h>
#include <string>
#include <vector>

namespace ricochet
{
class VtuWriter
{
public:
  /// Creates DIRECTORY/vtu. Collective, as write(); both throw FileError on all ranks.
  VtuWriter(MPI_Comm comm, const std::filesystem::path &directory);

  /// Writes frame number `number`, counted from 0 without gaps, at the time [s]. results.pvd names
  /// the frame only after all its files are complete, so that it can be opened at any moment.
  void write(unsigned int number, double time, const PointFrame &points,
             const SurfaceFrame &surface, const ElementFrame &elements = {});

  /// Saves or restores which frames there are.
  void exchange_state(StateArchive &archive);

private:
  template <class Frame>
  void write_pieces(const std::string &name, unsigned int number, double time,
                    const Frame &frame) const;
  void write_projectile(const std::string &file, double time, const SurfaceFrame &surface) const;
  void write_index() const;

  struct Entry
  {
    double time; // [s]
    std::int64_t n_elements;
  };

  MPI_Comm comm_;
  std::filesystem::path directory_;
  std::vector<Entry> entries_; // of all frames so far
};
} // namespace ricochet
