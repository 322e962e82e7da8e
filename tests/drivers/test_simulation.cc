// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
void advance(Simulation &simulation, const int n_steps)
{
  for (int i = 0; i < n_steps; ++i)
  {
    simulation.evaluate(/*energy=*/false);
    simulation.advance();
  }
}

TEST(DBG, Run)
{
  for (auto scene : {small_scene(), symmetric(small_scene()), two_plates(), symmetric(two_plates())})
  {
  Simulation s(MPI_COMM_SELF, scene);
  std::printf("dt %g freq %g\n", s.dt(), s.time_step_info().frequency);
  const auto m0=s.momenta();
  for (int i = 0; i <= 300; ++i)
  {
    s.evaluate(i%20==0);
    if (i%20==0){
    const auto e = s.energies();
    const auto m = s.momenta();
    std::printf("%d E %g proj %g kin %g strain %g contact %g debris %g fric %g frac %g res %g%% broken %g v %g %g w %g touch %g dp %g dL %g\n", i, e.initial, e.projectile,e.kinetic,e.strain,e.contact,e.debris,e.friction,e.fracture,100*e.residual()/e.initial,s.broken_bonds(),s.projectile().motion().velocity.x(),s.projectile().motion().velocity.z(),s.projectile().motion().spin.y(),s.reaction().n_touching, (m.linear-m0.linear).norm()/m0.linear.norm(), (m.angular-m0.angular).norm()/m0.angular.norm());}
    s.advance();
  }}
}
} // namespace
} // namespace ricochet::tests
