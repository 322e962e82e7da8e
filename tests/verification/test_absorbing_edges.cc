// SPDX-License-Identifier: LGPL-2.1-or-later
// V25: what comes back from dashpots at the end of a bar of elements.
#include "ricochet/base/exceptions.h"
#include "ricochet/finite_elements/finite_element_body.h"

#include "support/coupled_scene.h"
#include "support/verification.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
constexpr double h = 2e-3, rho = 1000., c_p = 1000., nu = 0.35; // [SI]

FiniteElementMaterial material()
{
  const double M = rho * c_p * c_p, mu = M * (1. - 2. * nu) / (2. * (1. - nu));
  return {rho, M - 4. / 3. * mu, mu};
}

/// A row of elements that moves along one axis only, by plane waves; dashpots at the far end.
class Row
{
public:
  Row(const int n, const int component) :
    n_(n), component_(component),
    speed_(component == 0 ? c_p : std::sqrt(material().shear_modulus / rho)),
    body_(MPI_COMM_SELF, {Vector3::Zero(), h, {n, 1, 1}, false, {}}, material())
  {
    body_.absorb_at({false, true, false, false, false, false});
    for (int node = 0; node < body_.mesh().n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        if (d != component)
          body_.fix(node, d);
  }

  /// Amplitude that comes back of a packet of this wave length, with a step of so many times the
  /// largest stable one of the row, h/c.
  double reflection(const double lambda, const double courant)
  {
    const double dt = courant * h / speed_, k = 2. * M_PI / lambda, width = 5. * lambda;
    const double omega = 2. / dt * std::asin(courant * std::sin(0.5 * k * h));
    const double x0    = n_ * h - 4. * width;
    // Waves of the scheme, each with its own frequency.
    std::vector<double> now(n_ + 1, 0.), before(n_ + 1, 0.);
    constexpr int n_waves = 301;
    for (int i = 0; i < n_waves; ++i)
    {
      const double here   = k + (i - n_waves / 2) * 8. / width / n_waves;
      const double weight = std::exp(-0.5 * std::pow((here - k) * width, 2)) / n_waves;
      const double turn   = 2. * std::asin(courant * std::sin(0.5 * here * h));
      for (int j = 0; j <= n_; ++j)
      {
        now[j] += weight * std::cos(here * (j * h - x0));
        before[j] += weight * std::cos(here * (j * h - x0) + turn);
      }
    }
    const auto &mesh       = body_.mesh();
    // Smaller ones drown in the rounding of positions, larger ones are not linear any more.
    const double amplitude = 1e-7;
    body_.position()       = mesh.reference();
    auto velocity          = body_.velocity();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    {
      const auto j = std::lround(mesh.reference_position(node).x() / h);
      body_.position()[3 * node + component_] += amplitude * now[j];
      velocity[3 * node + component_] = amplitude * (now[j] - before[j]) / dt;
    }
    body_.set_velocity(velocity);
    body_.update_ghosts();
    const double incident = kinetic();
    // Group velocity: d omega/dk.
    const double group    = h * std::cos(0.5 * k * h) * courant / (dt * std::cos(0.5 * omega * dt));
    const int n_steps     = static_cast<int>(8. * width / group / dt);
    double first          = 0.;
    for (int step = 0; step <= n_steps; ++step)
    {
      const bool look = step == 0 || step == n_steps;
      body_.compute_internal_forces({look});
      if (look)
      {
        const auto e       = body_.energies(dt);
        const double total = e.kinetic + e.strain + e.hourglass + e.absorbed;
        if (step == 0)
          first = total;
        balance = std::max(balance, std::abs(total / first - 1.));
      }
      body_.advance(dt, dt);
      body_.update_ghosts();
    }
    return std::sqrt(kinetic() / incident);
  }

  double balance = 0.; // largest change of the sum of all energies [-]

private:
  double kinetic() const
  {
    double sum = 0.;
    for (int i = 0; i < 3 * body_.mesh().n_owned_nodes(); ++i)
      sum += body_.mass(i / 3) * body_.velocity()[i] * body_.velocity()[i];
    return sum;
  }

  int n_, component_;
  double speed_; // [m/s]
  FiniteElementBody body_;
};

TEST(V25Dashpot, ReflectsWhatTheListSays)
{
  constexpr double ratios[] = {4., 6., 8., 16.}, // wave length over h
      at_09[] = {0.044, 0.015, 0.008, 0.002}, at_05[] = {0.14, 0.056, 0.03, 0.007};
  Row row(1000, 0);
  for (int i = 0; i < 4; ++i)
  {
    verify_near("V25", "reflection of P waves at 0.9 of the stable step over the prototype's",
                row.reflection(ratios[i] * h, 0.9) / at_09[i], 1., 0.2);
    verify_near("V25", "reflection of P waves at 0.5 of the stable step over the prototype's",
                row.reflection(ratios[i] * h, 0.5) / at_05[i], 1., 0.2);
  }
  verify_at_most("V25", "change of the sum of all energies, the absorbed one included", row.balance,
                 1e-6);
}

TEST(V25Dashpot, ReflectsShearWavesByTheSameFormula)
{
  // |R| = |sin kh - S|/(sin kh + S), S = sin(omega dt) h/(c dt): lumped masses, centred dashpot.
  Row row(1000, 1);
  const double courant = 0.4; // across the row P waves limit the step
  for (const double ratio : {6., 8.})
  {
    const double kh = 2. * M_PI / ratio;
    const double S  = std::sin(2. * std::asin(courant * std::sin(0.5 * kh))) / courant;
    const double R  = std::abs(std::sin(kh) - S) / (std::sin(kh) + S);
    verify_near("V25", "reflection of S waves over the formula",
                row.reflection(ratio * h, courant) / R, 1., 0.1);
  }
}

TEST(NonReflectingEdges, MomentumThatLeavesIsBooked)
{
  // A block flies and turns; dashpots on two of its faces stop it.
  FiniteElementBody block(MPI_COMM_SELF, {Vector3::Zero(), h, {6, 5, 4}, false, {}}, material());
  block.absorb_at({false, true, true, false, false, false});
  auto velocity = block.velocity();
  for (int node = 0; node < block.mesh().n_owned_nodes(); ++node)
  {
    const Vector3 v =
        Vector3(3., -2., 1.) + Vector3(10., 20., -30.).cross(block.mesh().reference_position(node));
    for (int d = 0; d < 3; ++d)
      velocity[3 * node + d] = v[d];
  }
  block.set_velocity(velocity);
  const auto kinetic = [&]
  {
    double sum = 0.;
    for (int i = 0; i < 3 * block.mesh().n_owned_nodes(); ++i)
      sum += 0.5 * block.mass(i / 3) * block.velocity()[i] * block.velocity()[i];
    return sum;
  };
  const auto before  = block.momenta();
  const double start = kinetic(), dt = 0.5 * h / c_p;
  for (int step = 0; step < 200; ++step)
  {
    block.update_ghosts();
    block.compute_internal_forces({/*energy=*/false});
    block.advance(dt, dt);
  }
  EXPECT_LT(kinetic(), 0.1 * start) << "nothing has left";
  const auto after = block.momenta();
  EXPECT_LT((after.linear - before.linear).norm(), 1e-13 * before.linear.norm());
  EXPECT_LT((after.angular - before.angular).norm(), 1e-12 * before.angular.norm());
}

TEST(NonReflectingEdges, ZoneMustNotReachThem)
{
  Scene scene                     = coupled_scene();
  scene.plates[0].absorbing_edges = true;
  scene.plates[0].zone_boxes      = {{0., 16e-3, -6e-3, 6e-3}};
  try
  {
    Simulation(MPI_COMM_SELF, scene);
    FAIL() << "points at an edge that lets waves out";
  }
  catch (const InputError &error)
  {
    for (const char *part : {"Non-reflecting edges", "Size", "Zone box"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}
} // namespace
} // namespace ricochet::tests
