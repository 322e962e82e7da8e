// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/contact_warnings.h"

#include "support/coupled_scene.h"
#include "support/scratch_directory.h"

namespace ricochet::tests
{
namespace
{
/// What a scene's first steps warn about, on this rank.
std::string warnings_of(const Scene &scene, const int n_steps, ContactWarnings &warnings)
{
  Simulation simulation(MPI_COMM_WORLD, scene);
  testing::internal::CaptureStderr();
  for (int step = 0; step < n_steps; ++step)
  {
    simulation.compute_forces(false);
    warnings.update(simulation);
    simulation.advance();
  }
  return testing::internal::GetCapturedStderr();
}

std::size_t count(const std::string &text, const std::string &part)
{
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

TEST(ContactWarnings, SoundContactHasNone)
{
  ContactWarnings warnings(MPI_COMM_WORLD);
  EXPECT_EQ(warnings_of(two_plates(), 60, warnings), "");
  EXPECT_GT(warnings.deepest(), 0.);
  EXPECT_LT(warnings.deepest(), 0.5);
  EXPECT_LT(warnings.on_elements_since(), 0.);
}

TEST(ContactWarnings, ContactThatIsTooSoftIsNamedOnce)
{
  Scene scene                    = two_plates();
  scene.contact.stiffness_factor = 0.002;
  ContactWarnings warnings(MPI_COMM_WORLD);
  const std::string text = warnings_of(scene, 100, warnings);
  EXPECT_GT(warnings.deepest(), 0.5);
  EXPECT_EQ(count(text, "contact is too soft"), rank() == 0 ? 1u : 0u) << text;
}

TEST(ContactWarnings, ElementsUnderTheProjectileAreNamedOnce)
{
  Scene scene                = coupled_scene();
  scene.plates[0].zone_boxes = {{22e-3, 38e-3, -8e-3, 8e-3}}; // far behind the entry point
  ContactWarnings warnings(MPI_COMM_WORLD);
  const std::string text = warnings_of(scene, 30, warnings);
  EXPECT_GT(warnings.on_elements_since(), 0.);
  EXPECT_EQ(count(text, "touches finite elements"), rank() == 0 ? 1u : 0u) << text;
}
} // namespace
} // namespace ricochet::tests
