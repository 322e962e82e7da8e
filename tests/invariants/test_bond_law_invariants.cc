// SPDX-License-Identifier: LGPL-2.1-or-later
// What every bond law must satisfy with every influence function, whatever its formula.
#include "support/body.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <set>

namespace ricochet::tests
{
namespace
{
class BondLawInvariant : public testing::TestWithParam<FamilySample>
{
protected:
  /// A box with a corner cut off and a hole, so that surfaces of all kinds take part.
  BodySample sample(const double critical_stretch = unbreakable) const
  {
    BodySample sample;
    sample.family           = GetParam();
    sample.n                = {6, 7, 5};
    sample.critical_stretch = critical_stretch;
    sample.mask             = [](const int x, const int y, const int z)
    { return x + y + z > 1 && !(x == 3 && y == 3 && z == 2); };
    return sample;
  }

  /// A displacement of up to a tenth of the spacing, one vector per point in the order of visits.
  static auto shaken(const unsigned int seed)
  {
    return [random = Random(seed)](const Vector3 &X) mutable -> Vector3
    { return X + 0.1e-3 * random.vector(); };
  }

  static std::vector<Vector3> forces(const PeridynamicBody &body)
  {
    std::vector<Vector3> all;
    for_each_point(body, [&](const std::ptrdiff_t p) { all.push_back(force(body, p)); });
    return all;
  }

  /// Force scale of the body when it is strained by about 0.1 [N].
  static double force_scale(PeridynamicBody &body)
  {
    deform(body, shaken(7));
    return largest_force(body);
  }
};

INSTANTIATE_TEST_SUITE_P(Laws, BondLawInvariant, testing::ValuesIn(family_samples()),
                         [](const auto &info)
                         {
                           return camel_case(info.param.law.law) + "With" +
                                  camel_case(name_of(info.param.influence_function));
                         });

TEST_P(BondLawInvariant, ReferenceConfigurationIsFreeOfForce)
{
  const auto body  = make_body(sample());
  const auto scale = force_scale(*body);
  deform(*body, [](const Vector3 &X) { return X; });
  // Bond lengths cancel to rounding, 1e-16 of the length against an extension of 0.1 of it.
  EXPECT_LT(largest_force(*body), 1e-13 * scale);
  EXPECT_GT(scale, 0.);
}

TEST_P(BondLawInvariant, ForcesAndMomentsSumToZero)
{
  const auto body = make_body(sample());
  deform(*body, shaken(1));
  Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
  double total = 0., total_moment = 0.;
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   sum += force(*body, p);
                   moment += position(*body, p).cross(force(*body, p));
                   total += force(*body, p).norm();
                   total_moment += position(*body, p).norm() * force(*body, p).norm();
                 });
  EXPECT_LT(sum.norm(), 1e-12 * total); // rounding of 200 summands
  EXPECT_LT(moment.norm(), 1e-12 * total_moment);
  EXPECT_GT(total, 0.);
}

TEST_P(BondLawInvariant, RigidMotionOfADeformedBodyTurnsItsForces)
{
  const auto body = make_body(sample());
  deform(*body, shaken(2));
  const auto before   = forces(*body);
  const double energy = strain_energy(*body), scale = largest_force(*body);
  // A quarter turn, which maps the lattice axes onto each other, and one which does not.
  for (const double angle : {M_PI / 2., 0.7})
  {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(angle,
                          Vector3(angle > 1. ? 0. : 0.3, angle > 1. ? 0. : -0.5, 1.).normalized())
            .toRotationMatrix();
    auto shake = shaken(2);
    deform(*body,
           [&](const Vector3 &X) -> Vector3 { return R * shake(X) + Vector3(4e-3, -7e-3, 2e-3); });
    const auto after = forces(*body);
    double error     = 0.;
    for (std::size_t i = 0; i < before.size(); ++i)
      error = std::max(error, (after[i] - R * before[i]).norm());
    // Extensions are differences of coordinates a hundred times as large.
    EXPECT_LT(error, 1e-12 * scale);
    EXPECT_NEAR(strain_energy(*body), energy, 1e-12 * energy);
  }
}

TEST_P(BondLawInvariant, RigidMotionAloneGivesNoForce)
{
  const auto body    = make_body(sample());
  const double scale = force_scale(*body);
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(M_PI / 2., Vector3::UnitZ()).toRotationMatrix() *
      Eigen::AngleAxisd(0.4, Vector3(1., 2., 3.).normalized()).toRotationMatrix();
  deform(*body, [&](const Vector3 &X) -> Vector3 { return R * X + Vector3(1e-3, 2e-3, 3e-3); });
  EXPECT_LT(largest_force(*body), 1e-12 * scale); // rounding of the rotated coordinates
}

TEST_P(BondLawInvariant, ForceIsMinusTheGradientOfTheEnergy)
{
  const auto body = make_body(sample());
  deform(*body, shaken(3));
  const double scale = largest_force(*body);
  const auto f       = forces(*body);
  auto &x            = body->state().arrays.position;

  // Central differences: truncation (h/dx)^2 = 1e-10, rounding 1e-16 of the energy over F h, 1e-10
  // too.
  const double h = 1e-8;
  double sum     = 0.;
  int i          = 0;
  for_each_point(
      *body,
      [&](const std::ptrdiff_t p)
      {
        const Vector3 analytic = f[i++];
        if (i % 17 != 1) // every 17th point, all directions: thirteen points of all kinds
          return;
        for (int d = 0; d < 3; ++d)
        {
          const double at_p = x[d][p];
          double difference[2];
          for (const int side : {0, 1})
          {
            x[d][p] = at_p + (side ? h : -h);
            body->compute_internal_forces({true});
            difference[side] = strain_energy(*body);
          }
          x[d][p] = at_p;
          EXPECT_NEAR(analytic[d], -(difference[1] - difference[0]) / (2. * h), 1e-8 * scale);
          sum += std::abs(analytic[d]);
        }
      });
  EXPECT_GT(sum, scale);
}

TEST_P(BondLawInvariant, MirrorImageHasMirroredForces)
{
  auto box        = sample();
  box.mask        = {};
  // Centred about the origin, so that the body is its own image; the random displacements are not.
  box.corner      = -0.5 * box.spacing * Vector3(box.n[0], box.n[1], box.n[2]);
  const auto body = make_body(box), image = make_body(box);
  deform(*body, shaken(4));
  const Lattice &l = body->lattice();
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto twin = [&](const std::ptrdiff_t p)
    {
      auto c  = l.coordinates(p);
      c[axis] = box.n[axis] - 1 - c[axis];
      return l.index(c[0], c[1], c[2]);
    };
    const auto reflect = [&](Vector3 v)
    {
      v[axis] *= -1.;
      return v;
    };
    for_each_point(*image, [&](const std::ptrdiff_t p)
                   { set(image->state().arrays.position, p, reflect(position(*body, twin(p)))); });
    image->update_ghosts();
    image->compute_internal_forces({true});
    double error = 0.;
    for_each_point(
        *image, [&](const std::ptrdiff_t p)
        { error = std::max(error, (force(*image, p) - reflect(force(*body, twin(p)))).norm()); });
    EXPECT_LT(error, 1e-13 * largest_force(*body)); // sums in another order
  }
}

TEST_P(BondLawInvariant, BrokenBondCarriesNothingAndNeverHeals)
{
  const auto body             = make_body(sample(/*critical_stretch=*/0.05));
  const auto intact           = make_body(sample());
  const Lattice &l            = body->lattice();
  const std::ptrdiff_t corner = l.index(5, 6, 4);
  const Vector3 X             = reference(*body, corner);
  // Outward along the diagonal every bond of the corner gets longer.
  const auto pulled           = [&](const double distance)
  {
    return [&, distance](const Vector3 &Y) -> Vector3
    { return Y == X ? X + distance * Vector3::Ones() : Y; };
  };
  deform(*body, pulled(2e-3), /*breaking=*/true);
  EXPECT_FALSE(body->bond_damage().log().empty());
  EXPECT_EQ(body->damage(corner), 1.);
  const double bonds = body->count_bonds();
  EXPECT_LT(bonds, intact->count_bonds());

  deform(
      *body, [](const Vector3 &Y) { return Y; }, /*breaking=*/true);
  EXPECT_TRUE(body->bond_damage().log().empty());
  EXPECT_EQ(body->count_bonds(), bonds);
  EXPECT_EQ(body->damage(corner), 1.);

  // Pushed in by a tenth of the spacing the corner feels nothing, and nobody feels it.
  const double scale = force_scale(*intact);
  deform(*body, pulled(-0.1e-3), /*breaking=*/true);
  EXPECT_EQ(force(*body, corner).norm(), 0.);
  EXPECT_LT(largest_force(*body), 1e-13 * scale); // rounding of the reference lengths
  deform(*intact, pulled(-0.1e-3));
  EXPECT_GT(force(*intact, corner).norm(), 0.01 * scale);
}

TEST_P(BondLawInvariant, BreakingIsTestedAlikeFromBothEnds)
{
  auto box        = sample(/*critical_stretch=*/0.03);
  box.mask        = {};
  box.corner      = -0.5 * box.spacing * Vector3(box.n[0], box.n[1], box.n[2]);
  const auto body = make_body(box), inverted = make_body(box);
  deform(*body, shaken(5), /*breaking=*/true);
  const Lattice &l = body->lattice();
  const auto twin  = [&](const std::ptrdiff_t p)
  {
    const auto c = l.coordinates(p);
    return l.index(box.n[0] - 1 - c[0], box.n[1] - 1 - c[1], box.n[2] - 1 - c[2]);
  };
  // A point inversion makes the first end of each bond its second.
  for_each_point(*inverted, [&](const std::ptrdiff_t p)
                 { set(inverted->state().arrays.position, p, -position(*body, twin(p))); });
  inverted->update_ghosts();
  inverted->break_bonds();
  inverted->compute_internal_forces({true});

  int n_intact = 0, n_broken = 0;
  const auto &offsets = l.stencil().offsets;
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   for (std::size_t k = 0; k < offsets.size(); ++k)
                   {
                     const auto c  = l.coordinates(p);
                     const auto &o = offsets[k];
                     const std::array<int, 3> end{c[0] + o.x, c[1] + o.y, c[2] + o.z};
                     bool inside = true;
                     for (int d = 0; d < 3; ++d)
                       inside = inside && end[d] >= 0 && end[d] < box.n[d];
                     if (!inside)
                       continue;
                     const bool here = is_intact(*body, p, k);
                     EXPECT_EQ(here,
                               is_intact(*inverted, twin(l.index(end[0], end[1], end[2])), k));
                     ++(here ? n_intact : n_broken);
                   }
                 });
  EXPECT_GT(n_intact, 100);
  EXPECT_GT(n_broken, 100);
}

TEST(LawTable, NamesEveryBondLawAndEveryFrictionLawOfTheMenus)
{
  std::set<std::string> menu, table;
  for (const auto &name : bond_law_names())
    menu.insert(name);
  for (const auto &sample : bond_law_samples)
    table.insert(sample.law);
  EXPECT_EQ(menu, table);
  menu.clear();
  table.clear();
  for (const auto &name : FrictionLaws::names())
    menu.insert(name);
  for (const auto &sample : friction_law_samples)
    table.insert(FrictionLaws::name(sample));
  EXPECT_EQ(menu, table);
}
} // namespace
} // namespace ricochet::tests
