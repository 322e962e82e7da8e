// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/section_writer.h"

#include "hdf5_file.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"

#include <numeric>

namespace ricochet
{
namespace
{
/// The values of all ranks, one rank after the other, on rank 0; empty elsewhere. Collective.
std::vector<float> gather(const MPI_Comm comm, const std::vector<float> &values)
{
  const int n_ranks = size_of(comm);
  const int n       = static_cast<int>(values.size());
  std::vector<int> counts(n_ranks), starts(n_ranks, 0);
  MPI_Gather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, comm);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);

  std::vector<float> all(rank_in(comm) == 0 ? starts.back() + counts.back() : 0);
  MPI_Gatherv(values.data(), n, MPI_FLOAT, all.data(), counts.data(), starts.data(), MPI_FLOAT, 0,
              comm);
  return all;
}

std::vector<float> flattened(const std::vector<Vector3> &vectors)
{
  std::vector<float> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vector3 &x : vectors)
    for (int d = 0; d < 3; ++d)
      numbers.push_back(static_cast<float>(x[d]));
  return numbers;
}

std::string frame_name(const unsigned int number)
{
  return "frame_" + with_zeros(number, 4);
}
} // namespace

SectionWriter::SectionWriter(const MPI_Comm comm, const std::filesystem::path &directory) :
  comm_(comm), directory_(directory)
{
  on_first_rank(comm_, [&] { make_directory(directory_ / "section"); });
}

void SectionWriter::write(const unsigned int number, const double time, const PointFrame &points,
                          const SurfaceFrame &surface, const ElementFrame &elements)
{
  std::vector<Vector3> position;
  std::vector<float> damage, body, state[3];
  const auto add_state = [&](const StateFields &from, const std::size_t i)
  {
    state[0].push_back(static_cast<float>(from.pressure[i]));
    state[1].push_back(static_cast<float>(from.von_mises[i]));
    state[2].push_back(static_cast<float>(from.energy_density[i]));
  };
  for (std::size_t i = 0; i < points.position.size(); ++i)
    if (points.in_section[i])
    {
      position.push_back(points.position[i]);
      damage.push_back(static_cast<float>(points.damage[i]));
      body.push_back(static_cast<float>(points.body[i]));
      add_state(points.state, i);
    }
  position.insert(position.end(), elements.section_position.begin(),
                  elements.section_position.end());
  damage.resize(position.size(), 0.f); // elements do not break
  for (const int plate : elements.section_body)
    body.push_back(static_cast<float>(plate));
  for (const int element : elements.section_element)
    add_state(elements.state, element);
  const std::vector<float> all_positions = gather(comm_, flattened(position));
  const std::vector<float> all_damage    = gather(comm_, damage);
  const std::vector<float> all_bodies    = gather(comm_, body);
  for (auto &values : state)
    values = gather(comm_, values);

  on_first_rank(comm_,
                [&]
                {
                  Hdf5File frame;
                  frame.set_attribute("time_s", time);
                  frame.add("position", all_positions, 3, "m");
                  frame.add("damage", all_damage, 1, "-");
                  frame.add("body", std::vector<int>(all_bodies.begin(), all_bodies.end()), 1, "-");
                  frame.add("pressure", state[0], 1, "Pa");
                  frame.add("von_mises", state[1], 1, "Pa");
                  frame.add("energy_density", state[2], 1, "J/m3");
                  frame.add("outline", flattened(surface.outline), 3, "m");
                  for (std::size_t i = 0; i < surface.further_outlines.size(); ++i)
                    frame.add("outline " + std::to_string(i + 2),
                              flattened(surface.further_outlines[i]), 3, "m");
                  frame.save(directory_ / "section" / (frame_name(number) + ".h5"));

                  Hdf5File index;
                  for (unsigned int i = 0; i <= number; ++i)
                    index.link(frame_name(i), "section/" + frame_name(i) + ".h5");
                  index.save(directory_ / "section.h5");
                });
}
} // namespace ricochet
