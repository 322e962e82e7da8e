// SPDX-License-Identifier: LGPL-2.1-or-later
#include "finite_elements/consistent_mass.h"
#include "support/element_body.h"

#include "ricochet/base/exceptions.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <map>
#include <numeric>

namespace ricochet::tests
{
namespace
{
constexpr double density = 1190.; // [kg/m^3]

/// A mesh with hanging nodes and a mirror plane, and the elements of its left half.
struct Sample
{
  explicit Sample(const MPI_Comm communicator) :
    mesh(communicator, box()),
    lumped(lumped_mass(mesh, density, std::vector<char>(mesh.elements().size(), 1), {}))
  {
    for (std::size_t e = 0; e < mesh.elements().size(); ++e)
      if (mesh.centre(mesh.elements()[e]).x() < 2e-3)
        elements.push_back(static_cast<int>(e));
  }

  static HexMesh::Box box()
  {
    auto box     = refined_box();
    box.mirror_y = true;
    return box;
  }

  std::vector<double> velocity() const
  {
    std::vector<double> v(mesh.reference().size(), 0.);
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        if (lumped.inverse[3 * node + d] > 0.)
          v[3 * node + d] = noise_at(mesh.reference_position(node), 1e-3)[d];
    return v;
  }

  HexMesh mesh;
  LumpedMass lumped;
  std::vector<int> elements;
};

/// (2 M_L - M_C) of the components that move, scaled by M_L^-1/2 from both sides.
Eigen::MatrixXd scaled_matrix(const Sample &sample, const ConsistentMass &mass)
{
  std::vector<int> moving;
  for (int i = 0; i < 3 * sample.mesh.n_owned_nodes(); ++i)
    if (sample.lumped.inverse[i] > 0.)
      moving.push_back(i);
  const auto n = static_cast<Eigen::Index>(moving.size());
  Eigen::MatrixXd A(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
  {
    std::vector<double> unit(sample.mesh.reference().size(), 0.), image = unit;
    unit[moving[j]] = 1.;
    sample.mesh.follow_masters(unit.data());
    mass.add_mass_difference(unit, image);
    sample.mesh.add_to_owners(image.data());
    image[moving[j]] += sample.lumped.mass[moving[j] / 3];
    for (Eigen::Index i = 0; i < n; ++i)
      A(i, j) = image[moving[i]] *
                std::sqrt(sample.lumped.inverse[moving[i]] * sample.lumped.inverse[moving[j]]);
  }
  return A;
}

TEST(ConsistentMass, HasTheSpectrumThatTheIterationIsTold)
{
  const Sample sample(MPI_COMM_SELF);
  for (const int n : {1, 2, 4})
  {
    const ConsistentMass mass(MPI_COMM_SELF, sample.mesh, sample.lumped, density, sample.elements,
                              n);
    const Eigen::MatrixXd A = scaled_matrix(sample, mass);
    EXPECT_LT((A - A.transpose()).cwiseAbs().maxCoeff(), 1e-14);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
    EXPECT_GT(solver.eigenvalues().minCoeff(), ConsistentMass::smallest_eigenvalue - 1e-13);
    EXPECT_LT(solver.eigenvalues().maxCoeff(), ConsistentMass::largest_eigenvalue + 1e-13);
    EXPECT_GT(solver.eigenvalues().maxCoeff(), 1.5) << "no test of the upper bound";
  }
}

TEST(ConsistentMass, MomentumSolvesItsEquation)
{
  const Sample sample(MPI_COMM_SELF);
  ConsistentMass mass(MPI_COMM_SELF, sample.mesh, sample.lumped, density, sample.elements, 2);
  const auto velocity = sample.velocity();
  mass.find_momentum(velocity);
  // p = M_eff v: forces p acting for a second, corrected, give these velocities.
  std::vector<double> force(velocity.size(), 0.);
  for (int i = 0; i < 3 * sample.mesh.n_owned_nodes(); ++i)
    force[i] = sample.lumped.mass[i / 3] * velocity[i];
  for (std::size_t k = 0; k < mass.momentum().size(); ++k)
    force[3 * mass.nodes()[k / 3] + static_cast<int>(k % 3)] = mass.momentum()[k];
  mass.correct(force);
  double largest = 0., worst = 0., lumped_only = 0.;
  for (int i = 0; i < 3 * sample.mesh.n_owned_nodes(); ++i)
  {
    largest = std::max(largest, std::abs(velocity[i]));
    worst   = std::max(worst, std::abs(force[i] * sample.lumped.inverse[i] - velocity[i]));
  }
  for (std::size_t k = 0; k < mass.momentum().size(); ++k)
  {
    const int i = 3 * mass.nodes()[k / 3] + static_cast<int>(k % 3);
    lumped_only = std::max(lumped_only,
                           std::abs(mass.momentum()[k] * sample.lumped.inverse[i] - velocity[i]));
  }
  EXPECT_LT(worst, 1e-13 * largest);
  EXPECT_GT(lumped_only, 0.1 * largest) << "nothing to solve";
}

TEST(ConsistentMass, KeepsTheSumOfAllForces)
{
  const Sample sample(MPI_COMM_SELF);
  ConsistentMass mass(MPI_COMM_SELF, sample.mesh, sample.lumped, density, sample.elements, 2);
  auto force = sample.velocity();
  sample.mesh.add_to_owners(force.data());
  const auto sum = [&]
  {
    Vector3 all = Vector3::Zero();
    for (int node = 0; node < sample.mesh.n_owned_nodes(); ++node)
      all += at(force, node);
    return all;
  };
  const Vector3 before = sum();
  mass.correct(force);
  // Along y the mirror plane takes what it needs.
  EXPECT_NEAR(sum().x(), before.x(), 1e-12);
  EXPECT_NEAR(sum().z(), before.z(), 1e-12);
}

TEST(ConsistentMass, AdvancesItsMomentumByTheForcesBeforeTheyAreCorrected)
{
  const Sample sample(MPI_COMM_SELF);
  ConsistentMass mass(MPI_COMM_SELF, sample.mesh, sample.lumped, density, sample.elements, 2);
  auto force = sample.velocity();
  for (const int node : sample.mesh.hanging_nodes().node)
    set(force, node, Vector3::Zero());
  const auto pure = force;
  mass.correct(force);
  mass.advance(0.5);
  for (std::size_t k = 0; k < mass.momentum().size(); ++k)
    EXPECT_EQ(mass.momentum()[k], 0.5 * pure[3 * mass.nodes()[k / 3] + k % 3]);
}

TEST(ConsistentMass, RefusesWhatTheIterationCannotSolve)
{
  const Sample sample(MPI_COMM_SELF);
  // Three times the mass: eigenvalues up to 4, where Chebyshev's polynomial for 1 to 2 grows.
  ConsistentMass heavy(MPI_COMM_SELF, sample.mesh, sample.lumped, 3. * density, sample.elements, 2);
  try
  {
    heavy.find_momentum(sample.velocity());
    FAIL() << "the residual was not looked at";
  }
  catch (const RunError &error)
  {
    EXPECT_NE(std::string(error.what()).find("Mass correction"), std::string::npos);
  }
  ConsistentMass mass(MPI_COMM_SELF, sample.mesh, sample.lumped, density, sample.elements, 2);
  auto velocity                 = sample.velocity();
  velocity[3 * mass.nodes()[0]] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mass.find_momentum(velocity), RunError);
}
} // namespace
} // namespace ricochet::tests
