// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/surface_contact.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace ricochet
{
namespace
{
/// Forces on the four nodes of a face that are equivalent to unit forces along the two tangents,
/// acting at the distance phi from the face's nearest point: N_a e_i plus a couple along n.
struct Tangents
{
  Vector3 direction[2];
  Vector3 on_node[2][4]; // [-]

  Tangents(const FacetedSurface &surface, const FacetedSurface::Hit &hit)
  {
    const Vector3 &n     = hit.normal;
    const auto &quad     = surface.faces()[hit.face];
    const Vector3 along  = surface.node(quad[2]) - surface.node(quad[0]);
    const Vector3 across = surface.node(quad[3]) - surface.node(quad[1]);
    // At an edge n may point along one of the diagonals, but not along both.
    const Vector3 &longer =
        std::abs(n.dot(along)) * across.norm() < std::abs(n.dot(across)) * along.norm() ? along
                                                                                        : across;
    direction[0] = (longer - n.dot(longer) * n).normalized();
    direction[1] = n.cross(direction[0]);

    // With in-plane places (s, t) about the mean and g = alpha s + beta t, the couple g_a n of the
    // unit force along the tangent i needs sum g s = -phi for i = 0, sum g t = -phi for i = 1.
    Vector3 mean = Vector3::Zero();
    for (const int node : quad)
      mean += 0.25 * surface.node(node);
    Eigen::Vector2d place[4];
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (int a = 0; a < 4; ++a)
    {
      const Vector3 arm = surface.node(quad[a]) - mean;
      place[a]          = {arm.dot(direction[0]), arm.dot(direction[1])};
      second += place[a] * place[a].transpose();
    }
    const Eigen::Matrix2d slopes = -hit.distance * second.inverse();
    for (int i = 0; i < 2; ++i)
      for (int a = 0; a < 4; ++a)
        on_node[i][a] = hit.weights[a] * direction[i] + slopes.col(i).dot(place[a]) * n;
  }
};

Vector3 at(const double *const field[3], const std::ptrdiff_t p)
{
  return {field[0][p], field[1][p], field[2][p]};
}

Eigen::Map<const Vector3> at(const std::vector<double> &values, const int node)
{
  return Eigen::Map<const Vector3>(values.data() + 3 * node);
}
} // namespace

SurfaceContact::SurfaceContact(const MPI_Comm communicator, const FrictionLaw &law,
                               const Parameters &parameters, const bool mirrored,
                               const int n_planes, const std::vector<char> &is_shank) :
  communicator_(communicator),
  law_(law), parameters_(parameters), multiplicity_(mirrored ? 2. : 1.), is_shank_(is_shank),
  work_(n_planes)
{
}

void SurfaceContact::find_loads(const SurfaceNodes &body, const FacetedSurface &surface,
                                PeridynamicBody &plate)
{
  const Lattice &lattice = plate.lattice();
  auto &a                = plate.state().arrays;
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
  active_.clear();
  deepest_ = on_elements_ = 0.;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (a.position[0][p] < first.x() || a.position[0][p] > last.x() ||
            a.position[2][p] < first.z() || a.position[2][p] > last.z() ||
            a.position[1][p] < first.y() || a.position[1][p] > last.y())
          return;
        Vector3 x = at(a.position, p), velocity = at(a.velocity, p);
        const bool crossed = mirrored && x.y() < 0.;
        if (crossed)
        {
          x.y()        = -x.y();
          velocity.y() = -velocity.y();
        }
        FacetedSurface::Hit hit;
        if (!surface.hit(x, hit))
        {
          if (!std::binary_search(were_deep.begin(), were_deep.end(), p))
            return;
          hit = surface.nearest(x);
        }
        const double depth = radius - hit.distance;
        if (depth <= 0.)
          return;
        if (depth > radius) // its centre is inside
          deep_.push_back(p);

        const Tangents tangents(surface, hit);
        const auto &quad = surface.faces()[hit.face];
        Eigen::Vector2d sliding;
        for (int i = 0; i < 2; ++i)
        {
          sliding[i] = velocity.dot(tangents.direction[i]);
          for (int node = 0; node < 4; ++node)
            sliding[i] -= tangents.on_node[i][node].dot(at(body.velocity, quad[node]));
        }
        const double speed = sliding.norm();
        const Eigen::Vector2d against =
            -sliding / std::max(speed, parameters_.regularisation_speed);
        const double mu            = law_.coefficient(speed);
        const double pressure      = parameters_.stiffness * depth;
        const double shank         = is_shank_[hit.face] ? mu * parameters_.shank_force : 0.;
        const Eigen::Vector2d drag = (mu * pressure + shank) * against;

        const auto in_space = [&](const Eigen::Vector2d &f) -> Vector3
        { return f[0] * tangents.direction[0] + f[1] * tangents.direction[1]; };
        Vector3 friction = in_space(drag), total = pressure * hit.normal + friction;
        if (crossed)
          for (Vector3 *v : {&friction, &total})
            v->y() = -v->y();
        for (int d = 0; d < 3; ++d)
          a.force[d][p] += total[d];
        active_.push_back({p, friction, at(a.velocity, p)});

        Load load;
        load.face           = hit.face;
        load.energy         = 0.5 * pressure * depth;
        const Vector3 slide = in_space(mu * pressure * against), along = in_space(shank * against);
        for (int d = 0; d < 3; ++d)
        {
          load.sliding[d] = -slide[d];
          load.shank[d]   = -along[d];
          for (int node = 0; node < 4; ++node)
          {
            load.normal[3 * node + d] = -hit.weights[node] * pressure * hit.normal[d];
            load.friction[3 * node + d] =
                -drag[0] * tangents.on_node[0][node][d] - drag[1] * tangents.on_node[1][node][d];
          }
        }
        loads_.push_back(load);
        deepest_ = std::max(deepest_, depth);
        if (!lattice.free(p))
          on_elements_ = 1.;
      });
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

SurfaceContact::Reaction SurfaceContact::evaluate(const SurfaceNodes &body,
                                                  const FacetedSurface &surface,
                                                  const Vector3 &centre, PeridynamicBody &plate)
{
  find_loads(body, surface, plate);
  const auto all = gather();
  std::array<double, 2> largest{deepest_, on_elements_};
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), 2, MPI_DOUBLE, MPI_MAX, communicator_);

  Reaction reaction;
  reaction.deepest     = largest[0];
  reaction.on_elements = largest[1] > 0.;
  friction_.assign(body.force.size(), 0.);
  for (const auto &load : all)
  {
    const auto &quad = surface.faces()[static_cast<std::size_t>(load.face)];
    for (int node = 0; node < 4; ++node)
    {
      const Eigen::Map<const Vector3> normal(load.normal + 3 * node),
          friction(load.friction + 3 * node);
      const Vector3 arm = at(body.position, quad[node]) - centre;
      reaction.normal += normal;
      reaction.moment += arm.cross(normal + friction);
      reaction.friction_moment += arm.cross(friction);
      for (int d = 0; d < 3; ++d)
      {
        body.force[3 * quad[node] + d] += normal[d] + friction[d];
        friction_[3 * quad[node] + d] += friction[d];
      }
    }
    reaction.friction += Eigen::Map<const Vector3>(load.sliding);
    reaction.shank += Eigen::Map<const Vector3>(load.shank);
    reaction.energy += load.energy;
    reaction.n_touching += 1.;
  }
  if (multiplicity_ == 2.)
  {
    for (Vector3 *force : {&reaction.normal, &reaction.friction, &reaction.shank})
      *force = Vector3(2. * force->x(), 0., 2. * force->z());
    for (Vector3 *moment : {&reaction.moment, &reaction.friction_moment})
      *moment = Vector3(0., 2. * moment->y(), 0.);
    reaction.energy *= 2.;
    reaction.n_touching *= 2.;
  }
  return reaction;
}

void SurfaceContact::record_work(const PeridynamicBody &plate, const double dt)
{
  const auto &a = plate.state().arrays;
  for (const auto &touch : active_)
    work_[plate.lattice().plane_of(touch.point)][0] +=
        0.5 * dt * touch.friction.dot(touch.velocity + at(a.velocity, touch.point));
}

double SurfaceContact::work_on_points() const
{
  return multiplicity_ * work_.total(communicator_)[0];
}
} // namespace ricochet
