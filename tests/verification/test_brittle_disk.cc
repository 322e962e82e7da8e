// SPDX-License-Identifier: LGPL-2.1-or-later
// The brittle disk of the peridynamics manual of LAMMPS (after Silling and Askari 2005): a sphere
// of 10 mm falls with 100 m/s on a disk of 74 mm x 2.5 mm, 103,110 points. Until the first bond
// breaks the disk must keep the symmetry of its lattice, then it breaks evenly.
#include "ricochet/contact/friction_laws.h"
#include "ricochet/contact/rigid_contact.h"
#include "ricochet/contact/short_range_contact.h"
#include "support/body.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double dx     = 0.5e-3;
constexpr int radius    = 74; // [spacings]
constexpr int n_across  = 2 * radius + 1;
constexpr int n_through = 6;

/// Largest difference of the motion of a point and of its images under a quarter turn and under the
/// reflection that exchanges x and y [m/s].
double asymmetry(const PeridynamicBody &disk)
{
  const Lattice &l = disk.lattice();
  const auto &a    = disk.state().arrays;
  double largest   = 0.;
  for (int x = 0; x < n_across; ++x)
    for (int y = 0; y < n_across; ++y)
      for (int z = 0; z < n_through; ++z)
        if (const auto p = l.index(x, y, z); l.owned(p))
        {
          const Vector3 v        = at(a.velocity, p);
          const Vector3 turned   = at(a.velocity, l.index(n_across - 1 - y, x, z)),
                        mirrored = at(a.velocity, l.index(y, x, z));
          largest = std::max({largest, (turned - Vector3(-v.y(), v.x(), v.z())).norm(),
                              (mirrored - Vector3(v.y(), v.x(), v.z())).norm()});
        }
  return largest;
}

TEST(BrittleDisk, KeepsItsSymmetryAndBreaksEvenly)
{
  BodySample sample;
  sample.family.law                = {"microelastic brittle", 2200., 14.9e9, 0.6 * 14.9e9};
  sample.family.influence_function = InfluenceFunction::constant;
  sample.family.horizon_ratio      = 3.;
  sample.n                         = {n_across, n_across, n_through};
  sample.spacing                   = dx;
  sample.corner           = Vector3(-0.5 * n_across * dx, -0.5 * n_across * dx, -n_through * dx);
  sample.critical_stretch = 5e-4;
  // Eight points of a layer lie exactly on the rim, (24, 70) and its images. Rounding leaves them
  // out in this form of the question, as it does there.
  sample.mask             = [](const int x, const int y, int)
  {
    const double X = (x - radius) * dx, Y = (y - radius) * dx;
    return std::sqrt(X * X + Y * Y) <= 0.037;
  };
  std::vector<std::unique_ptr<PeridynamicBody>> bodies;
  bodies.push_back(make_body(sample));
  auto &disk = *bodies[0];
  // The number is stated there.
  verify_near("V17", "points of the disk", static_cast<double>(disk.lattice().n_owned_points()),
              103110., 0.);

  const auto law = make_friction_law(ConstantFriction::Parameters{0.});
  RigidContact contact(MPI_COMM_SELF, *law, {youngs_modulus(disk.material()) * dx, 0., 1.}, false,
                       n_across);
  ShortRangeContact debris(MPI_COMM_SELF, pointers(bodies), 15., false);
  constexpr double R = 5e-3, speed = 100., dt = 1e-7; // stated there
  RigidBody sphere(
      BodyOfRevolution({NoseShape::sphere, 2. * R, 0., 0.}), 4e-3,
      {{0., 0., R + 0.01 * dx}, {0., 0., -speed}, Eigen::Quaterniond::Identity(), Vector3::Zero()},
      false);
  int n_steps_whole = 0;
  for (int step = 0; step < 1000; ++step)
  {
    disk.update_ghosts();
    disk.break_bonds();
    disk.compute_internal_forces({false});
    if (n_steps_whole == step && disk.bond_damage().log().empty())
    {
      ++n_steps_whole;
      verify_at_most("V17", "asymmetry of the velocities before the first break over v",
                     asymmetry(disk) / speed, 1e-8);
    }
    const auto reaction = contact.add_forces(sphere, disk, dt);
    debris.add_forces(dt);
    disk.advance(dt, dt);
    sphere.advance(reaction.force(), reaction.moment, dt, dt);
  }
  EXPECT_GT(n_steps_whole, 3) << "otherwise nothing has been compared";

  // Cracks amplify rounding; what is left of the symmetry is that of the four quarters between the
  // diagonals, in which the same share of the bonds is broken.
  double damage[4] = {}, total = 0.;
  for_each_point(disk,
                 [&](const std::ptrdiff_t p)
                 {
                   const Vector3 X = reference(disk, p);
                   if (std::abs(std::abs(X.x()) - std::abs(X.y())) < 0.5 * dx)
                     return;
                   const int quarter = std::abs(X.x()) > std::abs(X.y()) ? (X.x() > 0. ? 0 : 2)
                                                                         : (X.y() > 0. ? 1 : 3);
                   damage[quarter] += disk.damage(p);
                   total += disk.damage(p);
                 });
  EXPECT_GT(total, 1000.);
  for (const double quarter : damage)
    verify_near("V17", "damage of each quarter over a fourth of all", quarter / (total / 4.), 1.,
                0.01);
  EXPECT_LT(sphere.motion().velocity.z(), -0.5 * speed) << "it goes through";
  EXPECT_GT(sphere.motion().velocity.z(), -0.95 * speed) << "and is slowed";
}
} // namespace
} // namespace ricochet::tests
