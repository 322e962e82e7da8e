// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop that lets bonds flow, against the equations of peridynamics/bond_flow.h bond by bond.
#include "support/failing_bonds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ricochet::tests
{
namespace
{
constexpr double dt = 2e-7; // [s]

/// Per point, but for the first, which is per bond.
struct Flow
{
  std::vector<double> plastic, carrying, sum, square, dissipated;

  explicit Flow(const FailingBonds &bonds)
  {
    for (auto *const field : {&carrying, &sum, &square, &dissipated})
      field->assign(bonds.lattice.size(), 0.);
  }
};

/// Of each point, from 0 to 1/2, and the mean strain of its bonds that carry.
struct Shares
{
  std::vector<double> relaxing, mean;

  Shares(const FailingBonds &bonds, Random &random) :
    relaxing(bonds.lattice.size(), 0.), mean(bonds.lattice.size(), 0.)
  {
    bonds.lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          relaxing[p] = 0.5 * std::max(0., random.uniform()); // half of them rest
          mean[p]     = 0.01 * random.uniform();
        });
  }
};

/// Energy of an intact bond or a crack over half its stiffness: of the extension squared or, if
/// there is no compression, none.
double squared(const double e, const bool crack)
{
  return crack && e >= 0. ? 0. : e * e;
}

Flow flow_as_written(const FailingBonds &bonds, const Shares &shares)
{
  Flow result(bonds);
  const auto &a = bonds.state.arrays;
  bonds.for_each_bond(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const int k)
      {
        const auto &c     = bonds.table.constants[k];
        const bool crack  = bonds.cracked(p, k);
        const double ep   = bonds.plastic.read(p, k, 0);
        const double e    = bonds.extension(p, q, k) - ep;
        const double part = crack ? bonds.table.cracked_share : 1.;
        const Vector3 y =
            bonds.apart(p, q) - dt * (at(a.velocity, q) - at(a.velocity, p)); // one step ago
        const double then = y.norm() - c.length - ep;
        if (crack && e >= 0.) // open: neither flows nor carries
        {
          result.plastic.push_back(ep);
          return;
        }
        // u = tension/(30 mu omega V^2/m)
        const auto tension = [&](const double elastic)
        {
          return crack ? part * std::min(0., elastic)
                       : bonds.law.tension(c, elastic, a.theta[p] + a.theta[q]) / c.extension;
        };
        double du = 0.;
        for (const std::ptrdiff_t end : {p, q})
          du += shares.relaxing[end] * (tension(e) - c.length * shares.mean[end]);
        const double slip = du / part;
        result.plastic.push_back(ep + slip);
        const double now = e - slip, u = tension(now);
        // The heat is what the mean tension does while the bond slips: for both ends
        // k/2 (now + then) slip, without the part of an open crack.
        const double heat =
            0.5 * part * c.extension * slip *
            ((squared(now, crack) > 0. ? now : 0.) + (squared(then, crack) > 0. ? then : 0.));
        for (const std::ptrdiff_t end : {p, q})
        {
          result.carrying[end] += c.dilatation * c.length;
          result.sum[end] += c.dilatation * u;
          result.square[end] += 0.25 * c.extension * u * u;
          result.dissipated[end] += 0.5 * heat;
        }
      });
  return result;
}

Flow flow_by(const LatticeKernel &kernel, FailingBonds &bonds, const Shares &shares)
{
  Flow result(bonds);
  const FlowingBonds flowing{bonds.plastic.singles(),  shares.relaxing.data(),
                             shares.mean.data(),       result.carrying.data(),
                             result.sum.data(),        result.square.data(),
                             result.dissipated.data(), dt};
  kernel.flow(bonds.state.arrays, bonds.table, flowing, 0, bonds.last_block);
  bonds.for_each_bond([&](const std::ptrdiff_t p, std::ptrdiff_t, const int k)
                      { result.plastic.push_back(bonds.plastic.read(p, k, 0)); });
  return result;
}

void expect_equal(const std::vector<double> &got, const std::vector<double> &expected,
                  const double tolerance)
{
  ASSERT_EQ(got.size(), expected.size());
  double scale = 0.;
  for (const double value : expected)
    scale = std::max(scale, std::abs(value));
  EXPECT_GT(scale, 0.);
  for (std::size_t i = 0; i < got.size(); ++i)
    ASSERT_NEAR(got[i], expected[i], tolerance * scale) << i;
}

TEST(FlowLoop, AgreesWithTheEquationsBondByBond)
{
  for (const auto *const kernel : kernels_of(bond_law(bond_law_samples[0].law)))
  {
    FailingBonds bonds(bond_law_samples[0]);
    Random random(61);
    bonds.shake(random, 0.03);
    bonds.crack(random);
    bonds.flow(random);
    const Shares shares(bonds, random);
    const auto expected = flow_as_written(bonds, shares);
    const auto got      = flow_by(*kernel, bonds, shares);
    // Kept in single precision; the sums as in test_lattice_kernel.cc, before that is rounded.
    expect_equal(got.plastic, expected.plastic, 1e-7);
    expect_equal(got.carrying, expected.carrying, 1e-12);
    expect_equal(got.sum, expected.sum, 1e-12);
    expect_equal(got.square, expected.square, 1e-12);
    expect_equal(got.dissipated, expected.dissipated, 1e-12);
  }
}

TEST(FlowLoop, WithoutSharesItOnlySums)
{
  for (const auto *const kernel : kernels_of(bond_law(bond_law_samples[0].law)))
  {
    FailingBonds bonds(bond_law_samples[0]);
    Random random(67);
    bonds.shake(random, 0.03);
    bonds.crack(random);
    bonds.flow(random);
    Shares shares(bonds, random);
    std::fill(shares.relaxing.begin(), shares.relaxing.end(), 0.);
    const auto expected = flow_as_written(bonds, shares);
    const auto got      = flow_by(*kernel, bonds, shares);
    EXPECT_EQ(got.plastic, expected.plastic);
    expect_equal(got.square, expected.square, 1e-12);
    for (const double heat : got.dissipated)
      ASSERT_EQ(heat, 0.);
  }
}

TEST(FlowLoop, FullSharesOfBothEndsTakeTheWholeDeviatoricPart)
{
  // One mean for all points and half from either end: u = |xi| M remains, and nothing of a crack
  // that M would pull at.
  for (const auto *const kernel : kernels_of(bond_law(bond_law_samples[0].law)))
    for (const double mean : {-0.01, 0.01})
    {
      FailingBonds bonds(bond_law_samples[0]);
      Random random(71);
      bonds.shake(random, 0.03);
      bonds.crack(random);
      Shares shares(bonds, random);
      std::fill(shares.relaxing.begin(), shares.relaxing.end(), 0.5);
      std::fill(shares.mean.begin(), shares.mean.end(), mean);
      std::vector<double> square(bonds.lattice.size(), 0.), sum = square;
      bonds.for_each_bond(
          [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const int k)
          {
            const auto &c = bonds.table.constants[k];
            if (bonds.cracked(p, k) && (bonds.extension(p, q, k) >= 0. || mean > 0.))
              return;
            for (const std::ptrdiff_t end : {p, q})
            {
              sum[end] += c.dilatation * c.length * mean;
              square[end] += 0.25 * c.extension * std::pow(c.length * mean, 2);
            }
          });
      const auto got = flow_by(*kernel, bonds, shares);
      expect_equal(got.sum, sum, 1e-12);
      expect_equal(got.square, square, 1e-12);
    }
}
} // namespace
} // namespace ricochet::tests
