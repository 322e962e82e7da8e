// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonds that crack, push and part in the loops of kernels/lattice_kernel_loops.h and
// relaxing_force_loop.h, against plain loops.
#include "support/failing_bonds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace ricochet::tests
{
namespace
{
using Bond = std::pair<std::ptrdiff_t, int>; // first point and offset

/// What the stretch loop does to bonds and fields.
struct Stretch
{
  std::set<Bond> broken, parted, intact, cracked;
  std::vector<double> theta, strained;
};

Stretch stretch_as_written(const FailingBonds &bonds)
{
  Stretch result;
  result.theta.assign(bonds.lattice.size(), 0.);
  result.strained.assign(bonds.lattice.size(), 0.);
  bonds.for_each_bond(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const int k)
      {
        const auto &c  = bonds.table.constants[k];
        const double e = bonds.elastic_extension(p, q, k);
        bool intact = bonds.intact(p, k), cracked = bonds.cracked(p, k);
        const bool held   = bonds.hold[p] + bonds.hold[q] > 0.;
        const bool breaks = intact && e > c.critical && !held;
        intact            = intact && !breaks;
        const bool parts  = (cracked || breaks) &&
                           (e > bonds.table.parting || bonds.state.arrays.cracked == nullptr);
        cracked = (cracked || breaks) && !parts;
        const Bond bond{p, k};
        if (breaks)
          result.broken.insert(bond);
        if (parts)
          result.parted.insert(bond);
        if (intact)
          result.intact.insert(bond);
        if (cracked)
          result.cracked.insert(bond);
        const double limit = bonds.table.yield_stretch * c.length;
        for (const std::ptrdiff_t end : {p, q})
        {
          if (e < -limit || (intact && e > limit))
            result.strained[end] += 1.;
          if (intact && bonds.law.has_dilatation)
            result.theta[end] += c.dilatation * bonds.extension(p, q, k);
        }
      });
  return result;
}

Stretch stretch_by(const LatticeKernel &kernel, FailingBonds &bonds)
{
  auto &a = bonds.state.arrays;
  bonds.state.zero(bonds.lattice, a.theta);
  std::fill(bonds.strained.begin(), bonds.strained.end(), 0.);
  std::vector<BrokenBonds> log(kernel.registers_per_block * bonds.last_block * bonds.table.n);
  const auto n = kernel.stretch(a, bonds.table, 0, bonds.last_block, log.data());
  Stretch result;
  for (std::int64_t i = 0; i < n; ++i)
    for (int lane = 0; lane < Lattice::block_size; ++lane)
    {
      const Bond bond{log[i].block * Lattice::block_size + lane, log[i].offset};
      if ((log[i].broken >> lane) & 1)
      {
        EXPECT_TRUE(result.broken.insert(bond).second) << "logged twice";
      }
      if ((log[i].parted >> lane) & 1)
      {
        EXPECT_TRUE(result.parted.insert(bond).second) << "logged twice";
      }
    }
  bonds.for_each_bond(
      [&](const std::ptrdiff_t p, std::ptrdiff_t, const int k)
      {
        EXPECT_NE(bonds.intact(p, k), bonds.cracked(p, k)) << "a bond is one or the other";
        (bonds.intact(p, k) ? result.intact : result.cracked).insert({p, k});
      });
  result.theta.assign(a.theta, a.theta + bonds.lattice.size());
  result.strained = bonds.strained;
  return result;
}

void expect_equal(const std::vector<double> &got, const std::vector<double> &expected)
{
  double scale = 0.;
  for (const double value : expected)
    scale = std::max(scale, std::abs(value));
  for (std::size_t i = 0; i < got.size(); ++i)
    ASSERT_NEAR(got[i], expected[i], 1e-12 * scale) << i; // as in test_lattice_kernel.cc
}

TEST(CrackedBondLoops, BondsBreakCrackAndPartAsWritten)
{
  for (const auto &sample : bond_law_samples)
    for (const auto *const kernel : kernels_of(bond_law(sample.law)))
      for (const bool cracks_push : {true, false})
        for (const bool flows : {false, true})
        {
          FailingBonds bonds(sample, cracks_push);
          Random random(23);
          bonds.weigh(random);
          bonds.state.arrays.half_weight = nullptr;
          if (flows)
            bonds.flow(random);
          std::size_t n_at_once = 0, n_later = 0, n_cracked = 0;
          for (const double amplitude : {0.02, 0.06, 0.1, 0.2, 0.3, 0.05})
          {
            bonds.shake(random, amplitude);
            const auto expected = stretch_as_written(bonds);
            const auto got      = stretch_by(*kernel, bonds);
            EXPECT_EQ(got.broken, expected.broken);
            EXPECT_EQ(got.parted, expected.parted);
            EXPECT_EQ(got.intact, expected.intact);
            EXPECT_EQ(got.cracked, expected.cracked);
            expect_equal(got.theta, expected.theta);
            if (flows)
            {
              EXPECT_EQ(got.strained, expected.strained); // counts
            }
            for (const auto &bond : got.parted)
              ++(got.broken.count(bond) ? n_at_once : n_later);
            n_cracked += got.cracked.size();
          }
          EXPECT_GT(n_at_once, 50u);
          EXPECT_EQ(n_later > 50, cracks_push);
          EXPECT_EQ(n_cracked > 50, cracks_push);
        }
}

/// Forces and energies of points.
struct Loads
{
  std::vector<double> force[3], energy;
};

/// Adds those of the cracked bonds.
Loads pushes_as_written(const FailingBonds &bonds)
{
  Loads loads;
  for (auto *const field : {&loads.force[0], &loads.force[1], &loads.force[2], &loads.energy})
    field->assign(bonds.lattice.size(), 0.);
  const double *const weight = bonds.state.arrays.half_weight;
  bonds.for_each_bond(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const int k)
      {
        const double e = bonds.elastic_extension(p, q, k);
        if (!bonds.cracked(p, k) || e >= 0.)
          return;
        const double stiffness = bonds.table.cracked_share * bonds.table.constants[k].extension *
                                 (weight == nullptr ? 1. : weight[p] + weight[q]);
        const Vector3 pull = stiffness * e * bonds.apart(p, q).normalized();
        for (int d = 0; d < 3; ++d)
        {
          loads.force[d][p] += pull[d];
          loads.force[d][q] -= pull[d];
        }
        for (const std::ptrdiff_t end : {p, q})
          loads.energy[end] += 0.25 * stiffness * e * e;
      });
  return loads;
}

/// Those of intact bonds too, but of points' theta.
Loads loads_as_written(const FailingBonds &bonds)
{
  Loads loads                = pushes_as_written(bonds);
  const auto &a              = bonds.state.arrays;
  const double *const weight = a.half_weight;
  bonds.for_each_bond(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const int k)
      {
        if (!bonds.intact(p, k))
          return;
        BondConstants c = bonds.table.constants[k];
        c.extension *= weight == nullptr ? 1. : weight[p] + weight[q];
        const double e = bonds.elastic_extension(p, q, k);
        const Vector3 pull =
            bonds.law.tension(c, e, a.theta[p] + a.theta[q]) * bonds.apart(p, q).normalized();
        for (int d = 0; d < 3; ++d)
        {
          loads.force[d][p] += pull[d];
          loads.force[d][q] -= pull[d];
        }
        for (const std::ptrdiff_t end : {p, q})
          loads.energy[end] += 0.5 * bonds.law.bond_energy(c, e);
      });
  for (std::ptrdiff_t p = 0; p < bonds.lattice.size(); ++p)
    if (bonds.lattice.owned(p))
      loads.energy[p] += bonds.table.point_stiffness * a.theta[p] * a.theta[p] /
                         (weight == nullptr ? 1. : 2. * weight[p]);
  return loads;
}

/// What a loop makes of zero.
template <class Loop>
Loads loads_by(FailingBonds &bonds, Loop &&loop)
{
  auto &a = bonds.state.arrays;
  for (double *const field : {a.force[0], a.force[1], a.force[2], a.energy})
    bonds.state.zero(bonds.lattice, field);
  loop();
  const auto copy = [&](const double *const field)
  { return std::vector<double>(field, field + bonds.lattice.size()); };
  return {{copy(a.force[0]), copy(a.force[1]), copy(a.force[2])}, copy(a.energy)};
}

void expect_equal(const Loads &got, const Loads &expected, const bool energy)
{
  for (int d = 0; d < 3; ++d)
    expect_equal(got.force[d], expected.force[d]);
  if (energy)
    expect_equal(got.energy, expected.energy);
}

TEST(CrackedBondLoops, ForcesAndEnergiesAreThoseOfIntactBondsAndClosedCracks)
{
  for (const auto &sample : bond_law_samples)
    for (const auto *const kernel : kernels_of(bond_law(sample.law)))
      for (const bool weighted : {false, true})
        for (const bool flows : {false, true})
        {
          FailingBonds bonds(sample);
          Random random(31);
          bonds.shake(random, 0.03);
          bonds.crack(random);
          if (weighted)
            bonds.weigh(random);
          if (flows)
            bonds.flow(random);
          const auto loads = [&](const auto loop) {
            return loads_by(bonds,
                            [&] { loop(bonds.state.arrays, bonds.table, 0, bonds.last_block); });
          };
          const auto expected = loads_as_written(bonds);
          expect_equal(loads(weighted ? kernel->weighted_force : kernel->force), expected, false);
          expect_equal(
              loads(weighted ? kernel->weighted_force_and_energy : kernel->force_and_energy),
              expected, true);
        }
}

TEST(CrackedBondLoops, RelaxationAddsNothingToClosedCracks)
{
  const auto &sample                   = bond_law_samples[0];
  const std::vector<MaxwellStep> steps = {maxwell_step({0.3, 1e-6}, 1e-7),
                                          maxwell_step({0.2, 1e-5}, 1e-7)};
  for (const auto *const kernel : kernels_of(bond_law(sample.law)))
    for (const bool weighted : {false, true})
      for (const bool energy : {false, true})
      {
        FailingBonds bonds(sample);
        Random random(41);
        bonds.shake(random, 0.03);
        bonds.crack(random);
        if (weighted)
          bonds.weigh(random);
        const auto loop = weighted ? energy ? kernel->weighted_relaxing_force_and_energy
                                            : kernel->weighted_relaxing_force
                          : energy ? kernel->relaxing_force_and_energy
                                   : kernel->relaxing_force;
        std::vector<double> dissipated[2];
        std::vector<double> history(bonds.lattice.size() * bonds.table.n * steps.size());
        for (double &g : history)
          g = 0.02 * bonds.spacing * random.uniform();
        Loads loads[2];
        std::uint8_t *const cracked = bonds.state.arrays.cracked;
        for (const bool with_cracks : {false, true})
        {
          bonds.state.arrays.cracked = with_cracks ? cracked : nullptr;
          auto &heat                 = dissipated[with_cracks];
          heat.assign(bonds.lattice.size(), 0.);
          auto own_history = history;
          const RelaxingBonds relaxing{
              static_cast<int>(steps.size()), steps.data(), nullptr, own_history.data(),
              bonds.state.arrays.theta,       heat.data(),  1e-7};
          loads[with_cracks] = loads_by(
              bonds, [&] { loop(bonds.state.arrays, bonds.table, relaxing, 0, bonds.last_block); });
        }
        Loads expected = pushes_as_written(bonds);
        for (std::ptrdiff_t p = 0; p < bonds.lattice.size(); ++p)
        {
          for (int d = 0; d < 3; ++d)
            expected.force[d][p] += loads[0].force[d][p];
          expected.energy[p] += loads[0].energy[p];
        }
        expect_equal(loads[1], expected, energy);
        EXPECT_EQ(dissipated[0], dissipated[1]);
      }
}
} // namespace
} // namespace ricochet::tests
