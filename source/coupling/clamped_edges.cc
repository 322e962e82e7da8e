// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/clamped_edges.h"

#include <Eigen/Geometry>

namespace ricochet
{
ClampedEdges::ClampedEdges(const MPI_Comm communicator, PeridynamicBody &points,
                           FiniteElementBody *const elements, const ClampedSides sides,
                           const double width) :
  communicator_(communicator),
  points_(points), elements_(elements), sides_(sides), width_(width),
  impulse_of_points_(points.lattice().box().n[0])
{
  find_points();
  if (elements_ == nullptr)
    return;
  const auto &mesh = elements_->mesh();
  for (int node = 0; node < mesh.n_nodes(); ++node)
    if (holds(mesh.reference_position(node)))
    {
      for (int d = 0; d < 3; ++d)
        elements_->fix(node, d);
      if (node < mesh.n_owned_nodes())
        held_nodes_.push_back(node);
    }
}

bool ClampedEdges::holds(const Vector3 &reference) const
{
  const auto &box         = points_.lattice().box();
  const Vector3 far       = box.corner + box.spacing * Vector3(box.n[0], box.n[1], box.n[2]);
  const bool ends         = sides_ == ClampedSides::ends || sides_ == ClampedSides::all;
  const bool sides        = sides_ == ClampedSides::sides || sides_ == ClampedSides::all;
  const double y_low      = box.mirror_y ? -far.y() : box.corner.y();
  constexpr double inside = 1. + 1e-9; // a node at the width belongs to the frame
  const auto near         = [&](const double distance) { return distance <= inside * width_; };
  return (ends && (near(reference.x() - box.corner.x()) || near(far.x() - reference.x()))) ||
         (sides && (near(reference.y() - y_low) || near(far.y() - reference.y())));
}

void ClampedEdges::find_points()
{
  held_points_.clear();
  const Lattice &lattice = points_.lattice();
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        // What follows elements is held by them.
        if (lattice.free(p) && holds(lattice.reference_position(lattice.coordinates(p))))
          held_points_.push_back({p, Vector3::Zero()});
      });
}

void ClampedEdges::bodies_changed()
{
  find_points();
  const Lattice &lattice = points_.lattice();
  impulse_of_points_.move_home(communicator_, lattice.first_plane(),
                               lattice.first_plane() + lattice.n_planes());
}

void ClampedEdges::add_forces(const double dt)
{
  auto &a = points_.state().arrays;
  for (auto &[p, reaction] : held_points_)
    for (int d = 0; d < 3; ++d)
    {
      // It rests from now on, whatever it did before.
      reaction[d]      = -a.force[d][p] - points_.point_mass() / dt * a.velocity[d][p];
      a.force[d][p]    = 0.;
      a.velocity[d][p] = 0.;
    }
}

template <class Visitor>
void ClampedEdges::for_each_node(Visitor &&visit) const
{
  for (const int node : held_nodes_)
    visit(node, Vector3(-elements_->uncorrected_force(node)));
}

void ClampedEdges::record_work(const double dt)
{
  const auto &a = points_.state().arrays;
  for (const auto &[p, reaction] : held_points_)
  {
    auto &sum            = impulse_of_points_[points_.lattice().plane_of(p)];
    const Vector3 linear = dt * reaction,
                  angular =
                      Vector3(a.position[0][p], a.position[1][p], a.position[2][p]).cross(linear);
    for (int d = 0; d < 3; ++d)
    {
      sum[d] += linear[d];
      sum[3 + d] += angular[d];
    }
  }
  for_each_node(
      [&](const int node, const Vector3 &reaction)
      {
        impulse_of_nodes_.linear += dt * reaction;
        impulse_of_nodes_.angular +=
            dt * Eigen::Map<const Vector3>(elements_->position().data() + 3 * node).cross(reaction);
      });
}

Vector3 ClampedEdges::whole(const Vector3 &linear) const
{
  const double multiplicity = points_.multiplicity();
  return {multiplicity * linear.x(), multiplicity == 2. ? 0. : linear.y(),
          multiplicity * linear.z()};
}

Vector3 ClampedEdges::reaction() const
{
  PlaneSums<3> of_points(points_.lattice().box().n[0]);
  for (const auto &[p, reaction] : held_points_)
    for (int d = 0; d < 3; ++d)
      of_points[points_.lattice().plane_of(p)][d] += reaction[d];
  Vector3 of_nodes = Vector3::Zero();
  for_each_node([&](int, const Vector3 &reaction) { of_nodes += reaction; });
  MPI_Allreduce(MPI_IN_PLACE, of_nodes.data(), 3, MPI_DOUBLE, MPI_SUM, communicator_);
  const auto sum = of_points.total(communicator_);
  return whole(Vector3(sum[0], sum[1], sum[2]) + of_nodes);
}

Momenta ClampedEdges::impulse() const
{
  Momenta impulse = impulse_of_nodes_;
  for (Vector3 *const v : {&impulse.linear, &impulse.angular})
    MPI_Allreduce(MPI_IN_PLACE, v->data(), 3, MPI_DOUBLE, MPI_SUM, communicator_);
  const auto sum = impulse_of_points_.total(communicator_);
  impulse.linear += Vector3(sum[0], sum[1], sum[2]);
  impulse.angular += Vector3(sum[3], sum[4], sum[5]);
  return points_.multiplicity() * impulse;
}

void ClampedEdges::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "clamped edges");
  PlaneArchive(archive, communicator_, points_.lattice())
      .sums("impulse of points", impulse_of_points_);
  archive.by_rank("impulse of nodes", impulse_of_nodes_.linear.data(), 3);
  archive.by_rank("angular impulse of nodes", impulse_of_nodes_.angular.data(), 3);
}
} // namespace ricochet
