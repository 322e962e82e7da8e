// SPDX-License-Identifier: LGPL-2.1-or-later
// The pictures in time of a run: the full fields for ParaView (vtu_writer.h) and the section for
// plots (section_writer.h), under one frame number.
#pragma once

#include "ricochet/output/section_writer.h"
#include "ricochet/output/vtu_writer.h"

#include <memory>

namespace ricochet
{
class FieldWriter
{
public:
  /// Writes into a folder that exists; with `vtu` also the files for ParaView. Collective, as
  /// write(); both throw FileError on all ranks.
  FieldWriter(MPI_Comm comm, const std::filesystem::path &directory, bool vtu);

  /// What write() makes use of.
  FrameExtent extent() const { return vtu_ ? FrameExtent::everything : FrameExtent::section; }
  /// Writes the next frame, of extent(), at the time [s]. After a FileError all earlier frames are
  /// still complete.
  void write(double time, const PointFrame &points, const SurfaceFrame &surface,
             const ElementFrame &elements = {});

  /// Saves or restores which frames there are.
  void exchange_state(StateArchive &archive);

  unsigned int n_frames() const { return n_frames_; } // written so far

private:
  SectionWriter section_;
  std::unique_ptr<VtuWriter> vtu_; // null if not wanted
  unsigned int n_frames_ = 0;
};
} // namespace ricochet
