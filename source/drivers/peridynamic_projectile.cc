// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/drivers/peridynamic_projectile.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/dynamics/stable_time_step.h"
#include "ricochet/forces/nearest_rigid_motion.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ricochet
{
namespace
{
/// Nodes on the outer faces only, numbered anew.
struct Skin
{
  std::vector<Vector3> nodes;
  std::vector<SurfaceQuad> faces;

  Skin(const HexSolid &mesh, const bool mirrored) : faces(outer_faces(mesh, mirrored))
  {
    std::vector<int> number(mesh.nodes.size(), -1);
    for (auto &quad : faces)
      for (int &node : quad)
      {
        if (number[node] < 0)
        {
          number[node] = static_cast<int>(nodes.size());
          nodes.push_back(mesh.nodes[node]);
        }
        node = number[node];
      }
  }
};

std::unique_ptr<PeridynamicForce> make_body(const Scene &scene)
{
  const auto &p        = scene.projectile;
  const double spacing = p.spacing;
  const BodyOfRevolution shape(p.shape);
  const int across = static_cast<int>(std::ceil(shape.shape().diameter / 2. / spacing));
  const int along  = std::max(1, static_cast<int>(std::lround(shape.shape().length / spacing)));
  Lattice::Box box;
  box.spacing       = spacing;
  box.mirror_y      = scene.symmetric;
  box.n             = {along, scene.symmetric ? across : 2 * across, 2 * across};
  box.corner        = {shape.base_position() + 0.5 * (shape.shape().length - along * spacing),
                scene.symmetric ? 0. : -across * spacing, -across * spacing};
  const auto inside = [&](const int x, const int y, const int z)
  {
    const Vector3 place = box.corner + spacing * Vector3(x + 0.5, y + 0.5, z + 0.5);
    return shape.hit(place).distance < 0.;
  };
  double n_points = 0.;
  for (int x = 0; x < box.n[0]; ++x)
    for (int y = 0; y < box.n[1]; ++y)
      for (int z = 0; z < box.n[2]; ++z)
        n_points += inside(x, y, z);
  if (across < 2 || n_points < 50.)
  {
    std::ostringstream message;
    message << "The grid of the projectile is too coarse: a spacing of " << 1e3 * spacing
            << " mm puts " << 2 * across << " points across its diameter and " << n_points
            << " into it.\n  Lower 'Projectile/Grid spacing'.";
    throw InputError(message.str());
  }
  const double own = scene.symmetric ? p.mass / 2. : p.mass;
  const double E = p.youngs_modulus, nu = p.poissons_ratio;
  const PeridynamicMaterial material{
      &bond_law("linear peridynamic solid"), own / (n_points * spacing * spacing * spacing),
      E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu)), std::numeric_limits<double>::infinity()};
  return std::make_unique<PeridynamicForce>(
      MPI_COMM_SELF, 0, box, make_stencil(spacing, 3., InfluenceFunction::cone), material, inside);
}
} // namespace

PeridynamicProjectile::PeridynamicProjectile(const MPI_Comm communicator, const Scene &scene,
                                             const HexSolid &mesh, const Motion &start,
                                             const FrictionLaw &law,
                                             const std::vector<PlateContact> &plates) :
  DeformableProjectile(communicator, scene, Skin(mesh, scene.symmetric).nodes,
                       Skin(mesh, scene.symmetric).faces, law, plates),
  mirrored_(scene.symmetric), body_(make_body(scene))
{
  const Lattice &lattice = body_->lattice();
  for (std::ptrdiff_t p = lattice.owned_begin(); p < lattice.owned_end(); ++p)
    if (lattice.owned(p))
    {
      points_.push_back(p);
      reference_.push_back(lattice.reference_position(lattice.coordinates(p)));
    }
  mass_.assign(points_.size(), body_->point_mass());
  const Skin skin(mesh, mirrored_);
  build_skin(skin.nodes);

  // |W^T k W| <= the largest row sum times the largest column sum.
  std::vector<double> row(skin.nodes.size(), 0.), column(points_.size(), 0.);
  for (const auto &support : skin_)
    row[support.node] += std::abs(support.weight);
  for (const auto &support : skin_)
    column[support.point] +=
        contact_stiffness(support.node) * std::abs(support.weight) * row[support.node];
  const double contact = *std::max_element(column.begin(), column.end()) / body_->point_mass();
  const auto estimate  = estimate_largest_frequency(MPI_COMM_SELF, *body_);
  squared_frequency_   = estimate.squared_frequency + contact;
  seconds_per_step_    = estimate.seconds_per_force;
  place(start);
  begin_motion();
}

void PeridynamicProjectile::build_skin(const std::vector<Vector3> &nodes)
{
  const double spacing = body_->lattice().box().spacing;
  skin_position_.assign(3 * nodes.size(), 0.);
  skin_velocity_ = skin_force_ = skin_position_;
  for (std::size_t node = 0; node < nodes.size(); ++node)
    // The smallest neighbourhood that tells a linear motion well: at a sharp tip the points end
    // before the skin does.
    for (double range = 2.; skin_.empty() || skin_.back().node != static_cast<int>(node);
         range += 0.5)
    {
      if (range > 10.)
        throw InputError("The points of the projectile do not reach its surface.\n  Lower "
                         "'Projectile/Grid spacing'.");
      std::vector<Support> supports;
      std::vector<Eigen::Vector4d> base;
      Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
      double total            = 0.;
      for (std::size_t p = 0; p < reference_.size(); ++p)
        for (const bool image : {false, true})
        {
          if (image && !mirrored_)
            continue;
          Vector3 arm = reference_[p];
          if (image)
            arm.y() = -arm.y();
          arm               = (arm - nodes[node]) / spacing;
          const double away = arm.norm() / range;
          if (away >= 1.)
            continue;
          const double q = (1. - away) * (1. - away);
          base.emplace_back(1., arm[0], arm[1], arm[2]);
          supports.push_back({static_cast<int>(node), static_cast<int>(p), image, q});
          moments += q * base.back() * base.back().transpose();
          total += q;
        }
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(moments);
      if (supports.size() < 8 || solver.eigenvalues()[0] < 0.02 * total)
        continue;
      const Eigen::Vector4d coefficients = moments.ldlt().solve(Eigen::Vector4d::Unit(0));
      for (std::size_t i = 0; i < supports.size(); ++i)
        supports[i].weight *= coefficients.dot(base[i]);
      skin_.insert(skin_.end(), supports.begin(), supports.end());
    }
}

void PeridynamicProjectile::place(const Motion &start)
{
  auto &a = body_->state().arrays;
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    const Vector3 arm = start.orientation * reference_[i];
    const Vector3 x = start.position + arm, v = start.velocity + start.spin.cross(arm);
    for (int d = 0; d < 3; ++d)
    {
      a.position[d][points_[i]] = x[d];
      a.velocity[d][points_[i]] = v[d];
    }
  }
  pull_skin();
}

void PeridynamicProjectile::pull_skin()
{
  std::fill(skin_position_.begin(), skin_position_.end(), 0.);
  std::fill(skin_velocity_.begin(), skin_velocity_.end(), 0.);
  const auto &a = body_->state().arrays;
  for (const auto &support : skin_)
    for (int d = 0; d < 3; ++d)
    {
      const double weight = support.image && d == 1 ? -support.weight : support.weight;
      skin_position_[3 * support.node + d] += weight * a.position[d][points_[support.point]];
      skin_velocity_[3 * support.node + d] += weight * a.velocity[d][points_[support.point]];
    }
}

void PeridynamicProjectile::begin(const bool energy)
{
  body_->update_ghosts();
  body_->evaluate(/*breaking=*/false, energy);
  std::fill(skin_force_.begin(), skin_force_.end(), 0.);
}

void PeridynamicProjectile::receive()
{
  auto &a = body_->state().arrays;
  for (const auto &support : skin_)
    for (int d = 0; d < 3; ++d)
    {
      const double weight = support.image && d == 1 ? -support.weight : support.weight;
      a.force[d][points_[support.point]] += weight * skin_force_[3 * support.node + d];
    }
  std::fill(skin_force_.begin(), skin_force_.end(), 0.);
}

void PeridynamicProjectile::move(const double dt)
{
  body_->advance(dt, dt);
  pull_skin();
}

Projectile::Motion PeridynamicProjectile::nearest_motion() const
{
  std::vector<double> position, velocity;
  const auto &a = body_->state().arrays;
  for (const auto p : points_)
    for (int d = 0; d < 3; ++d)
    {
      position.push_back(a.position[d][p]);
      velocity.push_back(a.velocity[d][p]);
    }
  return nearest_rigid_motion(mass_, reference_, position, velocity, mirrored_);
}

Projectile::Energies PeridynamicProjectile::energies(const Reaction &, const double dt) const
{
  Energies e{0., 0.};
  const auto &a = body_->state().arrays;
  for (const auto p : points_)
  {
    e.elastic += multiplicity() * a.energy[p];
    for (int d = 0; d < 3; ++d)
      e.kinetic += multiplicity() * 0.5 * a.velocity[d][p] *
                   (body_->point_mass() * a.velocity[d][p] + dt * a.force[d][p]);
  }
  return e;
}

Projectile::Momenta PeridynamicProjectile::momenta() const
{
  Momenta m{Vector3::Zero(), Vector3::Zero()};
  const auto &a = body_->state().arrays;
  for (const auto p : points_)
  {
    const Vector3 x(a.position[0][p], a.position[1][p], a.position[2][p]),
        v(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]);
    m.linear += body_->point_mass() * v;
    m.angular += body_->point_mass() * x.cross(v);
  }
  if (mirrored_)
    m = {2. * Vector3(m.linear.x(), 0., m.linear.z()), 2. * Vector3(0., m.angular.y(), 0.)};
  return m;
}
} // namespace ricochet
