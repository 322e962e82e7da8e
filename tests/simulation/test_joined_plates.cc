// SPDX-License-Identifier: LGPL-2.1-or-later
// Plates with a joint, from the scene to the balance.
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// Two plates of 12 mm that are stretched along z at a uniform rate, with their joint in the
/// middle.
struct Stretched
{
  explicit Stretched(const double rate) : simulation(MPI_COMM_WORLD, scene())
  {
    for (auto *const plate : simulation.plates())
      plate->lattice().for_each_owned(
          [&](const std::ptrdiff_t p)
          {
            const auto X = plate->lattice().reference_position(plate->lattice().coordinates(p));
            plate->state().arrays.velocity[2][p] = rate * (X.z() + 12e-3);
          });
    simulation.compute_forces(true);
  }

  static Scene scene()
  {
    Scene scene = two_plates();
    for (auto &plate : scene.plates)
      plate.thickness = 12e-3;
    scene.impact.clearance        = 100e-3; // far away
    scene.plates[1].joint_tension = strength;
    scene.time.safety_factor      = 0.1;
    for (auto &material : scene.materials)
      material.critical_stretch = 1.; // nothing else breaks
    return scene;
  }

  void run_until(const double time)
  {
    while (simulation.time() < time)
    {
      simulation.advance();
      simulation.compute_forces(true);
    }
  }

  double broken() const { return simulation.joint_above(1)->broken_share(); }

  static constexpr double strength = 20e6; // [Pa]
  Simulation simulation;
};

/// K + 4 mu/3 of the scene [Pa].
double modulus()
{
  const auto m = Stretched::scene().materials[0];
  return m.bulk_modulus + 4. / 3. * m.shear_modulus;
}

TEST(JoinedPlates, StretchedUniformlyTheyPartWhenTheStressIsTheStrength)
{
  // M rate t, until the waves from the free faces are there after 4.4 us.
  const double time = 2.4e-6, rate = Stretched::strength / (modulus() * time);
  Stretched plates(rate);
  plates.run_until(time);
  EXPECT_EQ(plates.broken(), 0.);
  // Faces are softer than the inside: it takes a while until the joint has the stress that the
  // inside has, half a microsecond for the horizon of 3 mm, there and back (half breaks at 1.3).
  plates.run_until(1.5 * time);
  EXPECT_GT(plates.broken(), 0.5);
  EXPECT_EQ(plates.simulation.joint_above(0), nullptr);
}

TEST(JoinedPlates, BalanceHoldsWhatTheJointStoresAndReleases)
{
  Stretched plates(2000.);
  const auto &simulation = plates.simulation;
  const auto start       = simulation.energies();
  plates.run_until(4e-6);
  const auto end = simulation.energies();
  EXPECT_GT(plates.broken(), 0.5);
  EXPECT_EQ(end.fracture, simulation.joint_above(1)->released_energy());
  // strength^2 dx/(2 M) on 30 x 16 mm; some sites break by shear, all somewhat late.
  const double toughness = Stretched::strength * Stretched::strength * 1e-3 / (2. * modulus());
  EXPECT_NEAR(end.fracture, plates.broken() * toughness * 30e-3 * 16e-3, 0.1 * end.fracture);
  EXPECT_NEAR(end.kinetic + end.strain + end.fracture, start.kinetic + start.strain,
              1e-3 * start.kinetic);
}
} // namespace
} // namespace ricochet::tests
