// SPDX-License-Identifier: LGPL-2.1-or-later
// V3 and V4: a coupled body left to itself keeps its energy and momenta.
#include "support/coupled_plate.h"
#include "support/verification.h"

#include "ricochet/dynamics/largest_frequency.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// A cube of so many cells with two by two by two cells of points in the middle.
CoupledSample small_body(const int n_cells, const bool correct_mass)
{
  CoupledSample sample;
  sample.communicator          = MPI_COMM_SELF;
  const int low                = n_cells / 2 - 1;
  sample.n_cells               = {n_cells, n_cells, n_cells};
  sample.zone                  = {{low, low, low}, {low + 2, low + 2, low + 2}};
  sample.coupling.correct_mass = correct_mass;
  return sample;
}

double stable_step(PlateModel &plate)
{
  return 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, *plate.far).squared_frequency);
}

struct Drift // largest deviation from the start, relative
{
  double energy = 0., linear = 0., angular = 0., energy_at_the_end = 0.;
};

/// Drifting and spinning about an oblique axis; the corners move at 0.02 c_P.
Drift spin(const bool correct_mass, const int n_steps)
{
  PlateModel body(small_body(8, correct_mass));
  const double dt      = 0.9 * stable_step(body);
  const Vector3 centre = Vector3::Constant(8e-3), drift(3., -2., 1.), spin(500., 700., 1500.);
  body.set_velocity([&](const Vector3 &X) -> Vector3 { return drift + spin.cross(X - centre); });
  Drift result;
  double energy  = 0.;
  Vector3 linear = Vector3::Zero(), angular = linear;
  for (int step = 0; step <= n_steps; ++step)
  {
    const bool look = step % 50 == 0;
    body.evaluate(look);
    if (look)
    {
      const double now   = body.far->energies(dt).held();
      const auto momenta = body.far->momenta();
      if (step == 0)
      {
        energy  = now;
        linear  = momenta.linear;
        angular = momenta.angular;
      }
      result.energy_at_the_end = now / energy - 1.;
      result.energy            = std::max(result.energy, std::abs(now / energy - 1.));
      result.linear = std::max(result.linear, (momenta.linear - linear).norm() / linear.norm());
      result.angular =
          std::max(result.angular, (momenta.angular - angular).norm() / angular.norm());
    }
    body.advance(dt, dt);
  }
  return result;
}

TEST(V3SpinningBody, KeepsEnergyAndMomenta)
{
  for (const bool correct_mass : {true, false})
  {
    const auto drift = spin(correct_mass, 2000);
    verify_at_most("V3", "energy of a spinning coupled body, 2000 steps", drift.energy, 1e-5);
    verify_at_most("V3", "linear momentum of a spinning coupled body, 2000 steps", drift.linear,
                   1e-12);
    verify_at_most("V3", "angular momentum of a spinning coupled body, 2000 steps", drift.angular,
                   1e-10);
  }
}

TEST(LongV3SpinningBody, KeepsEnergyAndMomentaFor100000Steps)
{
  const auto drift = spin(true, 100000);
  std::printf("energy %g (at the end %g), linear momentum %g, angular momentum %g\n", drift.energy,
              drift.energy_at_the_end, drift.linear, drift.angular);
  verify_at_most("V3", "energy of a spinning coupled body, 100 000 steps", drift.energy, 1e-5);
  verify_at_most("V3", "linear momentum of a spinning coupled body, 100 000 steps", drift.linear,
                 1e-12);
  verify_at_most("V3", "angular momentum of a spinning coupled body, 100 000 steps", drift.angular,
                 1e-10);
}

/// The body's matrices, measured with its force routines: K by small displacements, M_eff^-1 from
/// the correction of unit forces.
struct Matrices
{
  Eigen::MatrixXd K, inverse_mass; // [N/m], [1/kg]
};
Matrices matrices(PlateModel &body, PlateModel &lumped_body)
{
  std::vector<std::pair<std::ptrdiff_t, int>> at; // point or -1, node
  std::vector<Vector3> reference;
  body.for_each_free(
      [&](const std::ptrdiff_t p, const Vector3 &X)
      {
        at.emplace_back(p, -1);
        reference.push_back(X);
      });
  auto &elements = body.far->elements();
  for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    if (elements.mass(node) > 0.)
    {
      at.emplace_back(-1, node);
      reference.push_back(elements.mesh().reference_position(node));
    }
  const auto n = static_cast<Eigen::Index>(3 * at.size());
  Matrices result{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  const double amplitude = 1e-6 * body.spacing;
  auto &a                = lumped_body.points->state().arrays;
  auto &lumped           = lumped_body.far->elements();
  const auto coordinate  = [&](const Eigen::Index j) -> double &
  {
    const auto [p, node] = at[j / 3];
    return node < 0 ? a.position[j % 3][p] : lumped.position()[3 * node + j % 3];
  };
  for (Eigen::Index j = 0; j < n; ++j)
  {
    coordinate(j) += amplitude;
    lumped_body.far->interpolate_to_slaved_points();
    lumped_body.evaluate(false);
    coordinate(j) = reference[j / 3][j % 3];
    for (Eigen::Index i = 0; i < n; ++i)
    {
      const auto [p, node] = at[i / 3];
      result.K(i, j) =
          -(node < 0 ? a.force[i % 3][p] : lumped.force()[3 * node + i % 3]) / amplitude;
    }

    const auto [p, node] = at[j / 3];
    if (node < 0)
    {
      result.inverse_mass(j, j) = 1. / body.points->point_mass();
      continue;
    }
    std::fill(elements.force().begin(), elements.force().end(), 0.);
    elements.force()[3 * node + j % 3] = 1.;
    elements.correct_mass();
    for (Eigen::Index i = 0; i < n; ++i)
      if (const int other = at[i / 3].second; other >= 0)
        result.inverse_mass(i, j) =
            elements.force()[3 * other + i % 3] * elements.inverse_mass(other, i % 3);
  }
  return result;
}

/// Checks the matrices, and shakes the linear body with white noise for so many steps.
void expect_conserving_matrices(const int n_steps)
{
  PlateModel body(small_body(6, true)), lumped(small_body(6, false));
  auto [K, inverse_mass] = matrices(body, lumped);
  const auto n           = K.rows();
  // Forces come from one energy, and the corrected mass is symmetric too.
  EXPECT_LE((K - K.transpose()).cwiseAbs().maxCoeff(), 1e-6 * K.cwiseAbs().maxCoeff());
  EXPECT_LE((inverse_mass - inverse_mass.transpose()).cwiseAbs().maxCoeff(),
            1e-14 * inverse_mass.cwiseAbs().maxCoeff());
  K = (0.5 * (K + K.transpose())).eval();
  // Six motions without energy, no negative one; masses are positive.
  const Eigen::VectorXd stiffness =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
  EXPECT_LE(stiffness.head(6).cwiseAbs().maxCoeff(), 1e-7 * stiffness[n - 1]);
  EXPECT_GT(stiffness[6], 1e-4 * stiffness[n - 1]);
  EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(inverse_mass).info(), Eigen::Success);

  // Leapfrog with these matrices, which are linear as
  // finite displacements are not: v- . M v+ + u . K u keeps its value.
  PlateModel again(small_body(6, true));
  const double dt                                      = 0.9 * stable_step(again);
  const Eigen::SparseMatrix<double, Eigen::RowMajor> k = K.sparseView(1., 1e-8 * K.maxCoeff()),
                                                     w = inverse_mass.sparseView();
  Eigen::VectorXd u  = Eigen::VectorXd::Zero(n), momentum(n), force(n);
  std::uint32_t seed = 1;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    seed        = seed * 1664525u + 1013904223u;
    momentum[i] = 1e-6 * (seed / 2147483648. - 1.);
  }
  double first = 0., worst = 0.;
  for (int step = 0; step <= n_steps; ++step)
  {
    force = -(k * u);
    if (step % 100 == 0)
    {
      const double energy = 0.5 * momentum.dot(w * (momentum + dt * force)) - 0.5 * u.dot(force);
      if (step == 0)
        first = energy;
      worst = std::max(worst, std::abs(energy / first - 1.));
    }
    momentum += dt * force;
    u += dt * (w * momentum);
  }
  EXPECT_GT(first, 0.);
  verify_at_most("V4", "discrete energy of the linear coupled body, 2000 and 20 000 steps", worst,
                 1e-10);
}

TEST(V4WhiteNoise, FrequenciesAreRealAndNothingGrows)
{
  expect_conserving_matrices(2000);
}

TEST(LongV4WhiteNoise, LinearBodyKeepsItsEnergyFor20000Steps)
{
  expect_conserving_matrices(20000);
}

/// Energies of a body shaken by white noise, velocities up to `amplitude` c_P.
std::vector<double> energies_after_noise(const double amplitude, const int n_steps)
{
  PlateModel body(small_body(6, true));
  const double dt    = 0.9 * stable_step(body);
  std::uint32_t seed = 1;
  const auto noise   = [&]
  {
    seed = seed * 1664525u + 1013904223u;
    return amplitude * PlateModel::p_wave_speed * (seed / 2147483648. - 1.);
  };
  body.set_velocity(
      [&](const Vector3 &)
      {
        const double x = noise(), y = noise(), z = noise();
        return Vector3(x, y, z);
      });
  std::vector<double> result;
  for (int step = 0; step <= n_steps; ++step)
  {
    const bool look = step % 100 == 0;
    body.evaluate(look);
    if (look)
      result.push_back(body.far->energies(dt).held());
    body.advance(dt, dt);
  }
  return result;
}

void expect_bounded_energy(const int n_steps)
{
  // Strains are finite, so that the energy that leapfrog keeps is not quadratic: what it deviates
  // is in proportion to the amplitude and nearly odd in it.
  const auto up = energies_after_noise(1e-6, n_steps), down = energies_after_noise(-1e-6, n_steps);
  double worst = 0., worst_mean = 0.;
  for (std::size_t i = 0; i < up.size(); ++i)
  {
    worst      = std::max(worst, std::abs(up[i] / up[0] - 1.));
    worst_mean = std::max(worst_mean, std::abs((up[i] + down[i]) / (up[0] + down[0]) - 1.));
  }
  std::printf("energy %g, mean of both signs %g\n", worst, worst_mean);
  verify_at_most("V4", "energy of the coupled body, whose strains are finite, 2000 steps", worst,
                 2e-6);
  verify_at_most("V4", "energy of the coupled body, mean over noise of both signs, 2000 steps",
                 worst_mean, 1e-8);
}

TEST(V4WhiteNoise, EnergyOfTheBodyItselfIsBounded)
{
  expect_bounded_energy(2000);
}

// 20 000 steps do not keep this bound: 2.9e-6 was seen. Whether that drifts is open, see
// doc/coupling.md, so no test says that it does not.
} // namespace
} // namespace ricochet::tests
