// SPDX-License-Identifier: LGPL-2.1-or-later
// What deal.II's Lanczos bound of the largest eigenvalue would be worth in place of power
// iteration, on the same M^-1 K and from the same start. Prints the table of doc/time_step.md.
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/body.h"
#include "support/coupled_plate.h"
#include "support/hexahedra.h"

#include <deal.II/lac/utilities.h>
#include <deal.II/lac/vector.h>
#include <deal.II/lac/vector_memory.h>
#include <gtest/gtest.h>

#include <cstdio>

namespace ricochet::tests
{
namespace
{
using Vector = dealii::Vector<double>;

/// One displacement that is integrated.
struct Unknown
{
  double *position, reference; // [m]
  const double *force;         // [N]
  double mass;                 // [kg]
};
using Unknowns = std::vector<Unknown>;

/// M^-1/2 K M^-1/2 of a body about its reference configuration, symmetric where the body's mass is
/// lumped. A product is one force evaluation.
class ScaledStiffness
{
public:
  /// `length`: root mean square displacement of a product, small enough to be linear [m].
  ScaledStiffness(Body &body, Unknowns unknowns, const double length) :
    vibration_(body.vibration()), unknowns_(std::move(unknowns))
  {
    double mass = 0.;
    for (const auto &u : unknowns_)
      mass += u.mass;
    size_ = length * std::sqrt(mass);
  }
  ~ScaledStiffness() { vibration_->rest(); }

  /// The start of power iteration.
  Vector start() const
  {
    vibration_->excite();
    return forces(1.);
  }

  void vmult(Vector &result, const Vector &v) const
  {
    const double factor = size_ / v.l2_norm();
    for (unsigned int i = 0; i < v.size(); ++i)
    {
      const auto &u = unknowns_[i];
      *u.position   = u.reference + factor * v[i] / std::sqrt(u.mass);
    }
    vibration_->evaluate();
    ++n_products_;
    result = forces(-1. / factor);
  }

  unsigned int size() const { return static_cast<unsigned int>(unknowns_.size()); }
  int n_products() const { return n_products_; }

private:
  Vector forces(const double factor) const
  {
    Vector f(size());
    for (unsigned int i = 0; i < f.size(); ++i)
      f[i] = factor * *unknowns_[i].force / std::sqrt(unknowns_[i].mass);
    return f;
  }

  std::unique_ptr<Vibration> vibration_;
  Unknowns unknowns_;
  double size_;
  mutable int n_products_ = 0;
};

struct Lanczos
{
  double bound, ritz; // what deal.II returns, and the largest eigenvalue of T_k [1/s^2]
};

Lanczos lanczos(const ScaledStiffness &stiffness, const Vector &start, const unsigned int k)
{
  dealii::GrowingVectorMemory<Vector> memory;
  std::vector<double> eigenvalues;
  const int before   = stiffness.n_products();
  const double bound = dealii::Utilities::LinearAlgebra::lanczos_largest_eigenvalue(
      stiffness, start, k, memory, &eigenvalues);
  EXPECT_EQ(stiffness.n_products() - before, static_cast<int>(k));
  return {bound, eigenvalues.back()};
}

/// |<a, H b> - <H a, b>| in units of the terms.
double asymmetry(const ScaledStiffness &stiffness)
{
  Random random(3);
  Vector a(stiffness.size()), b(a), Ha(a), Hb(a);
  for (unsigned int i = 0; i < a.size(); ++i)
  {
    a[i] = random.uniform();
    b[i] = random.uniform();
  }
  stiffness.vmult(Ha, a);
  stiffness.vmult(Hb, b);
  return std::abs(a * Hb - b * Ha) / (Ha.l2_norm() * b.l2_norm());
}

/// The least of deal.II's results from twenty random starts, k products each [1/s^2].
double least_bound(const ScaledStiffness &stiffness, const unsigned int k)
{
  double least = std::numeric_limits<double>::infinity();
  Random random(5);
  for (int start = 0; start < 20; ++start)
  {
    Vector v(stiffness.size());
    for (auto &component : v)
      component = random.uniform();
    least = std::min(least, lanczos(stiffness, v, k).bound);
  }
  return least;
}

/// What is found with so many evaluations; all eigenvalues in units of the truth, which is that of
/// 400 power iterations [-].
struct Comparison
{
  double asymmetry;
  double power30, power60;
  Lanczos lanczos9, lanczos30; // from the start of power iteration
  double least9;               // of random starts
};

/// Prints a row of the table.
Comparison compare(const char *name, Body &body, const Unknowns &unknowns, const double length)
{
  const auto power = [&](const int n)
  { return largest_frequency(MPI_COMM_SELF, body, n).squared_frequency; };
  const double truth   = power(400);
  const double power30 = power(30) / truth, power60 = power(60) / truth;
  const ScaledStiffness stiffness(body, unknowns, 1e-6 * length);
  const double asymmetric = asymmetry(stiffness);
  const Vector start      = stiffness.start();
  std::printf("| %s | %u | %.4f, %.4f |", name, stiffness.size(), power30, power60);
  Lanczos found[4];
  const unsigned int steps[4] = {5, 9, 15, 30};
  for (int i = 0; i < 4; ++i)
  {
    const auto [bound, ritz] = lanczos(stiffness, start, steps[i]);
    found[i]                 = {bound / truth, ritz / truth};
  }
  for (const auto &result : found)
    std::printf(" %.4f |", result.bound);
  const double least = least_bound(stiffness, 9) / truth;
  std::printf(" %.4f | %.4f, %.4f, %.4f |\n", least, found[1].ritz, found[2].ritz, found[3].ritz);
  return {asymmetric, power30, power60, found[1], found[3], least};
}

/// What doc/time_step.md builds upon, in any body.
void expect_the_verdict(const Comparison &found)
{
  // Power iteration from below; the elements of three sizes are its worst.
  EXPECT_LT(found.power30, 1.);
  EXPECT_GT(found.power30, 0.92);
  EXPECT_GT(found.power60, 0.99);
  // deal.II's result from above, at the price of a tenth of the step, which more products do not
  // give back.
  EXPECT_GT(found.lanczos9.bound, 1.15);
  EXPECT_LT(found.lanczos9.bound, 1.25);
  EXPECT_GT(found.lanczos30.bound, found.lanczos9.bound);
  EXPECT_GT(found.least9, 1.1);
  // The eigenvalue of T_k is as good as a long power iteration.
  EXPECT_NEAR(found.lanczos30.ritz, 1., 1e-3);
}

Unknowns unknowns_of(PeridynamicBody &body)
{
  Unknowns unknowns;
  const auto &lattice = body.lattice();
  auto &a             = body.state().arrays;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 X = lattice.reference_position(lattice.coordinates(p));
        for (int d = 0; d < 3 && lattice.free(p); ++d)
          unknowns.push_back({&a.position[d][p], X[d], &a.force[d][p], body.point_mass()});
      });
  return unknowns;
}

Unknowns unknowns_of(FiniteElementBody &body)
{
  Unknowns unknowns;
  for (int node = 0; node < body.mesh().n_owned_nodes(); ++node)
    for (int d = 0; d < 3; ++d)
      if (body.inverse_mass(node, d) > 0.)
      {
        const int i = 3 * node + d;
        unknowns.push_back({&body.position()[i], body.mesh().reference()[i], &body.force()[i],
                            1. / body.inverse_mass(node, d)});
      }
  return unknowns;
}

Unknowns unknowns_of(HexahedralBody &body)
{
  Unknowns unknowns;
  for (int i = 0; i < 3 * body.n_nodes(); ++i)
    if (body.inverse_mass(i) > 0.)
      unknowns.push_back({&body.position()[i], body.solid().nodes[i / 3][i % 3], &body.force()[i],
                          1. / body.inverse_mass(i)});
  return unknowns;
}

Comparison compare_plate(const char *name, const bool corrects_mass)
{
  CoupledSample sample;
  sample.coupling.correct_mass = corrects_mass;
  PlateModel model(sample);
  auto unknowns       = unknowns_of(*model.points);
  const auto of_nodes = unknowns_of(model.far->elements());
  unknowns.insert(unknowns.end(), of_nodes.begin(), of_nodes.end());
  return compare(name, *model.far, unknowns, model.spacing);
}

TEST(Lanczos, PointsOfOneSpacing)
{
  BodySample sample;
  sample.family    = {solid_with_poisson_ratio(0.35), InfluenceFunction::cone, 3.};
  sample.n         = {16, 15, 14};
  const auto body  = make_body(sample);
  const auto found = compare("points", *body, unknowns_of(*body), sample.spacing);
  EXPECT_LT(found.asymmetry, 1e-6);
  expect_the_verdict(found);
}

TEST(Lanczos, ElementsOfThreeSizes)
{
  const HexMesh::Box box{Vector3::Zero(),
                         1e-3,
                         {14, 14, 14},
                         false,
                         {{Vector3::Zero(), Vector3::Constant(3e-3), 2},
                          {Vector3::Constant(9e-3), Vector3::Constant(14e-3), 1}}};
  FiniteElementBody body(MPI_COMM_SELF, box, {1190., 3.3e9 / 0.9, 3.3e9 / 2.7}); // PMMA
  const auto found = compare("elements of 3 sizes", body, unknowns_of(body), 0.25e-3);
  EXPECT_LT(found.asymmetry, 1e-6);
  expect_the_verdict(found);
}

TEST(Lanczos, ProjectileOfElements)
{
  const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});
  HexahedralBody body(revolved_hexes(core, 2), steel(), false);
  const auto found =
      compare("projectile of elements", body, unknowns_of(body), smallest_edge(body.solid()));
  EXPECT_LT(found.asymmetry, 1e-6);
  expect_the_verdict(found);
}

TEST(Lanczos, PlateOfPointsAndElements)
{
  const auto lumped = compare_plate("plate, lumped mass", false);
  EXPECT_LT(lumped.asymmetry, 1e-6);
  expect_the_verdict(lumped);
  // Mass that is consistent to first order leaves M^-1 K symmetric to that order only.
  const auto corrected = compare_plate("plate, corrected mass", true);
  EXPECT_GT(corrected.asymmetry, 1e-5);
  EXPECT_LT(corrected.asymmetry, 1e-4);
  expect_the_verdict(corrected);
}
} // namespace
} // namespace ricochet::tests
