// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/surface_contact.h"

#include "field_values.h"
#include "ricochet/base/mpi_tools.h"
#include "surface_tangents.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace ricochet
{
namespace
{
Eigen::Map<const Vector3> of_node(const std::vector<double> &values, const int node)
{
  return Eigen::Map<const Vector3>(values.data() + 3 * node);
}

/// Velocity of a point relative to the surface, along the two tangents [m/s].
Eigen::Vector2d sliding_velocity_on(const SurfaceTangents &tangents, const SurfaceQuad &quad,
                                    const Vector3 &velocity, const SurfaceNodes &body)
{
  Eigen::Vector2d sliding;
  for (int i = 0; i < 2; ++i)
  {
    sliding[i] = velocity.dot(tangents.direction[i]);
    for (int node = 0; node < 4; ++node)
      sliding[i] -= tangents.on_node[i][node].dot(of_node(body.velocity, quad[node]));
  }
  return sliding;
}

Vector3 mirrored(const Vector3 &v)
{
  return {v.x(), -v.y(), v.z()};
}

const SurfaceQuad &quad_of(const double face, const FacetedSurface &surface)
{
  return surface.faces()[static_cast<std::size_t>(face)];
}

/// Adds a load to the nodes of its face.
void add_to_nodes(const double (&load)[12], const SurfaceQuad &quad, std::vector<double> &values)
{
  for (int node = 0; node < 4; ++node)
    for (int d = 0; d < 3; ++d)
      values[3 * quad[node] + d] += load[3 * node + d];
}

/// Moment of a load about `centre` [N m].
Vector3 moment_of(const double (&load)[12], const SurfaceQuad &quad, const SurfaceNodes &body,
                  const Vector3 &centre)
{
  Vector3 moment = Vector3::Zero();
  for (int node = 0; node < 4; ++node)
    moment += Vector3(of_node(body.position, quad[node]) - centre)
                  .cross(Eigen::Map<const Vector3>(load + 3 * node));
  return moment;
}

/// Adds the half behind the symmetry plane.
void add_mirrored_half(ContactRecord &record)
{
  for (Vector3 *force : {&record.normal, &record.friction, &record.shank})
    *force = Vector3(2. * force->x(), 0., 2. * force->z());
  for (Vector3 *moment : {&record.moment, &record.friction_moment})
    *moment = Vector3(0., 2. * moment->y(), 0.);
  record.energy *= 2.;
  record.n_touching *= 2.;
}
} // namespace

SurfaceContact::SurfaceContact(const MPI_Comm communicator, const FrictionLaw &law,
                               const Parameters &parameters, const bool mirrored,
                               const int n_planes, const std::vector<char> &is_shank) :
  communicator_(communicator),
  law_(law), pair_law_(parameters), multiplicity_(mirrored ? 2. : 1.), is_shank_(is_shank),
  work_(n_planes)
{
}

double SurfaceContact::add_normal_forces(const SurfaceNodes &body, const FacetedSurface &surface,
                                         PeridynamicBody &plate)
{
  find_touching(surface, plate);
  std::vector<NormalLoad> loads;
  for (const auto &touching : touching_)
    loads.push_back(press(touching, surface, plate));
  normal_loads_ = gather_on_every_rank(communicator_, loads);
  std::array<double, 2> largest{deepest_, on_elements_};
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), 2, MPI_DOUBLE, MPI_MAX, communicator_);
  deepest_     = largest[0];
  on_elements_ = largest[1];
  spacing_     = plate.lattice().box().spacing;

  std::vector<double> shares(body.mobility.size(), 0.); // of the touches at each node
  for (const auto &load : normal_loads_)
  {
    const auto &quad = quad_of(load.face, surface);
    add_to_nodes(load.on_nodes, quad, body.force);
    for (int node = 0; node < 4; ++node)
    {
      // The other half touches a node on the mirror plane as often.
      const bool halved =
          multiplicity_ == 2. && std::abs(surface.node(quad[node]).y()) < 1e-6 * spacing_;
      shares[quad[node]] += (halved ? 2. : 1.) * load.reach[node];
    }
  }
  return shares.empty() ? 0. : *std::max_element(shares.begin(), shares.end());
}

void SurfaceContact::find_touching(const FacetedSurface &surface, const PeridynamicBody &plate)
{
  const Lattice &lattice = plate.lattice();
  const auto &a          = plate.state().arrays;
  const double radius    = lattice.box().spacing / 2.;
  const auto [low, high] = surface.bounding_box();
  Vector3 first = low - Vector3::Constant(radius), last = high + Vector3::Constant(radius);
  // A point that has crossed the symmetry plane touches the other half as its image touches this
  // one.
  const bool symmetric = multiplicity_ == 2.;
  if (symmetric)
    first.y() = -last.y();
  const std::vector<std::ptrdiff_t> were_deep = std::move(deep_); // ascending
  deep_.clear();
  touching_.clear();
  deepest_ = on_elements_ = 0.;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (is_outside(a.position, p, first, last))
          return;
        Vector3 x = at(a.position, p);
        Touching touching{p, symmetric && x.y() < 0., {}, 0.};
        if (touching.crossed)
          x = mirrored(x);
        if (!surface.hit(x, touching.hit))
        {
          if (!std::binary_search(were_deep.begin(), were_deep.end(), p))
            return;
          touching.hit = surface.nearest(x);
        }
        touching.depth = radius - touching.hit.distance;
        if (touching.depth <= 0.)
          return;
        if (touching.depth > radius) // its centre is inside
          deep_.push_back(p);
        touching_.push_back(touching);
        deepest_ = std::max(deepest_, touching.depth);
        if (!lattice.free(p))
          on_elements_ = 1.;
      });
}

/// A point's normal force.
SurfaceContact::NormalLoad SurfaceContact::press(const Touching &touching,
                                                 const FacetedSurface &surface,
                                                 PeridynamicBody &plate)
{
  const auto &[p, crossed, hit, depth] = touching;
  const SurfaceTangents tangents(surface, hit);
  const Vector3 force = pair_law_.normal_force(depth) * hit.normal;
  auto &a             = plate.state().arrays;
  for (int d = 0; d < 3; ++d)
    a.force[d][p] += crossed ? mirrored(force)[d] : force[d];
  NormalLoad load;
  load.face   = hit.face;
  load.energy = pair_law_.energy(depth);
  for (int node = 0; node < 4; ++node)
  {
    load.reach[node] = tangents.reach(node);
    for (int d = 0; d < 3; ++d)
      load.on_nodes[3 * node + d] = -hit.weights[node] * force[d];
  }
  return load;
}

ContactRecord SurfaceContact::add_friction(const SurfaceNodes &body, const double shares,
                                           const FacetedSurface &surface, const Vector3 &centre,
                                           PeridynamicBody &plate, const double dt)
{
  work_.clear();
  std::vector<FrictionLoad> loads;
  for (const auto &touching : touching_)
    loads.push_back(rub(touching, body, shares, surface, plate, dt));
  friction_loads_ = gather_on_every_rank(communicator_, loads);
  friction_.assign(body.force.size(), 0.);
  for (const auto &load : friction_loads_)
    add_to_nodes(load.on_nodes, quad_of(load.face, surface), friction_);
  for (std::size_t i = 0; i < friction_.size(); ++i)
    body.force[i] += friction_[i];
  return record(body, surface, centre);
}

/// A point's friction.
SurfaceContact::FrictionLoad SurfaceContact::rub(const Touching &touching, const SurfaceNodes &body,
                                                 const double shares, const FacetedSurface &surface,
                                                 PeridynamicBody &plate, const double dt)
{
  const auto &[p, crossed, hit, depth] = touching;
  auto &a                              = plate.state().arrays;
  const auto &quad                     = surface.faces()[hit.face];
  const SurfaceTangents tangents(surface, hit);
  // What follows elements gets more than its own forces: its velocity is taken as it is.
  const double half_kick = plate.lattice().free(p) ? dt / (2. * plate.point_mass()) : 0.;
  Vector3 velocity       = at(a.velocity, p) + half_kick * at(a.force, p);
  if (crossed)
    velocity = mirrored(velocity);
  const Eigen::Vector2d sliding = sliding_velocity_on(tangents, quad, velocity, body);
  double compliance             = 1. / plate.point_mass();
  for (int node = 0; node < 4; ++node)
    compliance += shares * tangents.reach(node) * body.mobility[quad[node]];

  const double speed      = sliding.norm();
  const double mu         = law_.coefficient(speed);
  const double normal     = pair_law_.normal_force(depth);
  const double shank_push = is_shank_[hit.face] ? pair_law_.shank_push(normal) : 0.;
  const double push       = normal + shank_push;
  // Along the tangents [N].
  const Eigen::Vector2d on_point =
      -pair_law_.resistance(speed, mu * push, compliance, dt) * sliding;
  const Vector3 in_space =
      on_point[0] * tangents.direction[0] + on_point[1] * tangents.direction[1];
  const Vector3 force = crossed ? mirrored(in_space) : in_space;
  for (int d = 0; d < 3; ++d)
    a.force[d][p] += force[d];
  work_.add(plate, p, force);

  FrictionLoad load;
  load.face = hit.face;
  for (int d = 0; d < 3; ++d)
  {
    load.coulomb[d] = -normal / push * in_space[d];
    load.shank[d]   = -shank_push / push * in_space[d];
    for (int node = 0; node < 4; ++node)
      load.on_nodes[3 * node + d] =
          -on_point[0] * tangents.on_node[0][node][d] - on_point[1] * tangents.on_node[1][node][d];
  }
  return load;
}

/// Of all that has been added.
ContactRecord SurfaceContact::record(const SurfaceNodes &body, const FacetedSurface &surface,
                                     const Vector3 &centre) const
{
  ContactRecord record;
  record.deepest             = deepest_;
  record.deepest_in_spacings = deepest_ / spacing_;
  record.on_elements         = on_elements_ > 0.;
  for (const auto &load : normal_loads_)
  {
    for (int node = 0; node < 4; ++node)
      record.normal += Eigen::Map<const Vector3>(load.on_nodes + 3 * node);
    record.moment += moment_of(load.on_nodes, quad_of(load.face, surface), body, centre);
    record.energy += load.energy;
    record.n_touching += 1.;
  }
  for (const auto &load : friction_loads_)
  {
    record.friction += Eigen::Map<const Vector3>(load.coulomb);
    record.shank += Eigen::Map<const Vector3>(load.shank);
    record.friction_moment += moment_of(load.on_nodes, quad_of(load.face, surface), body, centre);
  }
  record.moment += record.friction_moment;
  if (multiplicity_ == 2.)
    add_mirrored_half(record);
  return record;
}

ContactRecord SurfaceContact::add_forces(const SurfaceNodes &body, const FacetedSurface &surface,
                                         const Vector3 &centre, PeridynamicBody &plate,
                                         const double dt)
{
  const double shares = add_normal_forces(body, surface, plate);
  return add_friction(body, shares, surface, centre, plate, dt);
}
} // namespace ricochet
