// SPDX-License-Identifier: LGPL-2.1-or-later
#include "peridynamics/fracture_energy.h"
#include "ricochet/base/exceptions.h"
#include "support/body.h"
#include "support/relaxing_families.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
// PMMA (Wang, Foundations of Stress Waves, ZWT constants split at a bulk modulus of 5.9 GPa).
constexpr double K = 5.9e9, mu = 2.258e9;
const RelaxationSeries pmma{{0.146, 15.3}, {0.541, 95.4e-6}};

std::unique_ptr<PeridynamicBody> relaxing_body(const BodySample &sample,
                                               const RelaxationSeries &series,
                                               const HistoryPrecision precision, const double dt)
{
  const PeridynamicMaterial material{&bond_law("linear peridynamic solid"),
                                     1190.,
                                     K,
                                     mu,
                                     sample.critical_stretch,
                                     series,
                                     precision};
  auto body = std::make_unique<PeridynamicBody>(
      MPI_COMM_SELF, 0, Lattice::Box{sample.corner, sample.spacing, sample.n, sample.mirror_y},
      make_stencil(sample.spacing, sample.family.horizon_ratio, sample.family.influence_function),
      material, sample.mask, sample.instruction_set);
  body->start_relaxation(dt);
  return body;
}

/// One step to the given positions, with the velocities that lead there.
template <class Map>
void step_to(PeridynamicBody &body, const double dt, Map &&map, const bool breaking = false)
{
  auto &a = body.state().arrays;
  body.end_step();
  for_each_point(body,
                 [&](const std::ptrdiff_t p)
                 {
                   const Vector3 x = map(reference(body, p));
                   set(a.velocity, p, (x - position(body, p)) / dt);
                   set(a.position, p, x);
                 });
  body.update_ghosts();
  if (breaking)
    body.break_bonds();
  body.compute_internal_forces({/*energy=*/true});
}

struct KernelCase
{
  const char *instruction_set;
  int n_branches;
  HistoryPrecision precision;
  bool mirror_y, breaking;
};

std::ostream &operator<<(std::ostream &out, const KernelCase &test)
{
  return out << test.n_branches << " branches on " << test.instruction_set;
}

std::vector<KernelCase> kernel_cases()
{
  std::vector<KernelCase> cases;
  for (const char *set : {"baseline", "avx2", "avx512"})
    for (const int n : {1, 2, 3})
      for (const auto precision :
           {HistoryPrecision::single_precision, HistoryPrecision::double_precision})
        for (const bool breaking : {false, true})
          cases.push_back({set, n, precision, /*mirror_y=*/n != 1, breaking});
  return cases;
}

class BondHistoryKernel : public testing::TestWithParam<KernelCase>
{
};

INSTANTIATE_TEST_SUITE_P(Cases, BondHistoryKernel, testing::ValuesIn(kernel_cases()),
                         [](const auto &info)
                         {
                           return camel_case(info.param.instruction_set) +
                                  std::to_string(info.param.n_branches) +
                                  (info.param.precision == HistoryPrecision::single_precision
                                       ? "Single"
                                       : "Double") +
                                  (info.param.breaking ? "Breaking" : "");
                         });

TEST_P(BondHistoryKernel, AgreesWithTheDirectedModelOfThePapers)
{
  const auto &test = GetParam();
  if (lattice_kernel(0, test.instruction_set) == nullptr)
    GTEST_SKIP() << "this processor does not have " << test.instruction_set;
  constexpr double critical_stretch = 0.05, dt = 0.3e-6;
  // Times of one to thirty steps, so that ten steps see all of a branch.
  const RelaxationSeries all{{0.2, 9e-6}, {0.3, 0.9e-6}, {0.1, 0.4e-6}};
  const RelaxationSeries series(all.begin(), all.begin() + test.n_branches);
  BodySample sample;
  sample.n                = {6, 5, 5};
  sample.mirror_y         = test.mirror_y;
  sample.critical_stretch = critical_stretch;
  sample.instruction_set  = test.instruction_set;
  const auto body         = relaxing_body(sample, series, test.precision, dt);

  std::vector<Vector3> X;
  std::vector<std::ptrdiff_t> flat;
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   X.push_back(reference(*body, p));
                   flat.push_back(p);
                 });
  const int n = static_cast<int>(X.size());
  if (sample.mirror_y)
    for (int i = 0; i < n; ++i)
      X.push_back({X[i].x(), -X[i].y(), X[i].z()});
  ReferenceFamilies families(X, sample.spacing, 3., InfluenceFunction::cone, *body->material().law,
                             K, mu);
  RelaxingFamilies oracle(families, series, dt, K, mu);

  Random random(17);
  for (int step = 0; step < 10; ++step)
  {
    int i = 0;
    step_to(
        *body, dt,
        [&](const Vector3 &at_rest) -> Vector3
        {
          const Vector3 x      = at_rest + 0.005 * (step + 1) * sample.spacing * random.vector();
          families.position[i] = x;
          if (sample.mirror_y)
            families.position[n + i] = {x.x(), -x.y(), x.z()};
          ++i;
          return x;
        },
        test.breaking);
    if (test.breaking)
      families.break_bonds(critical_stretch);
    oracle.step();
    double scale = 0.;
    for (int j = 0; j < n; ++j)
      scale = std::max(scale, oracle.force[j].norm());
    // Ten roundings of a history, to 6e-8 in single precision; the printed beta loses three digits.
    const double tolerance = test.precision == HistoryPrecision::single_precision ? 3e-7 : 1e-12;
    for (int j = 0; j < n; ++j)
      EXPECT_LT((force(*body, flat[j]) - oracle.force[j]).norm(), tolerance * scale)
          << "step " << step;
    if (!test.breaking)
    {
      EXPECT_LT(oracle.largest_difference, 1e-12 * oracle.largest_back);
    }
  }
  EXPECT_GT(oracle.largest_back, 0.005 * sample.spacing);
  if (test.breaking)
  {
    EXPECT_GT(oracle.largest_difference,
              0.); // where a break moves theta, the papers' model differs
  }
}

/// A row of points along x that moves along x: every extension is linear in the displacements, so
/// that the sums below hold to rounding.
class Row
{
public:
  Row(const double critical_stretch, const HistoryPrecision precision, const double dt) : dt_(dt)
  {
    BodySample sample;
    sample.n                = {24, 1, 1};
    sample.critical_stretch = critical_stretch;
    body                    = relaxing_body(sample, {{0.3, 8e-6}, {0.4, 1.5e-6}}, precision, dt);
  }

  template <class Displacement>
  void step(Displacement &&displacement)
  {
    std::vector<double> before;
    std::vector<Vector3> x;
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     before.push_back(force(*body, p).x());
                     x.push_back(position(*body, p));
                   });
    step_to(
        *body, dt_,
        [&](const Vector3 &X) -> Vector3 { return X + Vector3(displacement(X.x()), 0., 0.); },
        /*breaking=*/true);
    body->book_fracture(dt_);
    std::size_t i = 0;
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     work -=
                         0.5 * (before[i] + force(*body, p).x()) * (position(*body, p) - x[i]).x();
                     ++i;
                   });
  }

  double held() const
  {
    return strain_energy(*body) + body->history()->dissipated(MPI_COMM_SELF) + released();
  }

  double released() const { return body->energies(dt_).fracture; } // by broken bonds [J]

  std::unique_ptr<PeridynamicBody> body;
  double work = 0.; // done on the row by whoever moves it, as the leapfrog scheme sees it [J]

private:
  double dt_;
};

TEST(BondViscosity, StoredDissipatedAndReleasedEnergyAddUpToTheWork)
{
  for (const auto precision :
       {HistoryPrecision::double_precision, HistoryPrecision::single_precision})
  {
    Row row(0.02, precision, 0.4e-6);
    Random random(5);
    row.step([](double) { return 0.; });
    for (int step = 1; step < 60; ++step)
    {
      row.step([&](const double X)
               { return 4e-4 * step * X * std::sin(0.3 * step) + 4e-6 * random.uniform(); });
      EXPECT_NEAR(row.held(), row.work,
                  (precision == HistoryPrecision::double_precision ? 1e-12 : 1e-6) * row.work)
          << "step " << step;
    }
    const double dissipated = row.body->history()->dissipated(MPI_COMM_SELF);
    EXPECT_GT(dissipated, 0.1 * row.work);
    EXPECT_GT(row.released(), 0.1 * row.work);
    EXPECT_GT(row.body->n_broken_bonds(), 10.);
  }
}

TEST(BondViscosity, BlockHoldsItsWorkToTheOrderOfTheStep)
{
  // In three dimensions bonds turn; what is missing falls with the third power of the increments
  // and their number grows: second order in the step.
  double missing[2];
  for (const int halving : {0, 1})
  {
    const double dt = 0.2e-6 / (1 << halving);
    BodySample sample;
    sample.n        = {6, 6, 6};
    const auto body = relaxing_body(sample, {{0.5, 4e-6}}, HistoryPrecision::double_precision, dt);
    double work     = 0.;
    const int steps = 60 << halving;
    for (int i = 0; i <= steps; ++i)
    {
      const double phase = M_PI * i / steps;
      std::vector<Vector3> f, x;
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       f.push_back(force(*body, p));
                       x.push_back(position(*body, p));
                     });
      step_to(*body, dt,
              [&](const Vector3 &X) -> Vector3 {
                return X +
                       0.02 * Vector3(std::sin(phase) * X.y(), 0., std::sin(2. * phase) * X.z());
              });
      std::size_t j = 0;
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       if (i > 0)
                         work -= 0.5 * (f[j] + force(*body, p)).dot(position(*body, p) - x[j]);
                       ++j;
                     });
    }
    const double dissipated = body->history()->dissipated(MPI_COMM_SELF);
    EXPECT_GT(dissipated, 0.5 * work);
    missing[halving] = (strain_energy(*body) + dissipated) / work - 1.;
  }
  EXPECT_LT(std::abs(missing[0]), 1e-4);
  EXPECT_NEAR(missing[0] / missing[1], 4., 0.4);
}

TEST(BondViscosity, MeasuringNowAndThenInterpolates)
{
  // A smooth motion: 40 steps per period.
  BodySample sample;
  sample.n        = {6, 6, 6};
  const double dt = 0.2e-6;
  double total[2];
  for (const bool every : {true, false})
  {
    const auto body = relaxing_body(sample, {{0.5, 4e-6}}, HistoryPrecision::double_precision, dt);
    for (int i = 0; i <= 80; ++i)
    {
      auto &a = body->state().arrays;
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       const Vector3 X = reference(*body, p);
                       const Vector3 x =
                           X + 0.01 * std::sin(2. * M_PI * i / 40.) * Vector3(X.y(), 0., 0.);
                       set(a.velocity, p, (x - position(*body, p)) / dt);
                       set(a.position, p, x);
                     });
      body->update_ghosts();
      body->end_step();
      body->compute_internal_forces({/*energy=*/every || i == 80});
    }
    total[every] = body->history()->dissipated(MPI_COMM_SELF);
  }
  EXPECT_NEAR(total[0] / total[1], 1., 0.02);
}

/// Force per extension of a bond between two lone points from K and from mu.
std::array<double, 2> stiffness_of_two_points(const Stencil &stencil)
{
  const auto &law     = bond_law("linear peridynamic solid");
  const auto &o       = stencil.offsets[0];
  const auto per_unit = [&](const double bulk_modulus, const double shear_modulus)
  {
    const auto c =
        law.bond(family_constants(stencil, bulk_modulus, shear_modulus), o.length, o.omega);
    return law.tension(c, 1., 2. * c.dilatation);
  };
  return {per_unit(K, 0.), per_unit(0., mu)};
}

/// e - e_b of a branch under e = rate t: rate theta (1 - exp(-t/theta)).
double held_at_constant_rate(const MaxwellBranch &branch, const double rate, const double t)
{
  return -rate * branch.time * std::expm1(-t / branch.time);
}

TEST(BondViscosity, BondAtAnyRateFollowsThePronySeries)
{
  // To 2 % strain at 1e-3 to 1e4 per second; a step is at most the short relaxation time.
  for (const auto precision :
       {HistoryPrecision::double_precision, HistoryPrecision::single_precision})
    for (double rate = 1e-3; rate < 2e4; rate *= 10.)
    {
      const double duration = 0.02 / rate;
      const int n           = std::max(200, static_cast<int>(std::ceil(duration / 95e-6)));
      const double dt       = duration / n;
      BodySample sample;
      sample.family        = {bond_law_samples[0], InfluenceFunction::constant, 1.};
      sample.n             = {2, 1, 1};
      const auto body      = relaxing_body(sample, pmma, precision, dt);
      const auto stiffness = stiffness_of_two_points(body->lattice().stencil());
      const double L       = sample.spacing;
      const auto p         = body->lattice().index(1, 0, 0);
      const double start   = reference(*body, p).x();
      double worst         = 0.;
      for (int i = 0; i <= n; ++i)
      {
        const double t                      = i * dt;
        body->state().arrays.position[0][p] = start + rate * t * L;
        body->update_ghosts();
        body->end_step();
        body->compute_internal_forces({false});
        if (i % (n / 20) == 0 && i > 0)
        {
          double strain = rate * t; // of the shear springs together
          for (const auto &branch : pmma)
            strain += branch.share * (held_at_constant_rate(branch, rate, t) - rate * t);
          const double expected = L * (stiffness[0] * rate * t + stiffness[1] * strain);
          worst                 = std::max(worst, std::abs(-force(*body, p).x() / expected - 1.));
        }
      }
      // 1e-19 m of rounding in positions against 1e-6 m of extension; single precision stalls
      // where one step's change is below half a digit of the history, see doc/theory.md.
      EXPECT_LT(worst, precision == HistoryPrecision::double_precision ? 1e-10 : 2e-5)
          << "rate " << rate;
    }
}

TEST(BondViscosity, StretchedBondRelaxesLikeThePronySeries)
{
  const double dt = 0.3e-6, L = 1e-3, stretch = 0.01;
  BodySample sample;
  sample.family        = {bond_law_samples[0], InfluenceFunction::constant, 1.};
  sample.n             = {2, 1, 1};
  const auto body      = relaxing_body(sample, pmma, HistoryPrecision::double_precision, dt);
  const auto stiffness = stiffness_of_two_points(body->lattice().stencil());
  const auto p         = body->lattice().index(1, 0, 0);
  const double start   = reference(*body, p).x();
  // Pulled within the first step at a constant rate, then held.
  for (int i = 0; i <= 2000; ++i)
  {
    body->state().arrays.position[0][p] = start + (i > 0 ? stretch * L : 0.);
    body->update_ghosts();
    body->end_step();
    body->compute_internal_forces({false});
    if (i == 0)
      continue;
    double strain = stretch;
    for (const auto &branch : pmma)
    {
      const double pulled = held_at_constant_rate(branch, stretch / dt, dt);
      strain += branch.share * (pulled * std::exp(-(i - 1) * dt / branch.time) - stretch);
    }
    const double expected = L * (stiffness[0] * stretch + stiffness[1] * strain);
    EXPECT_NEAR(-force(*body, p).x() / expected, 1., 1e-10) << "step " << i;
  }
}

TEST(BondViscosity, ClosedLoopDissipatesTheAnalyticWork)
{
  // A bond that swings for many relaxation times: per period pi k e0^2 x/(1 + x^2), x = omega
  // theta, for each branch.
  const double L = 1e-3, amplitude = 0.01 * L;
  const RelaxationSeries series{{0.4, 20e-6}, {0.3, 2e-6}};
  const double period = 10e-6;
  const int n         = 400; // steps per period
  const double dt     = period / n;
  BodySample sample;
  sample.family        = {bond_law_samples[0], InfluenceFunction::constant, 1.};
  sample.n             = {2, 1, 1};
  const auto body      = relaxing_body(sample, series, HistoryPrecision::double_precision, dt);
  const auto stiffness = stiffness_of_two_points(body->lattice().stencil());
  const auto p         = body->lattice().index(1, 0, 0);
  double before = 0., after = 0.;
  for (int i = 0; i <= 40 * n; ++i)
  {
    step_to(*body, dt,
            [&](const Vector3 &X) -> Vector3
            {
              const bool second = X.x() > L;
              return X + Vector3(second ? amplitude * std::sin(2. * M_PI * i / n) : 0., 0., 0.);
            });
    if (i == 39 * n)
      before = body->history()->dissipated(MPI_COMM_SELF);
  }
  after           = body->history()->dissipated(MPI_COMM_SELF);
  double expected = 0.;
  for (const auto &branch : series)
  {
    const double x = 2. * M_PI / period * branch.time;
    expected += M_PI * branch.share * stiffness[1] * amplitude * amplitude * x / (1. + x * x);
  }
  EXPECT_GT(reference(*body, p).x(), L);
  EXPECT_NEAR((after - before) / expected, 1., 1e-4); // (2 pi/400)^2/12 of a second-order sum
}

TEST(BondViscosity, UniformBackStrainContinuesAsIfItHadBeenThere)
{
  // One body is strained and waits; the other takes over from the strain and its history.
  const double dt = 0.3e-6;
  const RelaxationSeries series{{0.3, 20e-6}, {0.4, 3e-6}};
  Eigen::Matrix3d strain;
  strain << 0.01, 0.004, -0.003, 0.004, -0.002, 0.005, -0.003, 0.005, 0.006;
  strain *= 0.01; // so small that xi . E . xi/|xi| is the extension to 1e-4 of it
  for (const bool mirrored : {false, true})
  {
    if (mirrored)
      for (const int d : {0, 2})
        strain(1, d) = strain(d, 1) = 0.;
    BodySample sample;
    sample.n         = {8, 8, 8};
    sample.mirror_y  = mirrored;
    const auto first = relaxing_body(sample, series, HistoryPrecision::double_precision, dt),
               later = relaxing_body(sample, series, HistoryPrecision::double_precision, dt);
    const auto moved = [&](const int i) {
      return [&, i](const Vector3 &X) -> Vector3 { return X + std::min(1., 0.1 * i) * strain * X; };
    };
    double back[2] = {0., 0.}, kept[2]; // of E: E_b, and G from the step before
    const int n    = 30;
    for (int i = 0; i <= n; ++i)
    {
      step_to(*first, dt, moved(i));
      for (int k = 0; k < 2 && i > 0; ++k)
      {
        const auto step  = maxwell_step(series[k], dt);
        const double now = std::min(1., 0.1 * i), before = std::min(1., 0.1 * (i - 1));
        kept[k] = step.decay * back[k] + (1. - step.decay - step.lag) * before;
        back[k] = kept[k] + step.lag * now;
      }
    }
    for_each_point(*later, [&](const std::ptrdiff_t p)
                   { set(later->state().arrays.position, p, moved(n)(reference(*later, p))); });
    later->update_ghosts();
    later->history()->take_over(later->state().arrays, later->bond_damage().sound_bonds(),
                                [&](std::ptrdiff_t, const int k) -> Eigen::Matrix3d
                                { return kept[k] * strain; });
    later->end_step();
    later->compute_internal_forces({true});
    double scale = 0., worst = 0., total = 0.;
    const auto compare = [&]
    {
      scale = std::max(scale, largest_force(*first));
      for_each_point(*first,
                     [&](const std::ptrdiff_t p)
                     {
                       worst = std::max(worst, (force(*first, p) - force(*later, p)).norm());
                       total = std::max(total, force(*first, p).norm());
                     });
    };
    compare();
    for (int i = 0; i < 10; ++i) // and goes on the same way
    {
      step_to(*first, dt, moved(n));
      step_to(*later, dt, moved(n));
      compare();
    }
    EXPECT_LT(worst, 2e-3 * scale);
    EXPECT_GT(back[1], 0.5);
  }
}

TEST(BondViscosity, WithoutABranchNothingChanges)
{
  BodySample sample;
  sample.n           = {5, 5, 5};
  const auto elastic = make_body(sample);
  elastic->start_relaxation(1e-7);
  EXPECT_EQ(elastic->history(), nullptr);
}

TEST(BondViscosity, LawsWithoutShearModulusAndShortBranchesAreRefused)
{
  const auto start = [](const char *law, const double shear_modulus, const double time,
                        const double dt) -> std::string
  {
    const PeridynamicMaterial material{&bond_law(law), 1190.,       K,
                                       shear_modulus,  unbreakable, {{0.5, time}}};
    PeridynamicBody body(MPI_COMM_SELF, 0, {Vector3::Zero(), 1e-3, {4, 4, 4}, false},
                         make_stencil(1e-3, 3., InfluenceFunction::cone), material);
    try
    {
      body.start_relaxation(dt);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(start("linear peridynamic solid", mu, 1e-6, 1e-7), "");
  EXPECT_NE(start("linear peridynamic solid", mu, 1e-8, 1e-7).find("shorter than the time step"),
            std::string::npos);
  EXPECT_NE(start("microelastic brittle", 0.6 * K, 1e-6, 1e-7).find("no shear modulus of its own"),
            std::string::npos);
}
} // namespace
} // namespace ricochet::tests
