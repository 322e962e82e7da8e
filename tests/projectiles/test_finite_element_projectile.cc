// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole impacts with a deformable projectile: of finite elements, of peridynamic points, of both.
#include "projectiles/finite_element_projectile.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace ricochet::tests
{
namespace
{
class ElasticImpact : public testing::TestWithParam<Scene>
{
};

INSTANTIATE_TEST_SUITE_P(
    Scenes, ElasticImpact,
    testing::Values(deformable(small_scene()), deformable(symmetric(small_scene())),
                    deformable(symmetric(two_plates())), peridynamic(small_scene()),
                    peridynamic(symmetric(two_plates())), peridynamic_nose(small_scene()),
                    peridynamic_nose(symmetric(two_plates()))),
    [](const auto &info)
    {
      return std::string(model_name(info.param)) + (info.param.symmetric ? "Half" : "Full") +
             (info.param.plates.size() > 1 ? "TwoPlates" : "OnePlate");
    });

TEST_P(ElasticImpact, EnergyAndMomentaBalance)
{
  Simulation simulation(MPI_COMM_SELF, GetParam());
  EXPECT_LT(simulation.time_step_info().projectile_dt, simulation.time_step_info().plates_dt);
  EXPECT_EQ(simulation.dt(), simulation.time_step_info().projectile_dt);
  const auto before = simulation.momenta();
  EXPECT_NEAR(before.linear.norm(), 0.8e-3 * 300., 1e-13);
  const double arm    = simulation.projectile().motion().position.norm();
  double most_elastic = 0.;
  const double end    = 60e-6;
  for (int i = 0; simulation.time() < end; ++i)
  {
    simulation.compute_forces(i % 25 == 0);
    if (i % 25 == 0)
    {
      const auto e = simulation.energies();
      EXPECT_LT(std::abs(e.residual()), 0.005 * e.initial) << "step " << i;
      most_elastic   = std::max(most_elastic, e.elastic);
      const auto now = simulation.momenta();
      EXPECT_LT((now.linear - before.linear).norm(), 1e-12 * before.linear.norm());
      EXPECT_LT((now.angular - before.angular).norm(), 1e-12 * arm * before.linear.norm());
    }
    simulation.advance();
  }
  EXPECT_GT(simulation.broken_bonds(), 10000.);
  EXPECT_GT(most_elastic, 1e-4 * simulation.energies().initial);
  EXPECT_LT(most_elastic, 0.05 * simulation.energies().initial);
}

/// Of those that elements take.
Scene small_steps(Scene scene)
{
  scene.time.safety_factor *= 0.25;
  return scene;
}

class DeformableHalfModel : public testing::TestWithParam<Scene>
{
};

INSTANTIATE_TEST_SUITE_P(Models, DeformableHalfModel,
                         testing::Values(deformable(small_scene()),
                                         small_steps(modal(small_scene())),
                                         peridynamic(small_scene()),
                                         peridynamic_nose(small_scene())),
                         [](const auto &info) { return model_name(info.param); });

TEST_P(DeformableHalfModel, EqualsTheFullModelBeforeDamage)
{
  Scene scene                         = GetParam();
  scene.materials[0].critical_stretch = 10.;
  Scene half_scene                    = symmetric(scene);
  Simulation full(MPI_COMM_SELF, scene);
  half_scene.time.safety_factor *= full.dt() / Simulation(MPI_COMM_SELF, half_scene).dt();
  Simulation half(MPI_COMM_SELF, half_scene);
  ASSERT_NEAR(half.dt(), full.dt(), 1e-15 * full.dt());
  for (int i = 0; i < 300; ++i)
  {
    full.compute_forces(true);
    half.compute_forces(true);
    if (i % 50 == 0 || i == 299)
    {
      const auto &f = full.projectile().motion(), &h = half.projectile().motion();
      EXPECT_LT((f.velocity - h.velocity).norm(), 1e-10 * 300.);
      EXPECT_LT((f.position - h.position).norm(), 1e-10 * 1e-3);
      EXPECT_LT((f.spin - h.spin).norm(), 1e-10 * 1e4);
      const auto e = full.energies(), g = half.energies();
      for (const auto term : std::initializer_list<double EnergyBalance::*>{
               &EnergyBalance::projectile, &EnergyBalance::elastic, &EnergyBalance::kinetic,
               &EnergyBalance::strain, &EnergyBalance::contact, &EnergyBalance::friction})
        EXPECT_NEAR(e.*term, g.*term, 1e-10 * e.initial);
      EXPECT_EQ(full.reaction().n_touching, half.reaction().n_touching);
    }
    full.advance();
    half.advance();
  }
  EXPECT_GT(full.energies().contact, 0.);
}

class DeformableMotion : public testing::TestWithParam<Scene>
{
};

INSTANTIATE_TEST_SUITE_P(Models, DeformableMotion,
                         testing::Values(deformable(symmetric(small_scene())),
                                         modal(symmetric(small_scene())),
                                         peridynamic(symmetric(small_scene())),
                                         peridynamic_nose(symmetric(small_scene()))),
                         [](const auto &info) { return model_name(info.param); });

TEST_P(DeformableMotion, IsThatOfTheRigidProjectile)
{
  // An unbroken plate: fracture would amplify what the facets change. Steel hardly bends here.
  Scene rigid_scene                         = symmetric(small_scene());
  rigid_scene.materials[0].critical_stretch = 10.;
  Scene elastic_scene                       = GetParam();
  elastic_scene.materials                   = rigid_scene.materials;
  elastic_scene.projectile.refinement       = 3;
  Simulation elastic(MPI_COMM_SELF, elastic_scene);
  rigid_scene.time.safety_factor *= elastic.dt() / Simulation(MPI_COMM_SELF, rigid_scene).dt();
  Simulation rigid(MPI_COMM_SELF, rigid_scene);
  ASSERT_NEAR(rigid.dt(), elastic.dt(), 1e-15 * rigid.dt());
  EXPECT_LT((rigid.projectile().motion().position - elastic.projectile().motion().position).norm(),
            0.05e-3);
  while (rigid.time() < 25e-6)
    for (Simulation *simulation : {&rigid, &elastic})
    {
      simulation->compute_forces(false);
      simulation->advance();
    }
  const Vector3 start(300. * std::cos(M_PI / 6.), 0., -300. * std::sin(M_PI / 6.));
  const Vector3 change = rigid.projectile().motion().velocity - start;
  EXPECT_GT(change.norm(), 20.);
  EXPECT_LT((elastic.projectile().motion().velocity - rigid.projectile().motion().velocity).norm(),
            0.05 * change.norm());
  EXPECT_NEAR(elastic.projectile().pitch(), rigid.projectile().pitch(),
              0.05 * (rigid.projectile().pitch() + M_PI / 6.));
}

TEST(FiniteElementProjectile, SurfaceIsClosedAndItsOutlineGoesAroundTheBody)
{
  for (const bool half : {false, true})
  {
    Scene scene                 = deformable(small_scene());
    scene.projectile.refinement = 2;
    if (half)
      scene = symmetric(scene);
    const Simulation simulation(MPI_COMM_SELF, scene);
    const auto frame = simulation.surface();
    double enclosed  = 0.;
    for (const auto &quad : frame.quads)
      for (int i = 1; i < 3; ++i)
        enclosed += frame.vertices[quad[0]].dot(
                        frame.vertices[quad[i]].cross(frame.vertices[quad[i + 1]])) /
                    6.;
    const double volume = simulation.projectile().body().volume();
    EXPECT_NEAR(enclosed, volume, 0.03 * volume); // one way to cut curved quadrilaterals
    double area = 0.;
    for (std::size_t i = 0; i < frame.outline.size(); ++i)
    {
      const Vector3 &a = frame.outline[i], &b = frame.outline[(i + 1) % frame.outline.size()];
      area += 0.5 * (a.x() * b.z() - a.z() * b.x());
      EXPECT_EQ(a.y(), 0.);
    }
    double expected    = 0.; // twice the area under the generating line
    const auto profile = simulation.projectile().body().profile(100);
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
      expected += (profile[i + 1][0] - profile[i][0]) * (profile[i + 1][1] + profile[i][1]);
    EXPECT_NEAR(area, expected, 0.03 * expected); // corners stand out from the shape
  }
}
} // namespace
} // namespace ricochet::tests
