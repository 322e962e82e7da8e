// SPDX-License-Identifier: LGPL-2.1-or-later
// What a Simulation says of its present state: frames, complaints.
#include "element_frame.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/coupling/plate_stress.h"
#include "ricochet/simulation/simulation.h"

#include <limits>
#include <sstream>

namespace ricochet
{
namespace
{
Vector3 at(double *const field[3], const std::ptrdiff_t p)
{
  return {field[0][p], field[1][p], field[2][p]};
}
} // namespace

void Simulation::check_finite() const
{
  const std::string remedy =
      scene_.zone.has_elements()
          ? "Lower 'Time/Safety factor' or 'Contact/Stiffness factor', or choose another "
            "'Coupling/Method'."
          : "Lower 'Time/Safety factor' or 'Contact/Stiffness factor'.";
  const auto complain = [&](const std::string &what)
  {
    std::ostringstream message;
    message << what << " is not a number at " << 1e6 * time_ << " us (step " << step_ << "). "
            << remedy;
    return message.str();
  };
  for (std::size_t i = 0; i < projectiles_.size(); ++i) // the same on all ranks
    if (const auto found = projectiles_[i]->first_not_finite(); !found.empty())
      throw RunError(
          complain(i == 0 ? found : found + " (projectile " + std::to_string(i + 1) + ")"));
  // The first one in the order of plates is reported, by the lowest rank that has one.
  std::string complaint;
  for (std::size_t i = 0; i < plates_.size() && complaint.empty(); ++i)
    if (const auto found = plates_[i].body->first_not_finite(); !found.empty())
      complaint = complain(found + " of plate " + std::to_string(i + 1));
  int rank, bad;
  MPI_Comm_rank(communicator_, &rank);
  const int mine = complaint.empty() ? std::numeric_limits<int>::max() : rank;
  MPI_Allreduce(&mine, &bad, 1, MPI_INT, MPI_MIN, communicator_);
  if (bad == std::numeric_limits<int>::max())
    return;
  throw RunError(broadcast(communicator_, complaint, bad));
}

std::string Simulation::describe_fastest_point() const
{
  struct
  {
    double speed;
    int rank;
  } fastest{-1., 0};
  std::ostringstream text;
  for (std::size_t i = 0; i < plates_.size(); ++i)
    plates_[i].points->lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (const double speed = at(plates_[i].points->state().arrays.velocity, p).norm();
              speed > fastest.speed)
          {
            const auto c  = plates_[i].points->lattice().coordinates(p);
            fastest.speed = speed;
            text.str("");
            text << "Point (" << c[0] << ", " << c[1] << ", " << c[2] << ") of plate " << i + 1
                 << " is the fastest, at " << speed << " m/s.";
          }
        });
  MPI_Comm_rank(communicator_, &fastest.rank);
  MPI_Allreduce(MPI_IN_PLACE, &fastest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator_);
  return broadcast(communicator_, text.str(), fastest.rank);
}

PointFrame Simulation::points(const FrameExtent extent) const
{
  PointFrame frame;
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    const auto &plate      = *plates_[i].points;
    const Lattice &lattice = plate.lattice();
    const auto &a          = plate.state().arrays;
    const int section      = section_layer(lattice.box());
    std::vector<std::ptrdiff_t> shown;
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const bool in_section = lattice.coordinates(p)[1] == section;
          if (extent == FrameExtent::section && !in_section)
            return;
          shown.push_back(p);
          frame.in_section.push_back(in_section);
        });
    for (const auto &state : plate_stress(plate, plates_[i].coupled, shown))
      frame.state.add(state);
    for (const std::ptrdiff_t p : shown)
    {
      const Vector3 x = at(a.position, p);
      frame.position.push_back(x);
      frame.displacement.push_back(x - lattice.reference_position(lattice.coordinates(p)));
      frame.velocity.push_back(at(a.velocity, p));
      frame.damage.push_back(plate.damage(p));
      frame.body.push_back(static_cast<int>(i) + 1);
    }
  }
  return frame;
}

SurfaceFrame Simulation::surface() const
{
  SurfaceFrame frame = projectiles_.front()->surface();
  for (std::size_t i = 1; i < projectiles_.size(); ++i)
    frame.add(projectiles_[i]->surface());
  return frame;
}

ElementFrame Simulation::elements(const FrameExtent extent) const
{
  ElementFrame frame;
  for (std::size_t i = 0; i < plates_.size(); ++i)
    if (const auto *const coupled = plates_[i].coupled)
      add_elements(*coupled, static_cast<int>(i) + 1, extent, frame);
  return frame;
}
} // namespace ricochet
