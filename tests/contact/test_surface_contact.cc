// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/friction_laws.h"
#include "ricochet/contact/rigid_contact.h"
#include "ricochet/contact/surface_contact.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3;
const BodyOfRevolution core({NoseShape::ogive, 6e-3, 20e-3, 9e-3});

Vector3 node_of(const std::vector<double> &values, const int node)
{
  return {values[3 * node], values[3 * node + 1], values[3 * node + 2]};
}

/// All that contact sees of a body: its nodes.
struct Nodes
{
  HexSolid solid;
  RigidBody::Motion motion;
  std::vector<double> position, velocity, force;
  std::vector<double> mobility; // per node [1/kg]

  explicit Nodes(const HexSolid &mesh) :
    solid(mesh), force(3 * mesh.nodes.size(), 0.), mobility(mesh.nodes.size(), 1e4)
  {
  }

  operator SurfaceNodes() { return {position, velocity, force, mobility}; }
  int n_nodes() const { return static_cast<int>(solid.nodes.size()); }

  void set_motion(const RigidBody::Motion &rigid)
  {
    motion               = rigid;
    const Vector3 centre = centroid(solid);
    position.clear();
    velocity.clear();
    for (const auto &node : solid.nodes)
    {
      const Vector3 arm = rigid.orientation * (node - centre);
      const Vector3 x = rigid.position + arm, v = rigid.velocity + rigid.spin.cross(arm);
      position.insert(position.end(), x.data(), x.data() + 3);
      velocity.insert(velocity.end(), v.data(), v.data() + 3);
    }
  }
};

/// A plate whose points are shaken out of place, and a bent, tumbling core that ploughs through it.
struct Ploughing
{
  std::unique_ptr<PeridynamicBody> plate;
  Nodes body;
  FacetedSurface surface;
  std::vector<char> is_shank;
  Vector3 centre;

  explicit Ploughing(const int refinement = 2) :
    body(revolved_hexes(core, refinement)), surface(surface_of(body.solid))
  {
    BodySample sample;
    sample.n      = {30, 12, 4};
    sample.corner = {-15. * dx, -6. * dx, -4. * dx};
    plate         = make_body(sample);
    Random random(47);
    auto &a = plate->state().arrays;
    for_each_point(*plate,
                   [&](const std::ptrdiff_t p)
                   {
                     set(a.position, p, reference(*plate, p) + 0.1 * dx * random.vector());
                     set(a.velocity, p, 50. * random.vector());
                   });
    RigidBody::Motion motion;
    motion.position    = Vector3(0., 0.3 * dx, 2.6 * dx); // nothing deeper than the surface looks
    motion.orientation = Eigen::AngleAxisd(0.15, Vector3::UnitY());
    motion.velocity    = Vector3(200., -30., -60.);
    motion.spin        = Vector3(3000., -9000., 2000.);
    body.set_motion(motion);
    for (double &x : body.position)
      x += 0.03e-3 * random.uniform();
    for (double &v : body.velocity)
      v += 10. * random.uniform();
    for (const auto &quad : surface.faces())
    {
      Vector3 middle = Vector3::Zero();
      for (const int node : quad)
        middle += 0.25 * body.solid.nodes[node];
      is_shank.push_back(core.hit(middle).surface == BodyOfRevolution::Surface::shank);
    }
    centre = body.motion.position;
    surface.update(body.position, 1.5 * dx);
    clear();
  }

  void clear()
  {
    for_each_point(*plate, [&](const std::ptrdiff_t p)
                   { set(plate->state().arrays.force, p, Vector3::Zero()); });
    std::fill(body.force.begin(), body.force.end(), 0.);
  }
};

SurfaceContact make_contact(const FrictionLaw &law, const double shank, const Ploughing &scene)
{
  return SurfaceContact(MPI_COMM_SELF, law, {5e6, shank, 5.}, false, 30, scene.is_shank);
}

TEST(SurfaceContact, ForcesAndMomentsOnPointsAndNodesCancel)
{
  for (const auto &friction : friction_law_samples)
  {
    Ploughing scene;
    const auto law = make_friction_law(friction);
    auto contact   = make_contact(*law, 40., scene);
    const auto reaction =
        contact.add_forces(scene.body, scene.surface, scene.centre, *scene.plate, 0.);
    Vector3 sum = Vector3::Zero(), moment = Vector3::Zero(), nodes = Vector3::Zero(),
            node_moment = Vector3::Zero();
    double total        = 0.;
    int n               = 0;
    for_each_point(*scene.plate,
                   [&](const std::ptrdiff_t p)
                   {
                     const Vector3 f = force(*scene.plate, p);
                     sum += f;
                     moment += (position(*scene.plate, p) - scene.centre).cross(f);
                     total += f.norm();
                     n += f.norm() > 0.;
                   });
    for (int node = 0; node < scene.body.n_nodes(); ++node)
    {
      const Vector3 f = node_of(scene.body.force, node);
      nodes += f;
      node_moment += (node_of(scene.body.position, node) - scene.centre).cross(f);
    }
    EXPECT_GT(n, 20);
    EXPECT_EQ(reaction.n_touching, n);
    EXPECT_GT(reaction.friction.norm(), 0.);
    EXPECT_GT(reaction.shank.norm(), 0.) << "the shank must touch, too";
    EXPECT_LT((sum + nodes).norm(), 1e-13 * total);
    EXPECT_LT((moment + node_moment).norm(), 1e-12 * total * 20e-3);
    EXPECT_LT((reaction.force() - nodes).norm(), 1e-13 * total);
    EXPECT_LT((reaction.moment - node_moment).norm(), 1e-13 * total * 20e-3);
  }
}

TEST(SurfaceContact, NormalForcesAreTheGradientOfTheStoredEnergy)
{
  Ploughing scene;
  const auto law    = make_friction_law(ConstantFriction::Parameters{0.});
  auto contact      = make_contact(*law, 0., scene);
  const auto energy = [&]
  {
    scene.clear();
    scene.surface.update(scene.body.position, 1.5 * dx);
    return contact.add_forces(scene.body, scene.surface, scene.centre, *scene.plate, 0.).energy;
  };
  energy();
  const auto on_nodes = scene.body.force;
  std::vector<std::pair<std::ptrdiff_t, Vector3>> on_points;
  for_each_point(*scene.plate,
                 [&](const std::ptrdiff_t p)
                 {
                   if (force(*scene.plate, p).norm() > 0.)
                     on_points.emplace_back(p, force(*scene.plate, p));
                 });
  double typical = 0.;
  for (const double f : on_nodes)
    typical = std::max(typical, std::abs(f));
  ASSERT_GT(typical, 100.);
  const double h = 1e-9;
  int n_checked  = 0;
  for (std::size_t i = 0; i < on_nodes.size(); ++i)
    if (on_nodes[i] != 0. && i % 3 == i / 3 % 3) // one component of each node
    {
      double &x         = scene.body.position[i];
      const double here = x;
      x                 = here + h;
      const double up   = energy();
      x                 = here - h;
      const double down = energy();
      x                 = here;
      EXPECT_NEAR(on_nodes[i], -(up - down) / (2. * h), 1e-4 * typical);
      ++n_checked;
    }
  EXPECT_GT(n_checked, 20);
  for (const auto &[p, f] : on_points)
  {
    double &x         = scene.plate->state().arrays.position[2][p];
    const double here = x;
    x                 = here + h;
    const double up   = energy();
    x                 = here - h;
    const double down = energy();
    x                 = here;
    EXPECT_NEAR(f.z(), -(up - down) / (2. * h), 1e-4 * typical);
  }
}

TEST(SurfaceContact, FrictionWorksOnTheSlidingSpeedAndNeverGivesEnergy)
{
  // Power of friction on points and nodes together is - mu f |v_t| at every touch: negative, and as
  // large as the same contact has on a rigid core of the same motion, up to the facets.
  Ploughing scene(3);
  const auto law   = make_friction_law(ConstantFriction::Parameters{0.2});
  const auto power = [&](const double shank)
  {
    scene.clear();
    auto contact = make_contact(*law, shank, scene);
    contact.add_forces(scene.body, scene.surface, scene.centre, *scene.plate, 0.);
    double sum = 0.;
    for (std::size_t i = 0; i < scene.body.velocity.size(); ++i)
      sum += contact.friction_on_nodes()[i] * scene.body.velocity[i];
    // What is left of the points' forces when the normal ones of a contact without friction go.
    std::vector<Vector3> total;
    for_each_point(*scene.plate,
                   [&](const std::ptrdiff_t p) { total.push_back(force(*scene.plate, p)); });
    scene.clear();
    const auto none = make_friction_law(ConstantFriction::Parameters{0.});
    auto without    = make_contact(*none, 0., scene);
    without.add_forces(scene.body, scene.surface, scene.centre, *scene.plate, 0.);
    std::size_t point = 0;
    for_each_point(*scene.plate,
                   [&](const std::ptrdiff_t p)
                   {
                     const Vector3 friction = total[point++] - force(*scene.plate, p);
                     sum += friction.dot(at(scene.plate->state().arrays.velocity, p));
                   });
    return sum;
  };
  const double with_shank = power(40.), without_shank = power(0.);
  EXPECT_LT(without_shank, -1e3);
  EXPECT_LT(with_shank, without_shank);

  RigidBody::Motion motion = scene.body.motion;
  const RigidBody rigid(core, 5e-3, motion, false);
  scene.clear();
  RigidContact contact(MPI_COMM_SELF, *law, {5e6, 0., 5.}, false, 30);
  const auto reaction = contact.add_forces(rigid, *scene.plate, 0.);
  double on_rigid =
      reaction.friction.dot(motion.velocity) + reaction.friction_moment.dot(motion.spin);
  std::vector<Vector3> total;
  for_each_point(*scene.plate,
                 [&](const std::ptrdiff_t p) { total.push_back(force(*scene.plate, p)); });
  scene.clear();
  const auto none = make_friction_law(ConstantFriction::Parameters{0.});
  RigidContact without(MPI_COMM_SELF, *none, {5e6, 0., 5.}, false, 30);
  without.add_forces(rigid, *scene.plate, 0.);
  std::size_t point = 0;
  for_each_point(*scene.plate,
                 [&](const std::ptrdiff_t p)
                 {
                   const Vector3 friction = total[point++] - force(*scene.plate, p);
                   on_rigid += friction.dot(at(scene.plate->state().arrays.velocity, p));
                 });
  EXPECT_NEAR(without_shank, on_rigid, 0.05 * std::abs(on_rigid));
}

TEST(SurfaceContact, FrictionGivesNoEnergyHoweverLargeItIs)
{
  // Free points and free nodes, light ones too; forces that have nothing to do with friction.
  for (const double node_mass : {1e-7, 1e-4})
    for (const double mu : {0.3, 1., 20., 1e4})
      for (const double dt : {1e-9, 1e-7, 1e-6})
      {
        Ploughing scene;
        Random random(5);
        for_each_point(*scene.plate, [&](const std::ptrdiff_t p)
                       { set(scene.plate->state().arrays.force, p, 3000. * random.vector()); });
        for (double &f : scene.body.force)
          f = 3000. * random.uniform();
        scene.body.mobility.assign(scene.body.mobility.size(), 1. / node_mass);
        const auto law      = make_friction_law(ConstantFriction::Parameters{mu});
        auto contact        = make_contact(*law, 40., scene);
        const double shares = contact.add_normal_forces(scene.body, scene.surface, *scene.plate);
        auto velocity       = scene.body.velocity;
        for (std::size_t i = 0; i < velocity.size(); ++i)
          velocity[i] += dt / (2. * node_mass) * scene.body.force[i];
        const SurfaceNodes present{scene.body.position, velocity, scene.body.force,
                                   scene.body.mobility};
        contact.add_friction(present, shares, scene.surface, scene.centre, *scene.plate, dt);
        scene.plate->advance(dt, dt);
        contact.record_work(dt);
        double work = contact.work_on_points();
        for (std::size_t i = 0; i < velocity.size(); ++i)
          work += dt * contact.friction_on_nodes()[i] *
                  (scene.body.velocity[i] + dt / (2. * node_mass) * scene.body.force[i]);
        EXPECT_LT(work, 0.) << node_mass << " kg, mu = " << mu << ", " << dt << " s";
      }
}

TEST(SurfaceContact, AgreesWithTheRigidShapeWhenTheFacetsAreFine)
{
  double difference[2];
  for (const int refinement : {2, 3})
  {
    Ploughing scene(refinement);
    scene.body.set_motion(scene.body.motion); // without the shaking of its nodes
    scene.surface.update(scene.body.position, 1.5 * dx);
    const auto law = make_friction_law(ConstantFriction::Parameters{0.2});
    auto contact   = make_contact(*law, 0., scene);
    const auto reaction =
        contact.add_forces(scene.body, scene.surface, scene.centre, *scene.plate, 0.);
    auto motion = scene.body.motion;
    motion.position -= motion.orientation * centroid(scene.body.solid); // of the shape
    scene.clear();
    RigidContact smooth(MPI_COMM_SELF, *law, {5e6, 0., 5.}, false, 30);
    const auto expected = smooth.add_forces(RigidBody(core, 5e-3, motion, false), *scene.plate, 0.);
    difference[refinement - 2] = (reaction.force() - expected.force()).norm();
    EXPECT_LT(difference[refinement - 2], 0.1 * expected.force().norm());
    EXPECT_NEAR(reaction.energy, expected.energy, 0.1 * expected.energy);
  }
  EXPECT_LT(difference[1], difference[0]);
}
} // namespace
} // namespace ricochet::tests
