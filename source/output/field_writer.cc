// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/field_writer.h"

#include <cassert>

namespace ricochet
{
FieldWriter::FieldWriter(const MPI_Comm comm, const std::filesystem::path &directory,
                         const bool vtu) :
  section_(comm, directory),
  vtu_(vtu ? std::make_unique<VtuWriter>(comm, directory) : nullptr)
{
}

void FieldWriter::write(const double time, const PointFrame &points, const SurfaceFrame &surface,
                        const ElementFrame &elements)
{
  const std::size_t n = points.position.size();
  assert(points.displacement.size() == n && points.velocity.size() == n &&
         points.damage.size() == n);
  assert(points.state.dilatation.size() == n && points.body.size() == n &&
         points.in_section.size() == n);
  (void) n;

  section_.write(n_frames_, time, points, surface, elements);
  if (vtu_)
    vtu_->write(n_frames_, time, points, surface, elements);
  ++n_frames_;
}

void FieldWriter::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "frames");
  archive.common("number", n_frames_);
  if (vtu_)
    vtu_->exchange_state(archive);
}
} // namespace ricochet
