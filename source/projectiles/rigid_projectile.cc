// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rigid_projectile.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
RigidProjectile::RigidProjectile(const MPI_Comm communicator, const Scene &scene,
                                 const Motion &start, const FrictionLaw &law,
                                 const std::vector<PlateContact> &plates) :
  Projectile(BodyOfRevolution(scene.projectile.shape), scene.projectile.mass),
  rigid_(body(), mass(), start, scene.symmetric)
{
  if (scene.projectile.driven)
    rigid_.drive();
  for (const auto &plate : plates)
    contacts_.emplace_back(communicator, law, plate.parameters, scene.symmetric, plate.n_planes);
  follow_pitch();
}

Projectile::Motion RigidProjectile::present_motion(const double dt) const
{
  return rigid_.present_motion(load_.force(), load_.moment, dt);
}

std::vector<ContactRecord>
RigidProjectile::add_contact_forces(const std::vector<PeridynamicBody *> &plates, const double dt)
{
  RigidContact::Press press;
  for (std::size_t i = 0; i < plates.size(); ++i)
    press += contacts_[i].add_normal_forces(rigid_, *plates[i]);
  std::vector<ContactRecord> records;
  for (std::size_t i = 0; i < plates.size(); ++i)
  {
    records.push_back(contacts_[i].add_friction(rigid_, press, *plates[i], dt));
    load_ += records.back();
  }
  return records;
}

void RigidProjectile::advance(const double kick, const double drift)
{
  const Vector3 velocity = rigid_.motion().velocity, spin = rigid_.motion().spin;
  if (rigid_.is_driven())
  {
    drive_work_ += drive_work(kick);
    drive_impulse_.linear -= kick * load_.force();
    drive_impulse_.angular -= kick * (rigid_.motion().position.cross(load_.force()) + load_.moment);
  }
  rigid_.advance(load_.force(), load_.moment, kick, drift);
  const auto &after = rigid_.motion();
  work_ += 0.5 * kick *
           ((load_.friction + load_.shank).dot(velocity + after.velocity) +
            load_.friction_moment.dot(spin + after.spin));
  follow_pitch();
}

/// What it takes to hold against the loads for so long [s], [J].
double RigidProjectile::drive_work(const double time) const
{
  const auto &motion = rigid_.motion();
  return -time * (load_.force().dot(motion.velocity) + load_.moment.dot(motion.spin));
}

void RigidProjectile::record_work(const double dt)
{
  for (auto &contact : contacts_)
    contact.record_work(dt);
}

Energies RigidProjectile::energies(const double dt) const
{
  // v- . v+ instead of v . v: for a linear system the leapfrog scheme conserves this sum exactly.
  const auto &motion  = rigid_.motion();
  const double kick   = rigid_.is_driven() ? 0. : dt;
  const Vector3 after = motion.velocity + kick / mass() * load_.force();
  Energies energies;
  energies.kinetic = 0.5 * mass() * motion.velocity.dot(after) +
                     0.5 * motion.spin.dot(rigid_.angular_momentum() + kick * load_.moment);
  // Half of the coming step's work belongs to the present time, as half of its kick does.
  if (rigid_.is_driven())
    energies.drive = drive_work_ + drive_work(dt / 2.);
  return energies;
}

Momenta RigidProjectile::momenta() const
{
  const Vector3 p = mass() * rigid_.motion().velocity;
  Momenta momenta{p, rigid_.motion().position.cross(p) + rigid_.angular_momentum()};
  momenta += -1. * drive_impulse_;
  return momenta;
}

std::string RigidProjectile::first_not_finite() const
{
  return rigid_.motion().position.allFinite() ? "" : "The position of the projectile";
}

double RigidProjectile::friction_work() const
{
  double work = work_;
  for (const auto &contact : contacts_)
    work += contact.work_on_points();
  return work;
}

SurfaceFrame RigidProjectile::surface() const
{
  constexpr int n_around = 32;
  SurfaceFrame frame;
  const auto profile = body().profile();
  const auto place   = [&](const double x, const double r, const double angle) -> Vector3
  {
    return motion().position +
           motion().orientation * Vector3(x, r * std::sin(angle), r * std::cos(angle));
  };
  for (const auto &[x, r] : profile)
    for (int i = 0; i < n_around; ++i)
      frame.vertices.push_back(place(x, r, 2. * M_PI * i / n_around));
  for (int ring = 0; ring + 1 < static_cast<int>(profile.size()); ++ring)
    for (int i = 0; i < n_around; ++i)
    {
      const int next = (i + 1) % n_around;
      frame.quads.push_back({ring * n_around + i, ring * n_around + next,
                             (ring + 1) * n_around + next, (ring + 1) * n_around + i});
    }
  for (const auto &[x, r] : profile)
    frame.outline.push_back(place(x, r, 0.));
  for (auto point = profile.rbegin(); point != profile.rend(); ++point)
    frame.outline.push_back(place((*point)[0], (*point)[1], M_PI));
  return frame;
}

void RigidProjectile::exchange_state(StateArchive &archive)
{
  rigid_.exchange_state(archive);
  exchange_pitch(archive);
  archive.common("friction work", work_);
  archive.common("drive work", drive_work_);
  archive.common("drive impulse", drive_impulse_.linear);
  archive.common("angular drive impulse", drive_impulse_.angular);
}

void RigidProjectile::plates_changed(const std::vector<PeridynamicBody *> &plates)
{
  for (std::size_t i = 0; i < plates.size(); ++i)
    contacts_[i].plate_changed(*plates[i]);
}

void RigidProjectile::exchange_contact_state(StateArchive &archive,
                                             const std::vector<PeridynamicBody *> &plates)
{
  for (std::size_t i = 0; i < plates.size(); ++i)
  {
    const StateArchive::Group group(archive, "on plate " + std::to_string(i + 1));
    contacts_[i].exchange_state(archive, *plates[i]);
  }
}
} // namespace ricochet
