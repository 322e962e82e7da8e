// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/surface_contact.h"

#include "field_values.h"
#include "surface_tangents.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>

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

ContactRecord SurfaceContact::add_forces(const SurfaceNodes &body, const FacetedSurface &surface,
                                         const Vector3 &centre, PeridynamicBody &plate)
{
  find_loads(body, surface, plate);
  const auto all = gather();
  std::array<double, 2> largest{deepest_, on_elements_};
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), 2, MPI_DOUBLE, MPI_MAX, communicator_);

  ContactRecord record;
  record.deepest             = largest[0];
  record.deepest_in_spacings = largest[0] / plate.lattice().box().spacing;
  record.on_elements         = largest[1] > 0.;
  friction_.assign(body.force.size(), 0.);
  for (const auto &load : all)
    apply(load, surface, centre, body, record);
  if (multiplicity_ == 2.)
    add_mirrored_half(record);
  return record;
}

void SurfaceContact::find_loads(const SurfaceNodes &body, const FacetedSurface &surface,
                                PeridynamicBody &plate)
{
  const Lattice &lattice = plate.lattice();
  const auto &a          = plate.state().arrays;
  const double radius    = lattice.box().spacing / 2.;
  const auto [low, high] = surface.bounding_box();
  Vector3 first = low - Vector3::Constant(radius), last = high + Vector3::Constant(radius);
  // A point that has crossed the symmetry plane touches the other half as its image touches this
  // one.
  const bool mirrored = multiplicity_ == 2.;
  if (mirrored)
    first.y() = -last.y();
  const std::vector<std::ptrdiff_t> were_deep = std::move(deep_); // ascending
  deep_.clear();
  loads_.clear();
  work_.clear();
  deepest_ = on_elements_ = 0.;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (is_outside(a.position, p, first, last))
          return;
        Vector3 x = at(a.position, p);
        Touching touching{p, mirrored && x.y() < 0., at(a.velocity, p), {}, 0.};
        if (touching.crossed)
          for (Vector3 *v : {&x, &touching.velocity})
            v->y() = -v->y();
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
        add_point_load(touching, body, surface, plate);
      });
}

/// Adds the forces on a point and lists those on the face.
void SurfaceContact::add_point_load(const Touching &touching, const SurfaceNodes &body,
                                    const FacetedSurface &surface, PeridynamicBody &plate)
{
  auto &a                                        = plate.state().arrays;
  const auto &[p, crossed, velocity, hit, depth] = touching;
  const SurfaceTangents tangents(surface, hit);
  const Eigen::Vector2d sliding =
      sliding_velocity_on(tangents, surface.faces()[hit.face], velocity, body);
  const double speed              = sliding.norm();
  const double mu                 = law_.coefficient(speed);
  const double normal             = pair_law_.normal_force(depth);
  const double coulomb            = pair_law_.friction_limit(mu, normal);
  const double shank              = is_shank_[hit.face] ? pair_law_.shank_limit(mu) : 0.;
  const Eigen::Vector2d direction = pair_law_.direction(sliding, speed);
  const Eigen::Vector2d on_point  = (coulomb + shank) * direction; // along the tangents [N]

  const auto in_space = [&](const Eigen::Vector2d &f) -> Vector3
  { return f[0] * tangents.direction[0] + f[1] * tangents.direction[1]; };
  Vector3 friction = in_space(on_point), total = normal * hit.normal + friction;
  if (crossed)
    for (Vector3 *v : {&friction, &total})
      v->y() = -v->y();
  for (int d = 0; d < 3; ++d)
    a.force[d][p] += total[d];
  work_.add(plate, p, friction);

  Load load;
  load.face                      = hit.face;
  load.energy                    = pair_law_.energy(depth);
  const Vector3 coulomb_in_space = in_space(coulomb * direction),
                shank_in_space   = in_space(shank * direction);
  for (int d = 0; d < 3; ++d)
  {
    load.coulomb[d] = -coulomb_in_space[d];
    load.shank[d]   = -shank_in_space[d];
    for (int node = 0; node < 4; ++node)
    {
      load.normal[3 * node + d] = -hit.weights[node] * normal * hit.normal[d];
      load.friction[3 * node + d] =
          -on_point[0] * tangents.on_node[0][node][d] - on_point[1] * tangents.on_node[1][node][d];
    }
  }
  loads_.push_back(load);
  deepest_ = std::max(deepest_, depth);
  if (!plate.lattice().free(p))
    on_elements_ = 1.;
}

std::vector<SurfaceContact::Load> SurfaceContact::gather() const
{
  int n_ranks;
  MPI_Comm_size(communicator_, &n_ranks);
  if (n_ranks == 1)
    return loads_;
  constexpr int size = sizeof(Load) / sizeof(double);
  std::vector<int> counts(n_ranks), starts(n_ranks, 0);
  const int n = size * static_cast<int>(loads_.size());
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator_);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<Load> all((starts.back() + counts.back()) / size);
  MPI_Allgatherv(loads_.data(), n, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE,
                 communicator_);
  return all;
}

/// Adds a load to the body's nodes and to the record.
void SurfaceContact::apply(const Load &load, const FacetedSurface &surface, const Vector3 &centre,
                           const SurfaceNodes &body, ContactRecord &record)
{
  const auto &quad = surface.faces()[static_cast<std::size_t>(load.face)];
  for (int node = 0; node < 4; ++node)
  {
    const Eigen::Map<const Vector3> normal(load.normal + 3 * node),
        friction(load.friction + 3 * node);
    const Vector3 arm = of_node(body.position, quad[node]) - centre;
    record.normal += normal;
    record.moment += arm.cross(normal + friction);
    record.friction_moment += arm.cross(friction);
    for (int d = 0; d < 3; ++d)
    {
      body.force[3 * quad[node] + d] += normal[d] + friction[d];
      friction_[3 * quad[node] + d] += friction[d];
    }
  }
  record.friction += Eigen::Map<const Vector3>(load.coulomb);
  record.shank += Eigen::Map<const Vector3>(load.shank);
  record.energy += load.energy;
  record.n_touching += 1.;
}
} // namespace ricochet
