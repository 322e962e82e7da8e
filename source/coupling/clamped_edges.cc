// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/clamped_edges.h"

#include "ricochet/base/exact_sum.h"

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
        held_nodes_.push_back({node, {}});
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
  for (auto &[node, impulse] : held_nodes_)
  {
    const Vector3 reaction = -elements_->uncorrected_force(node);
    impulse.linear += dt * reaction;
    impulse.angular +=
        dt * Eigen::Map<const Vector3>(elements_->position().data() + 3 * node).cross(reaction);
  }
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
  std::array<ExactSum, 3> of_nodes;
  for (const auto &held : held_nodes_)
  {
    const Vector3 reaction = -elements_->uncorrected_force(held.node);
    for (int d = 0; d < 3; ++d)
      of_nodes[d].add(reaction[d]);
  }
  const auto sum = of_points.total(communicator_), nodes = totals(communicator_, of_nodes);
  return whole({sum[0] + nodes[0], sum[1] + nodes[1], sum[2] + nodes[2]});
}

Momenta ClampedEdges::impulse() const
{
  std::array<ExactSum, 6> of_nodes;
  for (const auto &held : held_nodes_)
    for (int d = 0; d < 3; ++d)
    {
      of_nodes[d].add(held.impulse.linear[d]);
      of_nodes[3 + d].add(held.impulse.angular[d]);
    }
  const auto sum = impulse_of_points_.total(communicator_), nodes = totals(communicator_, of_nodes);
  const Momenta impulse{{sum[0] + nodes[0], sum[1] + nodes[1], sum[2] + nodes[2]},
                        {sum[3] + nodes[3], sum[4] + nodes[4], sum[5] + nodes[5]}};
  return points_.multiplicity() * impulse;
}

void ClampedEdges::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "clamped edges");
  PlaneArchive(archive, communicator_, points_.lattice())
      .sums("impulse of points", impulse_of_points_);
  if (elements_ == nullptr)
    return;
  const auto &mesh = elements_->mesh();
  std::vector<std::int64_t> places;
  std::vector<double> impulses;
  for (const auto &[node, impulse] : held_nodes_)
  {
    places.push_back(mesh.place_number(mesh.reference_position(node)));
    for (const Vector3 *const v : {&impulse.linear, &impulse.angular})
      impulses.insert(impulses.end(), v->data(), v->data() + 3);
  }
  archive.rows("impulse of nodes", places, impulses, 6);
  const double *next = impulses.data();
  for (auto &held : held_nodes_)
    for (Vector3 *const v : {&held.impulse.linear, &held.impulse.angular})
    {
      *v = Eigen::Map<const Vector3>(next);
      next += 3;
    }
}
} // namespace ricochet
