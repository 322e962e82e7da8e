// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/body.h"
#include "support/reference_family.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
enum class Form
{
  full,
  with_holes,
  mirrored
};

struct KernelCase
{
  BondLawSample law;
  const char *instruction_set;
  Form form;
  double horizon_ratio;
  InfluenceFunction influence_function;
};

std::ostream &operator<<(std::ostream &out, const KernelCase &test)
{
  return out << test.law.law << " on " << test.instruction_set;
}

std::vector<KernelCase> kernel_cases()
{
  std::vector<KernelCase> cases;
  for (const auto &law : bond_law_samples)
    for (const char *set : {"baseline", "avx2", "avx512"})
    {
      cases.push_back({law, set, Form::full, 3., InfluenceFunction::cone});
      cases.push_back({law, set, Form::with_holes, 3., InfluenceFunction::constant});
      cases.push_back({law, set, Form::mirrored, 3., InfluenceFunction::cone});
      cases.push_back({law, set, Form::mirrored, 2.2, InfluenceFunction::inverse});
    }
  return cases;
}

std::string form_name(const Form form)
{
  return form == Form::full ? "FullBox" : form == Form::with_holes ? "BoxWithHoles" : "MirroredBox";
}

class LatticeKernel : public testing::TestWithParam<KernelCase>
{
};

INSTANTIATE_TEST_SUITE_P(Cases, LatticeKernel, testing::ValuesIn(kernel_cases()),
                         [](const auto &info)
                         {
                           return camel_case(info.param.law.law) + "On" +
                                  camel_case(info.param.instruction_set) + "In" +
                                  form_name(info.param.form) + "With" +
                                  camel_case(name_of(info.param.influence_function));
                         });

TEST_P(LatticeKernel, AgreesWithTheFamilyByFamilyReference)
{
  const auto &test = GetParam();
  if (lattice_kernel(bond_law(test.law.law).index, test.instruction_set) == nullptr)
    GTEST_SKIP() << "this processor does not have " << test.instruction_set;

  constexpr double spacing = 1e-3, critical_stretch = 0.04;
  BodySample sample;
  sample.family           = {test.law, test.influence_function, test.horizon_ratio};
  sample.critical_stretch = critical_stretch;
  sample.instruction_set  = test.instruction_set;
  sample.n                = {7, 6, 5}; // no multiple of 8 anywhere: rows end inside blocks
  sample.mirror_y         = test.form == Form::mirrored;
  if (test.form == Form::with_holes)
    sample.mask = [](const int x, const int y, const int z)
    { return (5 * x + 3 * y + 7 * z) % 11 != 0; };
  const auto body = make_body(sample);

  // The reference knows no symmetry plane: it gets the other half as points of its own.
  std::vector<Vector3> X;
  std::vector<std::ptrdiff_t> flat;
  std::map<std::ptrdiff_t, int> number; // of the body's points, images included
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   number[p] = static_cast<int>(X.size());
                   X.push_back(reference(*body, p));
                   flat.push_back(p);
                 });
  const int n = static_cast<int>(X.size());
  if (sample.mirror_y)
    for (int i = 0; i < n; ++i)
      X.push_back({X[i].x(), -X[i].y(), X[i].z()});
  body->lattice().for_each_image(
      [&](const std::ptrdiff_t image, const std::ptrdiff_t original)
      {
        if (number.count(original))
          number[image] = number[original] + n;
      });
  ReferenceFamilies oracle(X, spacing, test.horizon_ratio, test.influence_function,
                           bond_law(test.law.law), test.law.bulk_modulus, test.law.shear_modulus);

  Random random(11);
  const int n_offsets = static_cast<int>(body->lattice().stencil().offsets.size());
  int n_broken_before = 0;
  for (int round = 0; round < 3; ++round)
  {
    // Broken bonds accumulate over the rounds.
    for (int i = 0; i < n; ++i)
    {
      oracle.position[i] = X[i] + 0.03 * (round + 1) * spacing * random.vector();
      set(body->state().arrays.position, flat[i], oracle.position[i]);
      if (sample.mirror_y)
        oracle.position[n + i] = {oracle.position[i].x(), -oracle.position[i].y(),
                                  oracle.position[i].z()};
    }
    oracle.break_bonds(critical_stretch);
    oracle.evaluate();
    body->update_ghosts();
    body->break_bonds();
    body->compute_internal_forces({true});

    double force_scale = 0., energy_scale = 0., theta_scale = 0.;
    for (int i = 0; i < n; ++i)
    {
      force_scale  = std::max(force_scale, oracle.force[i].norm());
      energy_scale = std::max(energy_scale, std::abs(oracle.energy[i]));
      theta_scale  = std::max(theta_scale, std::abs(oracle.dilatation[i]));
    }
    // Extensions of a per cent of dx from coordinates of ten dx: 1e-16 * 10 / 0.01 = 1e-13, and
    // sums of 122 terms.
    const auto &a = body->state().arrays;
    for (int i = 0; i < n; ++i)
    {
      EXPECT_LT((force(*body, flat[i]) - oracle.force[i]).norm(), 1e-12 * force_scale);
      EXPECT_NEAR(a.energy[flat[i]], oracle.energy[i], 1e-12 * energy_scale);
      EXPECT_NEAR(a.theta[flat[i]], oracle.dilatation[i], 1e-12 * theta_scale);
    }
    EXPECT_EQ(theta_scale > 1e-3, bond_law(test.law.law).has_dilatation);

    // The force without energies is another loop.
    std::vector<Vector3> with_energy;
    for (int i = 0; i < n; ++i)
      with_energy.push_back(force(*body, flat[i]));
    body->break_bonds();
    body->compute_internal_forces({false});
    EXPECT_TRUE(body->bond_damage().log().empty());
    for (int i = 0; i < n; ++i)
      EXPECT_EQ(force(*body, flat[i]), with_energy[i]);

    // Every bond is broken here as there.
    std::map<std::pair<int, int>, bool> intact;
    for (int i = 0; i < static_cast<int>(X.size()); ++i)
      for (const auto &neighbour : oracle.neighbours[i])
        intact[{i, neighbour.point}] = neighbour.intact;
    int n_bonds = 0, n_broken = 0;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n_offsets; ++k)
      {
        const auto q =
            number.find(flat[i] + body->lattice().shift(body->lattice().stencil().offsets[k]));
        if (q == number.end())
          continue;
        const auto from = body->lattice().coordinates(flat[i]),
                   to   = body->lattice().coordinates(q->first);
        const auto &o   = body->lattice().stencil().offsets[k];
        if (to != std::array<int, 3>{from[0] + o.x, from[1] + o.y, from[2] + o.z})
        {
          EXPECT_FALSE(is_intact(*body, flat[i], k)) << "the shift runs over a row's end";
          continue;
        }
        EXPECT_EQ(is_intact(*body, flat[i], k), (intact.at({i, q->second})));
        ++n_bonds;
        n_broken += !intact.at({i, q->second});
      }
    EXPECT_GT(n_broken, n_broken_before);
    EXPECT_LT(n_broken, n_bonds);
    n_broken_before = n_broken;

    for (int i = 0; i < n; i += 10)
    {
      int gone = 0;
      for (const auto &neighbour : oracle.neighbours[i])
        gone += !neighbour.intact;
      EXPECT_NEAR(body->damage(flat[i]), double(gone) / oracle.neighbours[i].size(),
                  1e-15); // 1 - x
    }
  }
}

TEST(LatticeKernelTable, UnknownInstructionSetHasNoKernel)
{
  EXPECT_EQ(lattice_kernel(0, "abacus"), nullptr);
  ASSERT_NE(lattice_kernel(0, "baseline"), nullptr);
  ASSERT_NE(lattice_kernel(0), nullptr);
  EXPECT_STREQ(lattice_kernel(0, "baseline")->instruction_set, "baseline");
}

TEST(LatticeKernelTable, LogHasRoomForAllBondsThatBreakInOneStep)
{
  for (const char *set_name : {"baseline", "avx2", "avx512"})
  {
    if (lattice_kernel(0, set_name) == nullptr)
      continue;
    BodySample sample;
    sample.n                = {16, 16, 16};
    sample.critical_stretch = 0.01;
    sample.instruction_set  = set_name;
    const auto body         = make_body(sample);
    for_each_point(*body, [&](const std::ptrdiff_t p)
                   { set(body->state().arrays.position, p, 2. * reference(*body, p)); });
    body->update_ghosts();
    body->break_bonds();
    body->compute_internal_forces({false});
    const auto &log = body->bond_damage().log();
    ASSERT_LE(log.size(), log.capacity()) << set_name;
    double n_broken = 0.;
    log.for_each([&](std::ptrdiff_t, std::ptrdiff_t, std::size_t) { n_broken += 1.; });
    EXPECT_EQ(n_broken, body->count_sound_bonds()) << set_name;
    EXPECT_EQ(body->count_bonds(), 0.) << set_name;
  }
}

TEST(LatticeKernelTable, AdvanceKicksAndDriftsOwnedPointsOnly)
{
  for (const char *set_name : {"baseline", "avx2", "avx512"})
  {
    if (lattice_kernel(0, set_name) == nullptr)
      continue;
    BodySample sample;
    sample.n               = {3, 5, 3};
    sample.mirror_y        = true;
    sample.instruction_set = set_name;
    const auto body        = make_body(sample);
    auto &a                = body->state().arrays;
    Random random(3);
    for (std::ptrdiff_t p = 0; p < body->lattice().size(); ++p)
    {
      set(a.velocity, p, random.vector());
      set(a.force, p, random.vector());
    }
    std::vector<Vector3> x, v, f;
    for (std::ptrdiff_t p = 0; p < body->lattice().size(); ++p)
    {
      x.push_back(at(a.position, p));
      v.push_back(at(a.velocity, p));
      f.push_back(at(a.force, p));
    }
    const double kick = 2e-6, drift = 3e-6;
    body->advance(kick, drift);
    int n_owned = 0;
    for (std::ptrdiff_t p = body->lattice().owned_begin(); p < body->lattice().owned_end(); ++p)
      if (body->lattice().owned(p))
      {
        const Vector3 velocity = v[p] + kick / body->point_mass() * f[p];
        EXPECT_LT((at(a.velocity, p) - velocity).norm(),
                  1e-15 * velocity.norm() * 4.);                                  // fused or not
        EXPECT_LT((at(a.position, p) - (x[p] + drift * velocity)).norm(), 1e-17); // metres of 1e-2
        ++n_owned;
      }
      else
        EXPECT_EQ((at(a.position, p) - x[p]).norm(), 0.)
            << "a point that is not integrated here moved";
    EXPECT_EQ(n_owned, 45);
  }
}
} // namespace
} // namespace ricochet::tests
