// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound from above of the largest frequency, against dense solutions of small bodies and long
// power iterations of others. Prints the table of doc/time_step.md.
#include "ricochet/coupling/dispersion.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/body.h"
#include "support/coupled_plate.h"
#include "support/hexahedra.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cstdio>

namespace ricochet::tests
{
namespace
{
/// By displacing every component by itself.
double dense_solution(Body &body, const double length)
{
  const auto vibration = body.vibration();
  const auto n         = static_cast<Eigen::Index>(vibration->size());
  Eigen::MatrixXd matrix(n, n);
  std::vector<double> u(n, 0.), a(n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    u[i] = length;
    vibration->displace(u);
    vibration->evaluate();
    vibration->acceleration(a);
    matrix.col(i) = Eigen::Map<const Eigen::VectorXd>(a.data(), n) / length;
    u[i]          = 0.;
  }
  vibration->rest();
  return matrix.eigenvalues().real().maxCoeff();
}

/// Prints a row, and expects the bound to be one, less than 2.5 % above the truth.
void compare(const char *name, Body &body, const double truth, const std::string &truth_is_from)
{
  const auto power = [&](const int n)
  { return largest_frequency(MPI_COMM_SELF, body, n).squared_frequency / truth; };
  const auto found   = frequency_bound(MPI_COMM_SELF, body);
  const double bound = found.squared_frequency / truth;
  std::printf("| %s | %zu | %s | %.4f, %.4f | %d | %.4f |\n", name, body.vibration()->size(),
              truth_is_from.c_str(), power(30), power(300), found.n_evaluations, bound);
  EXPECT_GE(bound, 1.) << name;
  EXPECT_LE(bound, 1.025) << name;
  EXPECT_LE(found.n_evaluations, 30) << name;
}

/// The truth from that many power iterations; what they miss, the slack of the bound hides.
void compare(const char *name, Body &body, const int n_iterations = 2000)
{
  compare(name, body, largest_frequency(MPI_COMM_SELF, body, n_iterations).squared_frequency,
          std::to_string(n_iterations) + " power iterations");
}

BodySample lattice(const std::array<int, 3> &n)
{
  BodySample sample;
  sample.family = {solid_with_poisson_ratio(0.35), InfluenceFunction::cone, 3.};
  sample.n      = n;
  return sample;
}

TEST(FrequencyBound, OfLattices)
{
  auto sample  = lattice({5, 4, 3});
  auto lattice = make_body(sample);
  compare("5 x 4 x 3 points", *lattice, dense_solution(*lattice, 1e-6 * sample.spacing),
          "dense solution");
  sample.n = {16, 15, 14};
  lattice  = make_body(sample);
  compare("16 x 15 x 14 points", *lattice);
  sample.n        = {12, 11, 10};
  sample.mirror_y = true;
  lattice         = make_body(sample);
  compare("half of 12 x 22 x 10 points", *lattice);
  sample.mirror_y = false;
  for (const auto &law : bond_law_samples)
  {
    sample.family.law = law;
    lattice           = make_body(sample);
    compare(law.law, *lattice);
  }
}

const FiniteElementMaterial pmma{1190., 3.3e9 / 0.9, 3.3e9 / 2.7}; // E 3.3 GPa, nu 0.35

TEST(FrequencyBound, OfElementsOfOneSize)
{
  const HexMesh::Box box{Vector3::Zero(), 1e-3, {3, 3, 3}, false, {}};
  for (const auto quadrature : {Quadrature::one_point, Quadrature::full})
  {
    FiniteElementBody::Options options;
    options.quadrature = quadrature;
    FiniteElementBody body(MPI_COMM_SELF, box, pmma, options);
    compare("3 x 3 x 3 cubes", body,
            ElementDispersion(1e-3, pmma, quadrature).largest_squared_frequency_of_block(3),
            "dense solution");
  }
}

TEST(FrequencyBound, OfElementsOfThreeSizes)
{
  const HexMesh::Box box{Vector3::Zero(),
                         1e-3,
                         {14, 14, 14},
                         false,
                         {{Vector3::Zero(), Vector3::Constant(3e-3), 2},
                          {Vector3::Constant(9e-3), Vector3::Constant(14e-3), 1}}};
  FiniteElementBody body(MPI_COMM_SELF, box, pmma);
  compare("cubes of three sizes", body);
}

TEST(FrequencyBound, OfProjectiles)
{
  const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});
  const auto coarse = revolved_hexes(core, 1), fine = revolved_hexes(core, 2);
  HexahedralBody body(coarse, steel(), false);
  compare("projectile, 1", body, dense_solution(body, 1e-6 * smallest_edge(coarse)),
          "dense solution");
  HexahedralBody finer(fine, steel(), false);
  compare("projectile, 2", finer);
}

TEST(FrequencyBound, OfPlatesOfPointsAndElements)
{
  struct Case
  {
    int points_per_edge;
    bool corrects_mass;
  };
  for (const auto &[n, corrects_mass] :
       {Case{1, true}, Case{2, false}, Case{2, true}, Case{4, true}})
  {
    CoupledSample sample;
    sample.coupling.points_per_edge = n;
    sample.coupling.correct_mass    = corrects_mass;
    if (n == 4)
    {
      sample.n_cells = {9, 9, 9};
      sample.zone    = {{3, 3, 3}, {6, 6, 6}};
    }
    PlateModel model(sample);
    const std::string name = "coupled plate, elements of " + std::to_string(n) + " spacings" +
                             (corrects_mass ? "" : ", lumped mass");
    compare(name.c_str(), *model.far, 600);
  }
}
} // namespace
} // namespace ricochet::tests
