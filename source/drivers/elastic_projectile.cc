// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/drivers/elastic_projectile.h"

#include "ricochet/dynamics/elastic_body_time_step.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ricochet
{
namespace
{
FiniteElementMaterial material_of(const Scene &scene, const HexSolid &mesh)
{
  const auto &p    = scene.projectile;
  const double E   = p.youngs_modulus, nu = p.poissons_ratio;
  const double own = scene.symmetric ? p.mass / 2. : p.mass;
  return {own / volume(mesh), E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu))};
}

/// Without the faces that the symmetry plane cuts open.
std::vector<SurfaceQuad> outer_faces(const HexSolid &mesh, const bool mirrored)
{
  auto faces = surface_of(mesh);
  if (mirrored)
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                               [&](const SurfaceQuad &quad)
                               {
                                 return std::all_of(quad.begin(), quad.end(), [&](const int node)
                                                    { return mesh.nodes[node].y() == 0.; });
                               }),
                faces.end());
  return faces;
}

/// The polygon around points in the plane y = 0 (monotone chain): the outline of a convex body.
std::vector<Vector3> outline_of(std::vector<Vector3> points)
{
  const auto before = [](const Vector3 &a, const Vector3 &b)
  { return a.x() != b.x() ? a.x() < b.x() : a.z() < b.z(); };
  std::sort(points.begin(), points.end(), before);
  std::vector<Vector3> hull;
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::size_t start = hull.size();
    for (const auto &p : points)
    {
      while (hull.size() >= start + 2)
      {
        const Vector3 &a = hull[hull.size() - 2], &b = hull.back();
        if ((b.x() - a.x()) * (p.z() - a.z()) - (b.z() - a.z()) * (p.x() - a.x()) > 0.)
          break;
        hull.pop_back();
      }
      hull.emplace_back(p.x(), 0., p.z());
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}
} // namespace

ElasticProjectile::ElasticProjectile(const MPI_Comm communicator, const Scene &scene,
                                     const HexSolid &mesh, const Motion &start,
                                     const FrictionLaw &law,
                                     const std::vector<PlateContact> &plates) :
  Projectile(BodyOfRevolution(scene.projectile.shape), scene.projectile.mass),
  multiplicity_(scene.symmetric ? 2. : 1.),
  elastic_(mesh, material_of(scene, mesh), scene.symmetric), motion_(start),
  surface_(outer_faces(mesh, scene.symmetric)), reach_(0.)
{
  std::vector<char> is_shank;
  std::vector<double> area(mesh.nodes.size(), 0.); // of the surface around each node [m^2]
  for (const auto &quad : surface_.faces())
  {
    Vector3 centre = Vector3::Zero();
    for (const int node : quad)
      centre += 0.25 * mesh.nodes[node];
    is_shank.push_back(body().hit(centre).surface == BodyOfRevolution::Surface::shank);
    const Vector3 cross = (mesh.nodes[quad[2]] - mesh.nodes[quad[0]])
                              .cross(mesh.nodes[quad[3]] - mesh.nodes[quad[1]]);
    for (const int node : quad)
      area[node] += cross.norm() / 8.;
  }

  double contact = 0.; // largest squared frequency of a node on the plates' springs
  for (const auto &plate : plates)
  {
    const double spacing = plate.spacing;
    reach_               = std::max(reach_, 1.5 * spacing);
    contacts_.emplace_back(communicator, law, plate.parameters, scene.symmetric, plate.n_planes,
                           is_shank);
    // As many points as lie on the node's share of the surface, one at least.
    for (std::size_t node = 0; node < area.size(); ++node)
      if (area[node] > 0.)
        contact = std::max(contact, plate.parameters.stiffness *
                                        std::max(1., area[node] / (spacing * spacing)) /
                                        elastic_.node_mass(static_cast<int>(node)));
  }
  const auto estimate = estimate_largest_frequency(elastic_);
  squared_frequency_  = estimate.squared_frequency + contact;
  seconds_per_step_   = estimate.seconds_per_force;
  elastic_.set_motion(start);
  motion_ = elastic_.rigid_motion();
  update_surface();
}

void ElasticProjectile::update_surface()
{
  surface_.update(elastic_.position(), reach_);
}

std::pair<Vector3, Vector3> ElasticProjectile::bounding_box() const
{
  auto box = surface_.bounding_box();
  if (multiplicity_ == 2.)
    box.first.y() = -box.second.y();
  return box;
}

void ElasticProjectile::begin(const bool energy)
{
  elastic_.evaluate(energy);
}

Projectile::Reaction ElasticProjectile::touch(const std::size_t plate, PeridynamicForce &points)
{
  return contacts_[plate].evaluate(elastic_, surface_, motion_.position, points);
}

double ElasticProjectile::friction_power() const
{
  double power = 0.;
  for (const auto &contact : contacts_)
    for (std::size_t i = 0; i < contact.friction_on_nodes().size(); ++i)
      power += contact.friction_on_nodes()[i] * elastic_.velocity()[i];
  return power;
}

void ElasticProjectile::advance(const Reaction &, const double dt)
{
  const double before = friction_power();
  elastic_.advance(dt, dt);
  work_ += multiplicity_ * 0.5 * dt * (before + friction_power());
  motion_ = elastic_.rigid_motion();
  update_surface();
}

void ElasticProjectile::record_work(const std::size_t plate, const PeridynamicForce &points,
                                    const double dt)
{
  contacts_[plate].record_work(points, dt);
}

Projectile::Energies ElasticProjectile::energies(const Reaction &, const double dt) const
{
  const auto e = elastic_.energies(dt);
  return {multiplicity_ * e.kinetic, multiplicity_ * (e.strain + e.hourglass)};
}

Projectile::Momenta ElasticProjectile::momenta() const
{
  const auto m = elastic_.momenta();
  if (multiplicity_ == 1.)
    return {m.linear, m.angular};
  return {2. * Vector3(m.linear.x(), 0., m.linear.z()), 2. * Vector3(0., m.angular.y(), 0.)};
}

double ElasticProjectile::friction_work() const
{
  double work = work_;
  for (const auto &contact : contacts_)
    work += contact.work_on_points();
  return work;
}

SurfaceFrame ElasticProjectile::surface() const
{
  SurfaceFrame frame;
  std::map<int, int> number; // of the mesh's nodes among the vertices
  for (const auto &quad : surface_.faces())
  {
    frame.quads.push_back(quad);
    for (int &node : frame.quads.back())
    {
      const auto [entry, is_new] = number.emplace(node, static_cast<int>(number.size()));
      if (is_new)
        frame.vertices.push_back(surface_.node(node));
      node = entry->second;
    }
  }
  frame.outline = outline_of(frame.vertices);
  if (multiplicity_ == 2.)
  {
    const int n = static_cast<int>(frame.vertices.size());
    for (int i = 0; i < n; ++i)
      frame.vertices.emplace_back(frame.vertices[i].x(), -frame.vertices[i].y(),
                                  frame.vertices[i].z());
    const auto half = frame.quads;
    for (const auto &quad : half)
      frame.quads.push_back({quad[3] + n, quad[2] + n, quad[1] + n, quad[0] + n});
  }
  return frame;
}
} // namespace ricochet
