// SPDX-License-Identifier: LGPL-2.1-or-later
// Broken bonds that resist compression until their ends have parted: bond_tables.h.
#include "ricochet/contact/short_range_contact.h"
#include "support/failing_body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3, critical_stretch = 0.01, dt = 1e-7;

/// (K + 4 mu/3)/(3 mu)
double share(const PeridynamicMaterial &m)
{
  return p_wave_modulus(m) / (3. * m.shear_modulus);
}

/// Two points and their bond along x.
struct Pair
{
  explicit Pair(const BondLawSample &law = bond_law_samples[0])
  {
    BodySample sample;
    sample.family           = {law, InfluenceFunction::constant, 1.};
    sample.n                = {2, 1, 1};
    sample.critical_stretch = critical_stretch;
    bodies.push_back(make_failing_body(sample));
    p                     = body().lattice().index(0, 0, 0);
    q                     = body().lattice().index(1, 0, 0);
    const auto &constants = body().bond_constants();
    for (std::size_t k = 0; k < constants.size(); ++k)
      if (is_intact(body(), p, k))
        offset = k;
    stiffness = share(body().material()) * constants[offset].extension;
  }

  PeridynamicBody &body() { return *bodies[0]; }
  /// Moves the second point so that the bond is too long by so much, and takes a step.
  void extend(const double extension)
  {
    set(body().state().arrays.position, q, reference(body(), q) + Vector3(extension, 0., 0.));
    step();
  }
  void step()
  {
    body().update_ghosts();
    body().break_bonds();
    body().compute_internal_forces({true});
  }
  /// With which the bond pulls its ends together [N].
  double tension()
  {
    const Vector3 f = force(body(), p);
    EXPECT_EQ(force(body(), q), Vector3(-f)); // momentum, exactly
    return f.x();
  }
  bool parted() { return body().parted_bonds(p / 8, offset) != 0; }
  bool broken() { return body().broken_bonds(p / 8, offset) != 0; }

  std::vector<std::unique_ptr<PeridynamicBody>> bodies;
  std::ptrdiff_t p, q;
  std::size_t offset = 0;
  double stiffness; // of the crack [N/m]
};

TEST(CrackedBonds, OneBondGoesThroughAllItsStates)
{
  for (const auto &law : bond_law_samples)
  {
    Pair pair(law);
    const auto n_parted = [&]
    {
      int n = 0;
      pair.body().for_each_newly_parted_bond([&](auto...) { ++n; });
      return n;
    };
    pair.extend(0.9 * critical_stretch * dx);
    EXPECT_GT(pair.tension(), 0.);
    EXPECT_FALSE(pair.broken());
    for (const double closed : {-0.003, -0.1, -0.4}) // broken and open, broken and closed
    {
      pair.extend(0.2 * dx);
      EXPECT_EQ(pair.tension(), 0.);
      EXPECT_EQ(strain_energy(pair.body()), 0.);
      EXPECT_TRUE(pair.broken());
      EXPECT_FALSE(pair.parted());
      EXPECT_EQ(pair.body().damage(pair.p), 1.);
      EXPECT_EQ(n_parted(), 0);
      const double e = closed * dx;
      pair.extend(e);
      EXPECT_NEAR(pair.tension(), pair.stiffness * e, 1e-12 * pair.stiffness * dx);
      EXPECT_NEAR(strain_energy(pair.body()), 0.5 * pair.stiffness * e * e,
                  1e-12 * pair.stiffness * dx * dx);
    }
    pair.extend(0.2499 * dx);
    EXPECT_FALSE(pair.parted());
    pair.extend(0.2501 * dx);
    EXPECT_TRUE(pair.parted());
    EXPECT_EQ(n_parted(), 1);
    for (const double e : {-0.1, 0.5, -0.4, 0.})
    {
      pair.extend(e * dx);
      EXPECT_EQ(pair.tension(), 0.);
      EXPECT_EQ(strain_energy(pair.body()), 0.);
      EXPECT_TRUE(pair.parted());
      EXPECT_EQ(n_parted(), 0);
    }
    EXPECT_EQ(pair.body().bond_damage().damage(pair.p), 1.);
  }
}

TEST(CrackedBonds, BondThatBreaksFarApartPartsAtOnce)
{
  Pair pair;
  pair.extend(0.3 * dx);
  EXPECT_TRUE(pair.parted());
  pair.extend(-0.1 * dx);
  EXPECT_EQ(pair.tension(), 0.);
}

TEST(CrackedBonds, SlidingPartsThemToo)
{
  Pair pair;
  pair.extend(0.1 * dx);
  // sqrt(1 + 0.5^2) = 1.118, sqrt(1 + 0.76^2) = 1.256
  for (const double slide : {0.5, 0.76})
  {
    set(pair.body().state().arrays.position, pair.q,
        reference(pair.body(), pair.q) + Vector3(0., 0., slide * dx));
    pair.step();
    EXPECT_EQ(pair.parted(), slide > 0.7) << slide;
  }
}

TEST(CrackedBonds, BreakingReleasesTheEnergyAndPartingNone)
{
  Pair pair;
  pair.extend(0.);
  pair.body().end_step();
  double n_broken = 0., released = 0.;
  for (const double e : {0.02, -0.1, 0.26})
  {
    pair.extend(e * dx);
    pair.body().book_fracture(1e6); // so slow that the energy is that of this step
    pair.body().end_step();
    if (n_broken == 0.)
    {
      n_broken = pair.body().n_broken_bonds();
      released = pair.body().energies(dt).fracture;
    }
    EXPECT_EQ(pair.body().n_broken_bonds(), 1.);
    EXPECT_EQ(pair.body().energies(dt).fracture, released);
  }
  EXPECT_GT(std::abs(released), 0.);
}

TEST(CrackedBonds, LookBetweenStepsDoesNotPartThem)
{
  Pair pair;
  pair.extend(0.1 * dx);
  set(pair.body().state().arrays.position, pair.q,
      reference(pair.body(), pair.q) + Vector3(0.3 * dx, 0., 0.));
  pair.body().update_ghosts();
  pair.body().compute_internal_forces({true, /*is_step=*/false});
  EXPECT_FALSE(pair.parted());
  pair.body().break_bonds();
  EXPECT_TRUE(pair.parted());
}

TEST(CrackedBonds, ContactTakesOverOnceTheyHavePartedAndNotBefore)
{
  // Fast points make contact search anew at each step, slow ones go on with the pairs found at the
  // first.
  for (const double speed : {0., 1e6})
  {
    Pair pair;
    ShortRangeContact contact(MPI_COMM_SELF, pointers(pair.bodies), 1., false);
    const auto touching_at = [&](const double extension)
    {
      set(pair.body().state().arrays.velocity, pair.q, Vector3(speed, 0., 0.));
      pair.extend(extension * dx);
      contact.add_forces(dt);
      return contact.n_touching();
    };
    EXPECT_EQ(touching_at(0.), 0.);
    EXPECT_EQ(touching_at(0.02), 0.); // breaks
    EXPECT_EQ(touching_at(-0.2), 0.) << "the crack pushes: contact would count the pair twice";
    EXPECT_NEAR(pair.tension(), -0.2 * dx * pair.stiffness, 1e-12 * pair.stiffness * dx);
    EXPECT_EQ(touching_at(0.26), 0.); // parts
    EXPECT_EQ(touching_at(-0.05), 0.);
    EXPECT_EQ(pair.tension(), 0.);
    EXPECT_EQ(touching_at(-0.2), 1.);
    // Contact begins at 0.9 |xi|; the law of short_range_contact.h with a horizon of one spacing.
    const double K = pair.body().material().bulk_modulus;
    EXPECT_NEAR(pair.tension(), -0.1 * dx * 18. * K * dx / M_PI, 1e-12 * K * dx * dx);
  }
}

/// A pair with a broken bond closes with 10 m/s each and flies apart again; what the energy differs
/// at worst, over the initial one.
double energy_error_of_a_rebound(const double phase)
{
  Pair pair;
  auto &a            = pair.body().state().arrays;
  const double mass  = pair.body().point_mass();
  const double omega = std::sqrt(2. * pair.stiffness / mass), step = phase / omega, v = 10.;
  const double initial = mass * v * v;
  pair.extend(0.1 * dx); // breaks it
  set(a.velocity, pair.p, Vector3(v, 0., 0.));
  set(a.velocity, pair.q, Vector3(-v, 0., 0.));
  double worst = 0., shortest = 0., extension = 0.1 * dx;
  while (extension < 0.15 * dx)
  {
    pair.step();
    extension = position(pair.body(), pair.q).x() - position(pair.body(), pair.p).x() - dx;
    shortest  = std::min(shortest, extension);
    const auto energies = pair.body().energies(step);
    worst               = std::max(worst, std::abs(energies.kinetic + energies.strain - initial));
    EXPECT_EQ(at(a.velocity, pair.p), Vector3(-at(a.velocity, pair.q)));
    pair.body().advance(step, step);
  }
  EXPECT_NEAR(shortest, -2. * v / omega, 0.01 * v / omega) << "all energy in the bond";
  EXPECT_NEAR(at(a.velocity, pair.q).x(), v, phase * phase * v);
  return worst / initial;
}

TEST(CrackedBonds, ReboundKeepsTheEnergy)
{
  // Leapfrog is exact while the bond is closed; the steps in which it closes and opens cost (omega
  // dt)^2/2 at worst.
  for (const double phase : {0.2, 0.1, 0.05})
    EXPECT_LT(energy_error_of_a_rebound(phase), 0.5 * phase * phase) << phase;
}

} // namespace
} // namespace ricochet::tests
