// SPDX-License-Identifier: LGPL-2.1-or-later
#include "peridynamic_projectile.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/bodies/nearest_rigid_motion.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "skin.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace ricochet
{
namespace
{
CoupledProjectileBody::Parameters parameters_of(const Scene &scene)
{
  const auto &p  = scene.projectile;
  const double E = p.youngs_modulus, nu = p.poissons_ratio;
  return {p.spacing,
          scene.symmetric ? p.mass / 2. : p.mass,
          &bond_law("linear peridynamic solid"),
          E / (3. * (1. - 2. * nu)),
          E / (2. * (1. + nu)),
          scene.symmetric,
          p.model == ProjectileModel::peridynamic_nose ? p.peridynamic_length
                                                       : std::numeric_limits<double>::infinity()};
}
} // namespace

PeridynamicProjectile::PeridynamicProjectile(const MPI_Comm communicator, const Scene &scene,
                                             const HexSolid &mesh, const Motion &start,
                                             const FrictionLaw &law,
                                             const std::vector<PlateContact> &plates) :
  DeformableProjectile(communicator, scene, Skin(mesh, scene.symmetric).nodes,
                       Skin(mesh, scene.symmetric).faces, law, plates),
  mirrored_(scene.symmetric),
  body_(std::make_unique<CoupledProjectileBody>(body(), mesh, parameters_of(scene)))
{
  const Skin skin(mesh, mirrored_);
  build_skin(skin.nodes, skin.mesh_nodes);

  const double contact = bound_contact();
  const auto estimate  = frequency_bound(MPI_COMM_SELF, *body_);
  squared_frequency_   = estimate.squared_frequency + contact;
  seconds_per_step_    = estimate.seconds_per_force;
  place(start);
  begin_motion();
}

/// Largest squared frequency of the skin's contact springs on the mass points [1/s^2]; notes how
/// impulses on the skin move it. Row sums of |W^T k W| / m and of |W| 1/m |W^T|.
double PeridynamicProjectile::bound_contact()
{
  const auto &mass_points = body_->mass_points();
  std::vector<double> row(skin_mobility_.size(), 0.); // sum of a node's weights
  std::vector<double> column(mass_points.size(), 0.); // sum of a mass point's weights
  for (const auto &support : skin_)
  {
    row[support.node] += std::abs(support.weight);
    // A node on the mirror plane counts for either half.
    column[support.mass_point] += (on_plane_[support.node] ? 0.5 : 1.) * std::abs(support.weight);
  }
  for (const auto &support : skin_)
    skin_mobility_[support.node] += std::abs(support.weight) * column[support.mass_point] /
                                    mass_points[support.mass_point].mass;

  std::fill(column.begin(), column.end(), 0.);
  for (const auto &support : skin_)
    column[support.mass_point] +=
        contact_stiffness(support.node) * std::abs(support.weight) * row[support.node];
  double largest = 0.;
  for (std::size_t i = 0; i < column.size(); ++i)
    largest = std::max(largest, column[i] / mass_points[i].mass);
  return largest;
}

std::string PeridynamicProjectile::parts() const
{
  std::ostringstream text;
  const std::size_t halves = mirrored_ ? 2 : 1;
  text << halves * body_->points().size() << " points";
  if (body_->elements() != nullptr)
    text << " in front of " << halves * body_->n_elements() << " hexahedra (overlap "
         << 1e3 * body_->overlap().length << " mm, ghost force " << std::setprecision(2)
         << body_->overlap().ghost << ")";
  return text.str();
}

void PeridynamicProjectile::build_skin(const std::vector<Vector3> &nodes,
                                       const std::vector<int> &mesh_nodes)
{
  skin_position_.assign(3 * nodes.size(), 0.);
  skin_velocity_ = skin_force_ = skin_position_;
  skin_mobility_.assign(nodes.size(), 0.);
  for (const auto &node : nodes)
    on_plane_.push_back(mirrored_ && node.y() == 0.);
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    const auto number = static_cast<int>(node);
    if (const int own = body_->mass_point_of(mesh_nodes[node]); own >= 0)
    {
      skin_.push_back({number, own, false, 1.});
      continue;
    }
    // The smallest neighbourhood that tells a linear motion well: at a sharp tip the points end
    // before the skin does.
    for (double range = 2.; !follow_points(number, nodes[node], range); range += 0.5)
      if (range > 10.)
        throw InputError("The points of the projectile do not reach its surface.\n  Lower "
                         "'Projectile/Grid spacing'.");
  }
}

/// Moving least squares over the points within `range` spacings of a node at `place`: the node
/// follows them if they tell a linear motion. Returns whether they do.
bool PeridynamicProjectile::follow_points(const int node, const Vector3 &place, const double range)
{
  const auto &points = body_->points();
  std::vector<std::pair<int, bool>> around; // points, their images
  std::vector<double> weights;
  std::vector<Eigen::Vector4d> base;
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  double total            = 0.;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const bool image : {false, true})
    {
      if (image && !mirrored_)
        continue;
      Vector3 arm = points[p].reference;
      if (image)
        arm.y() = -arm.y();
      arm               = (arm - place) / body_->spacing();
      const double away = arm.norm() / range;
      if (away >= 1.)
        continue;
      const double q = (1. - away) * (1. - away);
      base.emplace_back(1., arm[0], arm[1], arm[2]);
      around.emplace_back(static_cast<int>(p), image);
      weights.push_back(q);
      moments += q * base.back() * base.back().transpose();
      total += q;
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(moments);
  if (around.size() < 8 || solver.eigenvalues()[0] < 0.02 * total)
    return false;
  const Eigen::Vector4d coefficients = moments.ldlt().solve(Eigen::Vector4d::Unit(0));
  for (std::size_t i = 0; i < around.size(); ++i)
    for (const auto &[mass_point, share] : points[around[i].first].follows)
      skin_.push_back(
          {node, mass_point, around[i].second, share * (weights[i] * coefficients.dot(base[i]))});
  return true;
}

void PeridynamicProjectile::place(const Motion &start)
{
  for (const auto &point : body_->mass_points())
  {
    const Vector3 arm = start.orientation * point.reference;
    const Vector3 x = start.position + arm, v = start.velocity + start.spin.cross(arm);
    for (int d = 0; d < 3; ++d)
    {
      const bool held    = point.mobility[d] == 0.; // on the symmetry plane
      *point.position[d] = held ? 0. : x[d];
      *point.velocity[d] = held ? 0. : v[d];
    }
  }
  body_->interpolate_to_slaved_points();
  update_surface();
}

template <class Value>
void PeridynamicProjectile::follow(std::vector<double> &on_skin, const Value &value) const
{
  std::fill(on_skin.begin(), on_skin.end(), 0.);
  for (const auto &support : skin_)
    for (int d = 0; d < 3; ++d)
    {
      const double weight = support.image && d == 1 ? -support.weight : support.weight;
      on_skin[3 * support.node + d] += weight * value(body_->mass_points()[support.mass_point], d);
    }
}

void PeridynamicProjectile::update_surface()
{
  follow(skin_position_, [](const MassPoint &p, const int d) { return *p.position[d]; });
  follow(skin_velocity_, [](const MassPoint &p, const int d) { return *p.velocity[d]; });
}

std::vector<double> PeridynamicProjectile::present_velocities(const double kick)
{
  auto velocity = skin_velocity_;
  follow(velocity, [kick](const MassPoint &p, const int d)
         { return *p.velocity[d] + kick / 2. * p.mobility[d] * *p.force[d]; });
  return velocity;
}

void PeridynamicProjectile::compute_internal_forces(const ForceRequest &request)
{
  body_->compute_internal_forces(request);
  std::fill(skin_force_.begin(), skin_force_.end(), 0.);
}

void PeridynamicProjectile::distribute_surface_forces()
{
  for (const auto &support : skin_)
    for (int d = 0; d < 3; ++d)
    {
      const double weight = support.image && d == 1 ? -support.weight : support.weight;
      *body_->mass_points()[support.mass_point].force[d] +=
          weight * skin_force_[3 * support.node + d];
    }
  std::fill(skin_force_.begin(), skin_force_.end(), 0.);
}

Projectile::Motion PeridynamicProjectile::nearest_motion(const double kick) const
{
  std::vector<double> mass, position, velocity;
  std::vector<Vector3> reference;
  for (const auto &point : body_->mass_points())
  {
    mass.push_back(point.mass);
    reference.push_back(point.reference);
    for (int d = 0; d < 3; ++d)
    {
      position.push_back(*point.position[d]);
      velocity.push_back(*point.velocity[d] + kick / 2. * point.mobility[d] * *point.force[d]);
    }
  }
  return nearest_rigid_motion(mass, reference, position, velocity, mirrored_);
}
} // namespace ricochet
