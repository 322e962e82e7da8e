// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/vtu_writer.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/frame_fields.h"

#include <deal.II/base/data_out_base.h>

#include <sstream>
#include <tuple>

namespace ricochet
{
namespace
{
using dealii::DataComponentInterpretation::component_is_part_of_vector;
using dealii::DataComponentInterpretation::DataComponentInterpretation;
using VectorRange =
    std::tuple<unsigned int, unsigned int, std::string, DataComponentInterpretation>;

/// Columns of the data table of every point, one per component of a field. The units stand in the
/// names because ParaView shows nothing else; the attribute that deal.II offers for units is not
/// read by VTK.
std::vector<std::string> column_names()
{
  std::vector<std::string> names;
  for (const auto &field : frame_fields())
    names.insert(names.end(), field.n_components, field.title());
  return names;
}

/// Which of these columns are components of one vector.
std::vector<VectorRange> vector_fields()
{
  std::vector<VectorRange> ranges;
  unsigned int column = 0;
  for (const auto &field : frame_fields())
  {
    if (field.n_components == 3)
      ranges.emplace_back(column, column + 2, field.title(), component_is_part_of_vector);
    column += field.n_components;
  }
  return ranges;
}

/// The columns of one point or element of a frame, at each of the corners in `data`, in single
/// precision.
template <class Frame, class Table>
void fill(const Frame &frame, const std::size_t number,
          double (*FrameField::*value)(const Frame &, std::size_t, unsigned int), Table &data)
{
  unsigned int column = 0;
  for (const auto &field : frame_fields())
    for (unsigned int d = 0; d < field.n_components; ++d, ++column)
      for (unsigned int v = 0; v < data.size(1); ++v)
        data(column, v) = static_cast<float>((field.*value)(frame, number, d));
}

dealii::DataOutBase::VtkFlags vtk_flags(const double time)
{
  dealii::DataOutBase::VtkFlags flags;
  flags.time                = time;
  flags.print_date_and_time = false;
  // On particle data the best compression costs 26 times the time and saves a third of the space.
  flags.compression_level   = dealii::DataOutBase::VtkFlags::best_speed;
  return flags;
}

dealii::Point<3> to_point(const Vector3 &x)
{
  return {x.x(), x.y(), x.z()};
}

std::vector<dealii::DataOutBase::Patch<0, 3>> patches_of(const PointFrame &points)
{
  const std::size_t n_columns = column_names().size();
  std::vector<dealii::DataOutBase::Patch<0, 3>> patches(points.position.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    auto &patch       = patches[i];
    patch.vertices[0] = to_point(points.position[i]);
    patch.patch_index = static_cast<unsigned int>(i);
    patch.data.reinit(n_columns, 1);
    fill(points, i, &FrameField::of_point, patch.data);
  }
  return patches;
}

std::vector<dealii::DataOutBase::Patch<2, 3>> patches_of(const SurfaceFrame &surface)
{
  std::vector<dealii::DataOutBase::Patch<2, 3>> patches(surface.quads.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    auto &patch        = patches[i];
    // deal.II numbers the corners of a quadrilateral row by row, the frame runs around it.
    const int order[4] = {0, 1, 3, 2};
    for (unsigned int v = 0; v < 4; ++v)
      patch.vertices[v] = to_point(surface.vertices[surface.quads[i][order[v]]]);
    patch.patch_index    = static_cast<unsigned int>(i);
    patch.n_subdivisions = 1;
    patch.reference_cell =
        dealii::ReferenceCells::Quadrilateral; // by default none, and no cell would be written
    // Body 0, so that colouring by body works for plates and projectile together.
    const bool has_stress = !surface.von_mises.empty();
    patch.data.reinit(has_stress ? 2 : 1, 4);
    for (unsigned int v = 0; !surface.body.empty() && v < 4; ++v)
      patch.data(0, v) = static_cast<float>(surface.body[i]);
    for (unsigned int v = 0; has_stress && v < 4; ++v)
      patch.data(1, v) = static_cast<float>(surface.von_mises[i] / units::MPa);
  }
  return patches;
}

std::vector<dealii::DataOutBase::Patch<3, 3>> patches_of(const ElementFrame &elements)
{
  const std::size_t n_columns = column_names().size();
  std::vector<dealii::DataOutBase::Patch<3, 3>> patches(elements.corners.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    auto &patch = patches[i];
    for (unsigned int v = 0; v < 8; ++v)
      patch.vertices[v] = to_point(elements.corners[i][v]);
    patch.patch_index    = static_cast<unsigned int>(i);
    patch.n_subdivisions = 1;
    patch.reference_cell = dealii::ReferenceCells::Hexahedron;
    patch.data.reinit(n_columns, 8);
    fill(elements, i, &FrameField::of_element, patch.data);
  }
  return patches;
}

/// "points_0012"
std::string frame_name(const std::string &part, const unsigned int number)
{
  return part + "_" + with_zeros(number, 4);
}

/// Relative to the results folder.
std::string file_of(const std::string &part, const unsigned int number, const char *const ending)
{
  return "vtu/" + frame_name(part, number) + ending;
}

/// "points_0012.003.vtu"
std::string piece_name(const std::string &part, const unsigned int number, const int rank)
{
  return frame_name(part, number) + "." + with_zeros(rank, 3) + ".vtu";
}
/// The text of an XML file with a comment behind its declaration <?xml ... ?>, where XML allows it
/// first: the version of ricochet.
std::string signed_text(std::string xml)
{
  const std::size_t declaration = xml.find("?>");
  xml.insert(declaration == std::string::npos ? 0 : declaration + 2,
             "\n<!-- ricochet " + std::string(version()) + " -->");
  return xml;
}
} // namespace

VtuWriter::VtuWriter(const MPI_Comm comm, const std::filesystem::path &directory) :
  comm_(comm), directory_(directory)
{
  on_first_rank(comm_, [&] { make_directory(directory_ / "vtu"); });
}

/// One piece per rank and a record of all of them. Collective.
template <class Frame>
void VtuWriter::write_pieces(const std::string &name, const unsigned int number, const double time,
                             const Frame &frame) const
{
  on_every_rank(comm_,
                [&]
                {
                  std::ostringstream piece;
                  dealii::DataOutBase::write_vtu(patches_of(frame), column_names(), vector_fields(),
                                                 vtk_flags(time), piece);
                  write_file(directory_ / "vtu" / piece_name(name, number, rank_in(comm_)),
                             signed_text(piece.str()));
                });
  on_first_rank(comm_,
                [&]
                {
                  const int n_ranks = size_of(comm_);
                  std::vector<std::string> pieces;
                  pieces.reserve(n_ranks);
                  for (int rank = 0; rank < n_ranks; ++rank)
                    pieces.push_back(piece_name(name, number, rank));
                  std::ostringstream record;
                  dealii::DataOutBase::write_pvtu_record(record, pieces, column_names(),
                                                         vector_fields(), vtk_flags(time));
                  write_file(directory_ / file_of(name, number, ".pvtu"),
                             signed_text(record.str()));
                });
}

void VtuWriter::write(const unsigned int number, const double time, const PointFrame &points,
                      const SurfaceFrame &surface, const ElementFrame &elements)
{
  write_pieces("points", number, time, points);
  int n_elements = static_cast<int>(elements.corners.size());
  MPI_Allreduce(MPI_IN_PLACE, &n_elements, 1, MPI_INT, MPI_SUM, comm_);
  if (n_elements > 0)
    write_pieces("elements", number, time, elements);
  entries_.resize(number); // without the entry of an attempt that failed
  entries_.push_back({time, n_elements});
  on_first_rank(comm_,
                [&]
                {
                  write_projectile(file_of("projectile", number, ".vtu"), time, surface);
                  write_index();
                });
}

void VtuWriter::write_projectile(const std::string &file, const double time,
                                 const SurfaceFrame &surface) const
{
  std::ostringstream text;
  std::vector<std::string> names{"body"};
  if (!surface.von_mises.empty())
    names.emplace_back("von Mises stress [MPa]");
  dealii::DataOutBase::write_vtu(patches_of(surface), names, {}, vtk_flags(time), text);
  write_file(directory_ / file, signed_text(text.str()));
}

void VtuWriter::write_index() const
{
  std::ostringstream text;
  text.precision(12);
  text
      << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (unsigned int number = 0; number < entries_.size(); ++number)
  {
    const Entry &entry                                  = entries_[number];
    const std::pair<const char *, const char *> parts[] = {
        {"points", ".pvtu"}, {"projectile", ".vtu"}, {"elements", ".pvtu"}};
    for (unsigned int part = 0; part < (entry.n_elements > 0 ? 3 : 2); ++part)
      text << "    <DataSet timestep=\"" << entry.time << "\" part=\"" << part << "\" name=\""
           << parts[part].first << "\" file=\""
           << file_of(parts[part].first, number, parts[part].second) << "\"/>\n";
  }
  text << "  </Collection>\n</VTKFile>\n";
  write_file(directory_ / "results.pvd", signed_text(text.str()));
}

void VtuWriter::exchange_state(StateArchive &archive)
{
  archive.common("ParaView files", entries_);
}
} // namespace ricochet
