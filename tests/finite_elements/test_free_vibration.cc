// SPDX-License-Identifier: LGPL-2.1-or-later
// Eigenmodes of free bodies: that they are those of the elements, and those of bars and beams.
#include "ricochet/base/exceptions.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/finite_elements/free_vibration.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/hexahedra.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});

using Field = std::vector<double>;

/// K u, cell by cell.
Field stiffness_times(const HexahedralBody &body, const Field &u)
{
  Field f(u.size(), 0.);
  for (int cell = 0; cell < static_cast<int>(body.solid().cells.size()); ++cell)
  {
    const auto &corners = body.solid().cells[cell];
    Eigen::Matrix<double, 24, 1> local;
    for (int i = 0; i < 24; ++i)
      local[i] = u[3 * corners[i / 3] + i % 3];
    local = body.stiffness(cell) * local;
    for (int i = 0; i < 24; ++i)
      f[3 * corners[i / 3] + i % 3] += local[i];
  }
  return f;
}

double inner(const Field &a, const Field &b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

Field mass_times(const HexahedralBody &body, Field u)
{
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] *= body.node_mass(static_cast<int>(i / 3));
  return u;
}

double in_hertz(const double squared_frequency)
{
  return std::sqrt(squared_frequency) / (2. * M_PI);
}

TEST(FreeVibration, StiffnessIsTheDerivativeOfTheElementsForces)
{
  HexahedralBody body(distorted_block({3, 2, 2}, 1e-3, 0.15), steel(), false);
  Random random(3);
  Field u(body.position().size());
  for (double &x : u)
    x = 1e-5 * 1e-3 * random.uniform();
  const auto forces = [&](const double sign)
  {
    for (std::size_t i = 0; i < u.size(); ++i)
      body.position()[i] = body.solid().nodes[i / 3][static_cast<int>(i % 3)] + sign * u[i];
    body.compute_internal_forces({});
    return body.force();
  };
  const Field plus = forces(1.), minus = forces(-1.), expected = stiffness_times(body, u);
  double difference = 0.;
  for (std::size_t i = 0; i < u.size(); ++i)
    difference += std::pow(0.5 * (plus[i] - minus[i]) + expected[i], 2);
  // The square of the strain, 1e-10, and rounding over the strain, 1e-11.
  EXPECT_LT(std::sqrt(difference / inner(expected, expected)), 1e-8);
}

TEST(FreeVibration, ModesSolveTheEigenproblemWithoutRigidMotion)
{
  for (const bool half : {false, true})
  {
    HexSolid solid = revolved_hexes(core, 1);
    if (half)
      solid = upper_half(solid, 1e-9);
    const HexahedralBody body(solid, steel(), half);
    const auto modes = FreeVibration(body).lowest_modes(20);
    ASSERT_EQ(modes.shape.size(), 20U);
    for (int k = 0; k < 20; ++k)
    {
      const Field &phi = modes.shape[k];
      for (int j = 0; j <= k; ++j)
        EXPECT_NEAR(inner(modes.shape[j], mass_times(body, phi)), j == k ? 1. : 0., 1e-12);
      Field rest = stiffness_times(body, phi);
      double sum = 0.;
      for (std::size_t i = 0; i < rest.size(); ++i)
      {
        const double share = body.inverse_mass(static_cast<int>(i));
        const double force =
            rest[i] - modes.squared_frequency[k] * phi[i] * body.node_mass(static_cast<int>(i / 3));
        sum += share * force * force;
      }
      // The Krylov process is asked for 1e-12 of the inverse's largest eigenvalue.
      EXPECT_LT(std::sqrt(sum), 1e-7 * modes.squared_frequency[k]) << k;
      Vector3 p = Vector3::Zero(), l = Vector3::Zero();
      for (int node = 0; node < body.n_nodes(); ++node)
      {
        const Vector3 momentum = body.node_mass(node) * node_of(phi, node);
        p += momentum;
        l += solid.nodes[node].cross(momentum);
      }
      if (half)
        p.y() = l.x() = l.z() = 0.;
      const double root = std::sqrt(body.mass());
      EXPECT_LT(p.norm(), 1e-12 * root);
      EXPECT_LT(l.norm(), 1e-12 * root * 27.6e-3);
    }
  }
}

TEST(FreeVibration, FrequencyIsTheOneAtWhichTheElementsRing)
{
  HexahedralBody body(revolved_hexes(core, 1), steel(), false);
  const auto modes = FreeVibration(body).lowest_modes(6);
  const double dt  = 0.2 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, body).squared_frequency);
  for (const int k : {0, 5}) // the first bending mode, and one of the higher ones
  {
    body.rest();
    const Field &phi      = modes.shape[k];
    const Field projector = mass_times(body, phi);
    const double size     = 1e-7 / std::abs(*std::max_element(phi.begin(), phi.end(),
                                                              [](const double a, const double b)
                                                              { return std::abs(a) < std::abs(b); }));
    const double rate     = size * std::sqrt(modes.squared_frequency[k]);
    for (std::size_t i = 0; i < phi.size(); ++i)
      body.velocity()[i] = rate * phi[i];
    int crossings = 0;
    double first = 0., last = 0., before = rate;
    for (int step = 0; crossings < 9; ++step)
    {
      ASSERT_LT(step, 20000);
      body.compute_internal_forces({});
      body.advance(step == 0 ? 0.5 * dt : dt, dt);
      const double v = inner(projector, body.velocity());
      if (v * before < 0.)
      {
        last  = (step + 0.5 + before / (before - v) - 1.) * dt;
        first = crossings++ == 0 ? last : first;
      }
      before = v;
    }
    const double measured = 4. / (last - first), mode = in_hertz(modes.squared_frequency[k]);
    EXPECT_LE(std::abs(measured / mode - 1.), 2e-3)
        << "frequency of a mode against ringing elements";
  }
}

TEST(FreeVibration, BarAndBeamRingAsInClosedForm)
{
  const double length = 60e-3, width = 2e-3, E = 202e9, nu = 0.3, density = 7850.;
  // Bending with shear and rotatory inertia, Spinner, Reichard and Tefft (1960), as in ASTM E1876.
  const double t = std::pow(width / length, 2);
  const double T = 1. + 6.585 * (1. + 0.0752 * nu + 0.8109 * nu * nu) * t - 0.868 * t * t -
                   8.340 * (1. + 0.2023 * nu + 2.173 * nu * nu) * t * t /
                       (1. + 6.338 * (1. + 0.1408 * nu + 1.536 * nu * nu) * t);
  const double mass    = density * length * width * width;
  const double bending = std::sqrt(E * width / (0.9465 * mass * T)) * std::pow(width / length, 1.5);
  const double axial   = std::sqrt(E / density) / (2. * length);
  double error[2];
  for (const int finer : {0, 1})
  {
    const int across = 2 << finer;
    const HexahedralBody body(block({30 * across, across, across}, width / across), steel(), false);
    const auto modes = FreeVibration(body).lowest_modes(14);
    const auto found = [&](const int k) { return in_hertz(modes.squared_frequency[k]); };
    EXPECT_NEAR(found(0), found(1), 1e-8 * found(0)); // either way across
    error[finer]   = found(0) / bending - 1.;
    double nearest = 1.;
    for (int k = 0; k < 14; ++k)
      nearest = std::min(nearest, std::abs(found(k) / axial - 1.));
    EXPECT_LT(nearest, 1e-3); // width and dispersion of 60 elements: (pi/60)^2/24
  }
  // Too stiff by 1/n^2 with n elements across, 0.7 and 0.2 %: what is left at the limit is small.
  EXPECT_LT(error[1], 3e-3);
  EXPECT_NEAR((4. * error[1] - error[0]) / 3., 0., 1e-3);
}

TEST(FreeVibration, HalfHasTheSymmetricModesOfTheWhole)
{
  const HexSolid solid = revolved_hexes(core, 1);
  const HexahedralBody whole(solid, steel(), false), half(upper_half(solid, 1e-9), steel(), true);
  const auto all  = FreeVibration(whole).lowest_modes(20),
             some = FreeVibration(half).lowest_modes(8);
  for (const double squared : some.squared_frequency)
  {
    double nearest = 1.;
    for (const double other : all.squared_frequency)
      nearest = std::min(nearest, std::abs(squared / other - 1.));
    EXPECT_LT(nearest, 1e-8) << in_hertz(squared);
  }
  EXPECT_NEAR(some.squared_frequency[0], all.squared_frequency[0], 1e-8 * all.squared_frequency[0]);
}

TEST(FreeVibration, StaticDisplacementBalancesTheLoadAndItsInertia)
{
  const HexahedralBody body(revolved_hexes(core, 1), steel(), false);
  const FreeVibration vibration(body);
  Field load(3 * body.n_nodes(), 0.);
  for (int node = 0; node < body.n_nodes(); ++node)
    if (body.solid().nodes[node].x() > 0.)
      load[3 * node + 2] = 1.;
  const Field u    = vibration.static_displacement(load);
  // What all modes together say: the more of them, the nearer from below.
  const auto modes = vibration.lowest_modes(60);
  double sum       = 0.;
  for (std::size_t k = 0; k < modes.shape.size(); ++k)
    sum += std::pow(inner(modes.shape[k], load), 2) / modes.squared_frequency[k];
  EXPECT_LT(sum, inner(u, load));
  EXPECT_GT(sum, 0.99 * inner(u, load));
  // K u differs from the load by a rigid motion's inertia, which no mode sees.
  const Field f = stiffness_times(body, u);
  for (const auto &phi : modes.shape)
    EXPECT_NEAR(inner(phi, f), inner(phi, load), 1e-8 * std::abs(inner(modes.shape[0], load)));
}

TEST(FreeVibration, RefusesWhatDoesNotVibrateAsOneBody)
{
  HexSolid two          = block({2, 2, 2}, 1e-3);
  const HexSolid second = block({2, 2, 2}, 1e-3, 0., Vector3(1e-2, 0., 0.));
  const int n           = static_cast<int>(two.nodes.size());
  two.nodes.insert(two.nodes.end(), second.nodes.begin(), second.nodes.end());
  for (auto cell : second.cells)
  {
    for (int &node : cell)
      node += n;
    two.cells.push_back(cell);
  }
  const auto message = [](const HexSolid &solid, const FiniteElementMaterial &material, const int k)
  {
    const HexahedralBody body(solid, material, false);
    try
    {
      FreeVibration(body).lowest_modes(k);
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message(two, steel(), 8).find("parts that nothing holds together"), std::string::npos);
  const HexSolid one = block({2, 2, 2}, 1e-3);
  EXPECT_NE(message(one, elastic(0., 0.3, 7850.), 8).find("no stiffness"), std::string::npos);
  EXPECT_NE(message(one, steel(), 26).find("at most 25 modes"), std::string::npos); // (81 - 6)/3
  EXPECT_EQ(message(one, steel(), 25), "");
}
} // namespace
} // namespace ricochet::tests
