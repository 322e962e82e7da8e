// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/modal_body.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/hexahedra.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>

namespace ricochet::tests
{
namespace
{
const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});

RigidBody::Motion some_motion(const bool planar)
{
  RigidBody::Motion start;
  start.position    = Vector3(0.1, planar ? 0. : -0.2, 0.05);
  start.orientation = planar ? Eigen::AngleAxisd(0.6, Vector3::UnitY())
                             : Eigen::AngleAxisd(0.6, Vector3(1., 1., 0.5).normalized());
  start.velocity    = Vector3(600., planar ? 0. : 50., -300.);
  start.spin        = planar ? Vector3(0., 2000., 0.) : Vector3(3000., -2000., 1000.);
  return start;
}

/// The core with its modes, all nodes followed.
struct ModalCore
{
  HexahedralBody mesh;
  FreeModes modes;
  ModalBody body;

  ModalCore(const bool half, const int n_modes) :
    mesh(half ? upper_half(revolved_hexes(core, 1), 1e-9) : revolved_hexes(core, 1), steel(), half),
    body(core, mesh, all_nodes(), some_motion(half))
  {
    if (n_modes > 0)
      modes = FreeVibration(mesh).lowest_modes(n_modes);
    body.set_modes(modes, n_modes);
  }

  std::vector<int> all_nodes() const
  {
    std::vector<int> nodes(mesh.n_nodes());
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  }
};

TEST(ModalBody, IsPutWhereTheElementsAre)
{
  for (const bool half : {false, true})
  {
    ModalCore modal(half, 4);
    modal.mesh.set_motion(some_motion(half));
    for (int i = 0; i < 3 * modal.mesh.n_nodes(); ++i)
    {
      EXPECT_NEAR(modal.body.position()[i], modal.mesh.position()[i], 1e-15);
      EXPECT_NEAR(modal.body.velocity()[i], modal.mesh.velocity()[i], 1e-10);
    }
    const auto found = modal.body.rigid_motion(0.), start = some_motion(half);
    EXPECT_EQ(found.position, start.position);
    EXPECT_LT(found.orientation.angularDistance(start.orientation), 1e-15);
    const auto p = modal.body.momenta(), q = modal.mesh.momenta();
    EXPECT_LT(std::abs(p.linear.x() - q.linear.x()), 1e-12 * p.linear.norm());
    EXPECT_LT(std::abs(p.angular.y() - q.angular.y()), 1e-12 * p.angular.norm());
    modal.mesh.compute_internal_forces({true});
    modal.body.compute_internal_forces({true});
    EXPECT_NEAR(modal.body.energies(0.).kinetic, modal.mesh.energies(0.).kinetic,
                1e-12 * modal.mesh.energies(0.).kinetic);
  }
}

TEST(ModalBody, AcceleratesAsItsElementsDoInWhatItsModesCanFollow)
{
  // The force of a mode on the elements accelerates them by that mode, and so does the body.
  for (const bool half : {false, true})
  {
    ModalCore modal(half, 4);
    modal.mesh.set_motion(some_motion(half));
    modal.mesh.compute_internal_forces({});
    modal.body.compute_internal_forces({});
    const Eigen::Matrix3d R = some_motion(half).orientation.toRotationMatrix();
    for (int node = 0; node < modal.mesh.n_nodes(); ++node)
    {
      const Vector3 f =
          modal.mesh.node_mass(node) *
          (R * (1e3 * node_of(modal.modes.shape[0], node) + node_of(modal.modes.shape[3], node)) +
           Vector3(1e3, 0., 2e3));
      for (int d = 0; d < 3; ++d)
        modal.body.force()[3 * node + d] = modal.mesh.force()[3 * node + d] = f[d];
    }
    const double kick = 1e-6;
    const auto now = modal.body.velocity_after(kick), expected = modal.mesh.velocity_after(kick);
    double change = 0., difference = 0.;
    for (std::size_t i = 0; i < now.size(); ++i)
    {
      change     = std::max(change, std::abs(expected[i] - modal.mesh.velocity()[i]));
      difference = std::max(difference, std::abs(now[i] - expected[i]));
    }
    EXPECT_GT(change, 1e-3);
    EXPECT_LT(difference, 1e-7 * change); // velocities are 1e3 m/s and rounded
  }
}

TEST(ModalBody, SpinningAndRingingKeepsEnergyAndMomenta)
{
  for (const bool half : {false, true})
  {
    ModalCore modal(half, 10);
    ModalBody &body = modal.body;
    const double dt = 0.5 * 2. / std::sqrt(modal.modes.squared_frequency.back());
    // A blow on all nodes sets it ringing: modes store about a joule.
    body.compute_internal_forces({});
    Random random(7);
    for (int node = 0; node < modal.mesh.n_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        if (modal.mesh.inverse_mass(3 * node + d) > 0.)
          body.force()[3 * node + d] = 2e-2 / dt * random.uniform();
    body.advance(dt, dt);
    const auto first = body.momenta();
    auto last        = first;
    double low = 1e300, high = 0., most = 0.;
    for (int step = 0; step < 10000; ++step)
    {
      body.update_ghosts();
      body.compute_internal_forces({true});
      const auto e = body.energies(dt);
      low          = std::min(low, e.kinetic + e.strain);
      high         = std::max(high, e.kinetic + e.strain);
      most         = std::max(most, e.strain);
      body.advance(dt, dt);
      last = body.momenta();
    }
    EXPECT_GT(most, 1e-5 * high);
    EXPECT_LE((high - low) / high, 1e-8) << "energy of a spinning, ringing modal projectile";
    EXPECT_LE((last.linear - first.linear).norm() / first.linear.norm(), 1e-12)
        << "linear momentum of a spinning, ringing modal projectile";
    const double arm = body.rigid_motion(0.).position.norm(); // it flies 2 m
    EXPECT_LE((last.angular - first.angular).norm() / (arm * first.linear.norm()), 1e-12)
        << "angular momentum of a spinning, ringing modal projectile";
  }
}

TEST(ModalBody, TurnsAboutPrincipalAxesThatAreNotTheMeshs)
{
  HexSolid solid = distorted_block({6, 2, 3}, 1e-3, 0.2);
  for (auto &X : solid.nodes)
    X = Eigen::AngleAxisd(0.3, Vector3(1., 2., -1.).normalized()) * X;
  HexahedralBody mesh(solid, steel(), false);
  std::vector<int> nodes(mesh.n_nodes());
  std::iota(nodes.begin(), nodes.end(), 0);
  ModalBody body(core, mesh, nodes, some_motion(false));
  mesh.set_motion(some_motion(false));
  body.compute_internal_forces({});
  mesh.compute_internal_forces({});
  // Forces that turn each node as a rigid body turns.
  const Vector3 spinning(3e8, -5e8, 2e8); // [rad/s^2]
  for (int node = 0; node < mesh.n_nodes(); ++node)
  {
    const Vector3 arm = node_of(mesh.position(), node) - some_motion(false).position;
    const Vector3 f   = mesh.node_mass(node) * spinning.cross(arm);
    for (int d = 0; d < 3; ++d)
      body.force()[3 * node + d] = mesh.force()[3 * node + d] = f[d];
  }
  const auto found = body.velocity_after(1e-6), expected = mesh.velocity_after(1e-6);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(body.velocity()[i], mesh.velocity()[i], 1e-11);
    EXPECT_NEAR(found[i], expected[i], 1e-11); // of 600 m/s and 2 m/s of change
  }
}

TEST(ModalBody, BarOnARigidWallNeedsSomeAxialModes)
{
  // St Venant: it touches for 2 L/c_0, under rho c_0 v A, and leaves as fast as it came. Springs of
  // 20 E A/L take a tenth of the time to be pressed.
  const double h = 1e-3, length = 40 * h, area = 4 * h * h, E = 202e9, density = 7850., v = 10.;
  const double c_0 = std::sqrt(E / density), dt = 2e-8;
  const HexahedralBody mesh(block({40, 2, 2}, h), steel(), false);
  const auto modes = FreeVibration(mesh).lowest_modes(96);
  std::vector<int> nodes(mesh.n_nodes()), end;
  std::iota(nodes.begin(), nodes.end(), 0);
  for (const int node : nodes)
    if (mesh.solid().nodes[node].x() == 0.)
      end.push_back(node);
  const double k = 20. * E * area / length / static_cast<double>(end.size());
  RigidBody::Motion start;
  start.position    = Vector3(length / 2., h, h);
  start.velocity    = Vector3(-v, 0., 0.);
  start.orientation = Eigen::Quaterniond::Identity();
  start.spin        = Vector3::Zero();
  std::printf("modes  contact/(2L/c)  force/(rho c v A)  rebound\n");
  double rebound = 0., contact = 0., force = 0.;
  for (const int n : {0, 8, 12, 24, 32, 48, 64, 96})
  {
    ModalBody body(core, mesh, nodes, start);
    body.set_modes(modes, n);
    double last     = 0.;
    force           = 0.;
    int n_in_middle = 0;
    for (int step = 0; step < 1600; ++step)
    {
      const double t = step * dt;
      body.update_ghosts();
      body.compute_internal_forces({});
      double push = 0.;
      for (const int node : end)
        if (const double x = body.position()[3 * node]; x < 0.)
          push += body.force()[3 * node] = -k * x;
      if (push > 0.)
        last = t;
      if (t > 0.5 * length / c_0 && t < 1.5 * length / c_0)
      {
        force += push;
        ++n_in_middle;
      }
      body.advance(step == 0 ? dt / 2. : dt, dt);
    }
    contact = last / (2. * length / c_0);
    force /= n_in_middle * density * c_0 * v * area;
    rebound = body.rigid_motion(0.).velocity.x() / v;
    std::printf("%5d %15.3f %18.3f %8.3f\n", n, contact, force, rebound);
    if (n == 0) // a mass on a spring
    {
      EXPECT_NEAR(rebound, 1., 1e-3);
    }
    else if (n == 12) // one axial mode keeps what it got
    {
      EXPECT_LT(rebound, 0.8);
    }
  }
  EXPECT_NEAR(contact, 1., 0.05);
  EXPECT_NEAR(force, 1., 0.02);
  EXPECT_GT(rebound, 0.97);
}

TEST(ModalBody, FliesStraightWithoutDeforming)
{
  ModalCore modal(false, 4);
  const Vector3 start = modal.body.rigid_motion(0.).position;
  const double dt     = 1e-6;
  for (int step = 0; step < 1000; ++step)
  {
    modal.body.update_ghosts();
    modal.body.compute_internal_forces({});
    modal.body.advance(dt, dt);
  }
  EXPECT_EQ(modal.body.amplitudes(), Eigen::VectorXd::Zero(4));
  EXPECT_LT(
      (modal.body.rigid_motion(0.).position - start - 1e-3 * some_motion(false).velocity).norm(),
      1e-13);
  EXPECT_EQ(modal.body.first_not_finite(), "");
}

TEST(ModalBody, WithoutModesItIsRigidAndSpringsMakeItsFrequency)
{
  ModalCore modal(false, 0);
  EXPECT_EQ(modal.body.n_modes(), 0);
  const int n = modal.mesh.n_nodes();
  EXPECT_EQ(modal.body.squared_frequency(std::vector<double>(n, 0.),
                                         std::vector<Vector3>(n, Vector3::UnitX())),
            0.);
  // Equal springs along the axis at all nodes: in that direction it swings as a mass on n springs,
  // if they pull at the centroid; here also turning, which is faster.
  const double found = modal.body.squared_frequency(std::vector<double>(n, 1e6),
                                                    std::vector<Vector3>(n, Vector3::UnitX()));
  EXPECT_GE(found, (1. - 1e-12) * n * 1e6 / modal.mesh.mass());
  EXPECT_LT(found, 2. * n * 1e6 / modal.mesh.mass());
}
} // namespace
} // namespace ricochet::tests
