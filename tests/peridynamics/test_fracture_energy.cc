// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(FractureEnergy, BondPulledApartQuasiStaticallyReleasesItsEnergy)
{
  for (const auto &law : bond_law_samples)
  {
    // Two points, one bond: at rest but for a stretch that grows past the limit.
    BodySample sample;
    sample.family           = {law, InfluenceFunction::constant, 1.};
    sample.n                = {2, 1, 1};
    sample.critical_stretch = 0.01;
    const auto body         = make_body(sample);
    auto &a                 = body->state().arrays;
    const auto p            = body->lattice().index(1, 0, 0);
    const Vector3 X         = reference(*body, p);
    const double step       = 1e-6,
                 dt         = 1.; // of the stretch; so slow that the two steps hold the same energy
    double before           = 0.;
    for (double stretch = 0.; stretch < 0.0101; stretch += step)
    {
      body->end_step();
      set(a.position, p, X + Vector3(stretch * sample.spacing, 0., 0.));
      set(a.velocity, p, Vector3(step * sample.spacing / dt, 0., 0.));
      body->update_ghosts();
      body->break_bonds();
      body->compute_internal_forces({true});
      body->book_fracture(dt);
      if (body->n_broken_bonds() == 0.)
        before = strain_energy(*body);
      else
      {
        EXPECT_EQ(strain_energy(*body), 0.);
      }
    }
    EXPECT_EQ(body->n_broken_bonds(), 1.);
    EXPECT_GT(before, 0.);
    EXPECT_NEAR(body->energies(dt).fracture / before, 1., 3e-4)
        << law.law << ": one step of 1e-6 of a stretch of 1e-2 is 2e-4 of the energy";
  }
}

TEST(FractureEnergy, ReleasedEnergyIsTheDifferenceWithAndWithoutTheBrokenBonds)
{
  // A whole block, slow: the energy of the shaken body with all bonds minus that without those
  // which broke.
  for (const auto &law : bond_law_samples)
  {
    BodySample sample;
    sample.family           = {law, InfluenceFunction::cone, 3.};
    sample.n                = {7, 6, 5};
    const auto intact       = make_body(sample);
    sample.critical_stretch = 0.03;
    const auto body         = make_body(sample);
    // The same sequence of displacements for each call.
    const auto shaken       = []
    {
      return [random = Random(53)](const Vector3 &X) mutable -> Vector3
      { return X + 0.05e-3 * random.vector(); };
    };
    deform(*intact, shaken());
    // The step before: the same place with all bonds, so that v = 0 is the truth.
    body->update_ghosts();
    deform(*body, shaken(), /*breaking=*/false);
    body->end_step();
    body->break_bonds();
    body->compute_internal_forces({true});
    EXPECT_GT(body->bond_damage().log().size(), 100u);
    body->book_fracture(1e-7);
    const double difference = strain_energy(*intact) - strain_energy(*body);
    EXPECT_GT(difference, 0.);
    EXPECT_NEAR(body->energies(1e-7).fracture / difference, 1., 1e-10) << law.law;
    EXPECT_EQ(body->n_broken_bonds(), intact->count_bonds() - body->count_bonds());
  }
}
} // namespace
} // namespace ricochet::tests
