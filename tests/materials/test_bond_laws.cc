// SPDX-License-Identifier: LGPL-2.1-or-later
// Each law against its own equation, written out once more from the paper.
#include "ricochet/base/exceptions.h"
#include "support/laws.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
TEST(LinearPeridynamicSolid, TensionIsTheForceStateOfBothEnds)
{
  // Silling et al. 2007: t = 3 K theta/m omega x + 15 mu/m omega e_d, e_d = e - theta x/3, theta =
  // 3/m sum omega x e V.
  const auto &law = bond_law("linear peridynamic solid");
  const FamilyConstants f{5.9e9, 2.258e9, 1e-9, 3.7e-14, 1.9e-11};
  Random random(59);
  for (int trial = 0; trial < 100; ++trial)
  {
    const double omega = 0.5 + 0.4 * random.uniform(), x = 1e-3 * (2. + random.uniform()),
                 e       = 1e-5 * random.uniform();
    const double theta_i = 1e-2 * random.uniform(), theta_j = 1e-2 * random.uniform();
    const auto state = [&](const double theta)
    {
      const double deviatoric = e - theta * x / 3.;
      return 3. * f.bulk_modulus * theta / f.weighted_volume * omega * x +
             15. * f.shear_modulus / f.weighted_volume * omega * deviatoric; // N/m^6
    };
    const double expected = (state(theta_i) + state(theta_j)) * f.volume * f.volume;
    const auto bond       = law.bond(f, x, omega);
    const double scale    = std::abs(state(theta_i)) * f.volume * f.volume + std::abs(expected);
    EXPECT_NEAR(law.tension(bond, e, theta_i + theta_j), expected, 1e-12 * scale);
    EXPECT_NEAR(bond.dilatation * e, 3. / f.weighted_volume * omega * x * e * f.volume, 1e-15);
    EXPECT_EQ(bond.length, x);
  }
}

TEST(LinearPeridynamicSolid, EnergyIsVolumetricPlusDeviatoric)
{
  // W = K theta^2/2 + 15 mu/(2 m) sum omega e_d^2 V for one random family, by both ways of writing
  // it.
  const auto &law = bond_law("linear peridynamic solid");
  Random random(61);
  const double V = 1e-9, K = 5.9e9, mu = 2.258e9;
  std::vector<double> x, omega, e;
  FamilyConstants f{K, mu, V, 0., 0.};
  for (int k = 0; k < 40; ++k)
  {
    x.push_back(1e-3 * (2. + random.uniform()));
    omega.push_back(0.5 + 0.4 * random.uniform());
    e.push_back(1e-5 * random.uniform());
    f.weighted_volume += omega[k] * x[k] * x[k] * V;
  }
  double theta = 0., bonds = 0.;
  for (int k = 0; k < 40; ++k)
  {
    const auto bond = law.bond(f, x[k], omega[k]);
    theta += bond.dilatation * e[k];
    bonds += 0.5 * law.bond_energy(bond, e[k]);
  }
  double W = 0.5 * K * theta * theta;
  for (int k = 0; k < 40; ++k)
    W += 7.5 * mu / f.weighted_volume * omega[k] * std::pow(e[k] - theta * x[k] / 3., 2) * V;
  EXPECT_NEAR((law.point_stiffness(f) * theta * theta + bonds) / (W * V), 1., 1e-12);
}

TEST(MicroelasticBrittle, TensionIsTheMicromodulusTimesTheStretch)
{
  // Silling and Askari 2005: f = c s, c = 18 K/(pi delta^4), per volume squared; the lattice sum
  // takes the place of pi delta^4 = integral of r over the sphere.
  const auto &law = bond_law("microelastic brittle");
  const double K = 40e9, delta = 3e-3, V = 1e-9;
  const FamilyConstants f{K, 0.6 * K, V, 1., M_PI * std::pow(delta, 4)};
  const double x = 2e-3, e = 1e-6;
  const auto bond = law.bond(f, x, 1.);
  EXPECT_NEAR(law.tension(bond, e, 0.3), 18. * K / (M_PI * std::pow(delta, 4)) * (e / x) * V * V,
              1e-12 * std::abs(law.tension(bond, e, 0.)));
  EXPECT_NEAR(law.bond_energy(bond, e), 0.5 * law.tension(bond, e, 0.) * e,
              1e-12 * law.bond_energy(bond, e));
  EXPECT_EQ(law.point_stiffness(f), 0.);
  EXPECT_FALSE(law.has_dilatation);
}

TEST(BondLaws, AreFoundByNameAndNumberedLikeTheMenu)
{
  for (std::size_t i = 0; i < bond_laws().size(); ++i)
  {
    EXPECT_EQ(bond_laws()[i].index, static_cast<int>(i));
    EXPECT_EQ(&bond_law(bond_laws()[i].name), &bond_laws()[i]);
  }
}

TEST(BondLaws, UnknownNameListsTheMenu)
{
  try
  {
    bond_law("chewing gum");
    FAIL() << "no error";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    for (const auto &name : bond_law_names())
      EXPECT_NE(message.find(name), std::string::npos) << message;
    EXPECT_NE(message.find("chewing gum"), std::string::npos) << message;
  }
}

TEST(InfluenceFunctions, FollowTheFormulaTheyName)
{
  for (const double ratio : {0.1, 0.5, 1.})
  {
    EXPECT_DOUBLE_EQ(influence(InfluenceFunction::cone, ratio), 1. - ratio);
    EXPECT_DOUBLE_EQ(influence(InfluenceFunction::constant, ratio), 1.);
    EXPECT_DOUBLE_EQ(influence(InfluenceFunction::gaussian, ratio), std::exp(-4. * ratio * ratio));
    EXPECT_DOUBLE_EQ(influence(InfluenceFunction::inverse, ratio), 1. / ratio);
  }
}
} // namespace
} // namespace ricochet::tests
