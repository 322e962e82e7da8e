// SPDX-License-Identifier: LGPL-2.1-or-later
#include "deformable_projectile.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace ricochet
{
namespace
{
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

DeformableProjectile::DeformableProjectile(const MPI_Comm communicator, const Scene &scene,
                                           const std::vector<Vector3> &nodes,
                                           const std::vector<SurfaceQuad> &faces,
                                           const FrictionLaw &law,
                                           const std::vector<PlateContact> &plates) :
  Projectile(BodyOfRevolution(scene.projectile.shape), scene.projectile.mass),
  multiplicity_(scene.symmetric ? 2. : 1.), surface_(faces), stiffness_(nodes.size(), 0.)
{
  std::vector<char> is_shank;
  std::vector<double> area(nodes.size(), 0.); // of the surface around each node [m^2]
  for (const auto &quad : faces)
  {
    Vector3 centre = Vector3::Zero();
    for (const int node : quad)
      centre += 0.25 * nodes[node];
    is_shank.push_back(body().hit(centre).surface == BodyOfRevolution::Surface::shank);
    const Vector3 cross = (nodes[quad[2]] - nodes[quad[0]]).cross(nodes[quad[3]] - nodes[quad[1]]);
    for (const int node : quad)
      area[node] += cross.norm() / 8.;
  }
  for (const auto &plate : plates)
  {
    reach_ = std::max(reach_, 1.5 * plate.spacing);
    contacts_.emplace_back(communicator, law, plate.parameters, scene.symmetric, plate.n_planes,
                           is_shank);
    for (std::size_t node = 0; node < area.size(); ++node)
      if (area[node] > 0.)
        stiffness_[node] =
            std::max(stiffness_[node], plate.parameters.stiffness *
                                           std::max(1., area[node] / std::pow(plate.spacing, 2)));
  }
}

void DeformableProjectile::follow()
{
  motion_ = nearest_motion(/*kick=*/0.);
  follow_pitch();
  surface_.update(nodes().position, reach_);
}

std::pair<Vector3, Vector3> DeformableProjectile::bounding_box() const
{
  auto box = surface_.bounding_box();
  if (multiplicity_ == 2.)
    box.first.y() = -box.second.y();
  return box;
}

void DeformableProjectile::compute_internal_forces(const ForceRequest &request)
{
  deformed().compute_internal_forces(request);
}

Projectile::Motion DeformableProjectile::present_motion(const double dt) const
{
  return nearest_motion(dt);
}

std::vector<ContactRecord>
DeformableProjectile::add_contact_forces(const std::vector<PeridynamicBody *> &plates,
                                         const double dt)
{
  double shares = 0.;
  for (std::size_t i = 0; i < plates.size(); ++i)
    shares += contacts_[i].add_normal_forces(nodes(), surface_, *plates[i]);
  distribute_surface_forces();
  const auto velocities = present_velocities(dt);
  const auto seen       = nodes();
  const SurfaceNodes present{seen.position, velocities, seen.force, seen.mobility};
  std::vector<ContactRecord> records;
  for (std::size_t i = 0; i < plates.size(); ++i)
    records.push_back(
        contacts_[i].add_friction(present, shares, surface_, motion_.position, *plates[i], dt));
  distribute_surface_forces();
  return records;
}

double DeformableProjectile::friction_power()
{
  const auto &velocity = nodes().velocity;
  double power         = 0.;
  for (const auto &contact : contacts_)
    for (std::size_t i = 0; i < contact.friction_on_nodes().size(); ++i)
      power += contact.friction_on_nodes()[i] * velocity[i];
  return power;
}

void DeformableProjectile::advance(const double kick, const double drift)
{
  const double before = friction_power();
  deformed().advance(kick, drift);
  update_surface();
  work_ += multiplicity_ * 0.5 * kick * (before + friction_power());
  follow();
}

void DeformableProjectile::record_work(const double dt)
{
  for (auto &contact : contacts_)
    contact.record_work(dt);
}

double DeformableProjectile::friction_work() const
{
  double work = work_;
  for (const auto &contact : contacts_)
    work += contact.work_on_points();
  return work;
}

SurfaceFrame DeformableProjectile::surface() const
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

void DeformableProjectile::exchange_state(StateArchive &archive)
{
  deformed().exchange_state(archive);
  exchange_pitch(archive);
  archive.common("friction work", work_);
  if (!archive.is_restoring())
    return;
  update_surface();
  motion_ = nearest_motion(/*kick=*/0.);
  surface_.update(nodes().position, reach_);
}

void DeformableProjectile::plates_changed(const std::vector<PeridynamicBody *> &plates)
{
  for (std::size_t i = 0; i < plates.size(); ++i)
    contacts_[i].plate_changed(*plates[i]);
}

void DeformableProjectile::exchange_contact_state(StateArchive &archive,
                                                  const std::vector<PeridynamicBody *> &plates)
{
  for (std::size_t i = 0; i < plates.size(); ++i)
  {
    const StateArchive::Group group(archive, "on plate " + std::to_string(i + 1));
    contacts_[i].exchange_state(archive, *plates[i]);
  }
}
} // namespace ricochet
