// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/peridynamics/peridynamic_body.h"
#include "support/element_body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
// PMMA (Wang, Foundations of Stress Waves, ZWT constants split at a bulk modulus of 5.9 GPa).
constexpr double K = 5.9e9, mu = 2.258e9;
const RelaxationSeries pmma_series{{0.146, 15.3}, {0.541, 95.4e-6}};

enum class Form
{
  one_point,
  integrated,
  own_tensors
};

const char *name_of(const Form form)
{
  return form == Form::one_point    ? "OnePoint"
         : form == Form::integrated ? "Integrated"
                                    : "OwnTensors";
}

struct KernelCase
{
  const char *instruction_set;
  Form form;
  int n_branches;
};

std::ostream &operator<<(std::ostream &out, const KernelCase &test)
{
  return out << name_of(test.form) << " on " << test.instruction_set;
}

std::vector<KernelCase> kernel_cases()
{
  std::vector<KernelCase> cases;
  for (const char *set : {"baseline", "avx2", "avx512"})
    for (const Form form : {Form::one_point, Form::integrated, Form::own_tensors})
      for (const int n : {1, 3})
        cases.push_back({set, form, n});
  return cases;
}

class RelaxingHexKernel : public testing::TestWithParam<KernelCase>
{
};

INSTANTIATE_TEST_SUITE_P(Cases, RelaxingHexKernel, testing::ValuesIn(kernel_cases()),
                         [](const auto &info)
                         {
                           return name_of(info.param.form) + std::string("On") +
                                  info.param.instruction_set + "With" +
                                  std::to_string(info.param.n_branches);
                         });

/// A Gauss point by the book: 6-vectors of strain, Mitchell's recurrence with both its memories.
struct ReferencePoint
{
  using Vector6 = Eigen::Matrix<double, 6, 1>; // 11, 22, 33, 2 23, 2 13, 2 12

  Matrix6 C, C_mu;
  Vector6 strain = Vector6::Zero();
  std::vector<Vector6> back;
  double energy = 0., dissipated = 0.; // densities [J/m^3]

  Vector6 step(const Vector6 &e, const RelaxationSeries &series, const double dt)
  {
    back.resize(series.size(), Vector6::Zero());
    energy      = 0.5 * e.dot((C - C_mu) * e);
    double rest = 1.;
    Vector6 s   = (C - C_mu) * e;
    for (std::size_t k = 0; k < series.size(); ++k)
    {
      const double theta = series[k].time, r = std::exp(-dt / theta);
      const double beta    = 1. - theta / dt * (1. - r);
      const Vector6 before = back[k], d = strain - before;
      back[k]            = strain * (1. - r) + before * r + beta * (e - strain);
      const Vector6 held = e - back[k];
      s += series[k].share * C_mu * held;
      energy += 0.5 * series[k].share * held.dot(C_mu * held);
      dissipated += 0.5 * series[k].share * (d + held).dot(C_mu * (back[k] - before));
      rest -= series[k].share;
    }
    strain = e;
    energy += 0.5 * rest * e.dot(C_mu * e);
    return s + rest * C_mu * e;
  }
};

TEST_P(RelaxingHexKernel, AgreesWithTheTextbookOverSeveralSteps)
{
  const auto &test        = GetParam();
  const HexKernel *kernel = hex_kernel(test.instruction_set);
  if (kernel == nullptr)
    GTEST_SKIP() << "this processor does not have " << test.instruction_set;
  const double dt = 0.3e-6, lambda = K - mu / 1.5;
  const double diagonal = 0.8 * mu; // a cubic solid
  const RelaxationSeries all{{0.2, 9e-6}, {0.3, 0.9e-6}, {0.1, 0.4e-6}};
  const RelaxationSeries series(all.begin(), all.begin() + test.n_branches);
  std::vector<MaxwellStep> branches;
  for (const auto &branch : series)
    branches.push_back(maxwell_step(branch, dt));

  // 11 elements: a full block and three lanes of a second. Each has nodes of its own.
  constexpr int n    = 11;
  const int n_points = test.form == Form::one_point ? 1 : 8;
  Random random(21);
  std::vector<HexBlock> blocks(2);
  std::vector<HexTensors> tensors(2), shear(2);
  std::vector<ReferencePoint> points(n * n_points);
  const Matrix6 cubic      = cubic_tensor(lambda, mu, diagonal),
                deviatoric = cubic_tensor(-mu / 1.5, mu, diagonal);
  for (int e = 0; e < 16; ++e)
  {
    const int from            = std::min(e, n - 1);
    blocks[e / 8].edge[e % 8] = (1. + 0.05 * from) * 1e-3;
    for (int corner = 0; corner < 8; ++corner)
      blocks[e / 8].entry[corner][e % 8] = 3 * (8 * from + corner);
  }
  for (int e = 0; e < n; ++e)
    for (int point = 0; point < n_points; ++point)
    {
      auto &there = points[e * n_points + point];
      there.C     = cubic;
      there.C_mu  = deviatoric;
      if (test.form != Form::own_tensors)
        continue;
      there.C_mu = random_tensor(random, 1e9);
      there.C    = there.C_mu + random_tensor(random, 1e9);
      for (int k = 0; k < HexTensors::n_entries; ++k)
      {
        tensors[e / 8].c[point][k][e % 8] = upper_triangle(there.C)[k];
        shear[e / 8].c[point][k][e % 8]   = upper_triangle(there.C_mu)[k];
      }
    }

  std::vector<double> position(3 * 8 * n), force(position.size());
  std::vector<double> strain(n), hourglass(n), dissipated(n, 0.);
  std::vector<double> history(2 * n_points * 6 * (1 + series.size()) * 8, 0.);
  const double bending = mu / 37., warping = mu / 91.; // of no special value
  const HexArrays arrays{position.data(), force.data(), strain.data(), hourglass.data()};
  const HexGroup group{blocks.data(), tensors.data(), n, lambda, mu, diagonal, bending, warping};
  const HexRelaxation relaxation{int(series.size()), branches.data(), history.data(), shear.data(),
                                 dissipated.data()};
  double largest_share = 0.; // of losses
  for (int step = 0; step < 8; ++step)
  {
    for (int e = 0; e < n; ++e)
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d)
          position[3 * (8 * e + a) + d] =
              blocks[e / 8].edge[e % 8] *
              (0.5 * ReferenceElement::corner(a)[d] + 0.05 * (step + 1) * random.uniform());
    std::fill(force.begin(), force.end(), 0.);
    const bool energy = step % 2 == 1;
    const auto loop =
        test.form == Form::one_point
            ? (energy ? kernel->relaxing_one_point_and_energy : kernel->relaxing_one_point)
        : test.form == Form::integrated
            ? (energy ? kernel->relaxing_integrated_and_energy : kernel->relaxing_integrated)
            : (energy ? kernel->relaxing_own_tensors_and_energy : kernel->relaxing_own_tensors);
    loop(arrays, group, relaxation);

    double scale = 0., energy_scale = 0., loss_scale = 0.;
    Eigen::MatrixXd expected(3, 8 * n);
    std::vector<double> stored(n, 0.), lost(n, 0.);
    for (int e = 0; e < n; ++e)
    {
      const double edge = blocks[e / 8].edge[e % 8], volume = std::pow(edge, 3);
      Eigen::Matrix<double, 3, 8> x;
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d)
          x(d, a) = position[3 * (8 * e + a) + d];
      ReferenceElement element;
      if (test.form == Form::one_point)
        element.add_hourglass(x, edge, bending, warping);
      for (int point = 0; point < n_points; ++point)
      {
        const Vector3 place = test.form == Form::one_point
                                  ? Vector3(Vector3::Zero())
                                  : Vector3(ReferenceElement::corner(point) / std::sqrt(3.));
        Eigen::Matrix<double, 8, 3> gradient;
        for (int a = 0; a < 8; ++a)
        {
          const Vector3 factor = Vector3::Ones() + ReferenceElement::corner(a).cwiseProduct(place);
          for (int d = 0; d < 3; ++d)
            gradient(a, d) = ReferenceElement::corner(a)[d] * factor[(d + 1) % 3] *
                             factor[(d + 2) % 3] / (4. * edge);
        }
        const Eigen::Matrix3d F = x * gradient;
        const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
        ReferencePoint::Vector6 e6;
        e6 << E(0, 0), E(1, 1), E(2, 2), 2. * E(1, 2), 2. * E(0, 2), 2. * E(0, 1);
        auto &reference = points[e * n_points + point];
        const auto s    = reference.step(e6, series, dt);
        Eigen::Matrix3d S;
        S << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
        element.force -= volume / n_points * F * S * gradient.transpose();
        stored[e] += volume / n_points * reference.energy;
        lost[e] += volume / n_points * reference.dissipated;
      }
      expected.middleCols(8 * e, 8) = element.force;
      energy_scale                  = std::max(energy_scale, stored[e]);
      loss_scale                    = std::max(loss_scale, lost[e]);
    }
    scale = expected.cwiseAbs().maxCoeff();
    // The printed beta loses three digits, see relaxing_families.h.
    for (int i = 0; i < 8 * n; ++i)
      for (int d = 0; d < 3; ++d)
        EXPECT_NEAR(force[3 * i + d], expected(d, i), 1e-12 * scale) << "step " << step;
    for (int e = 0; e < n; ++e)
    {
      if (energy)
      {
        EXPECT_NEAR(strain[e], stored[e], 1e-12 * energy_scale);
      }
      EXPECT_NEAR(dissipated[e], lost[e], 1e-12 * loss_scale);
    }
    largest_share = std::max(largest_share, loss_scale / energy_scale);
  }
  EXPECT_GT(largest_share, 0.003);
}

ElementStiffness own_stiffness(const int element)
{
  ElementStiffness own{element, {}, {}};
  own.tensors.fill(upper_triangle(isotropic_tensor(K - mu / 1.5, mu)));
  own.shear.fill(upper_triangle(isotropic_tensor(-mu / 1.5, mu)));
  return own;
}

std::unique_ptr<FiniteElementBody> make_body(const Form form, const HexMesh::Box &box,
                                             const RelaxationSeries &series, const double dt)
{
  FiniteElementBody::Options options;
  options.quadrature = form == Form::one_point ? Quadrature::one_point : Quadrature::full;
  auto body          = std::make_unique<FiniteElementBody>(
      MPI_COMM_SELF, box, FiniteElementMaterial{1190., K, mu, series}, options);
  if (form == Form::own_tensors)
  {
    std::vector<ElementStiffness> all;
    for (std::size_t e = 0; e < body->mesh().elements().size(); ++e)
      all.push_back(own_stiffness(static_cast<int>(e)));
    body->set_stiffness(all);
  }
  body->start_relaxation(dt);
  return body;
}

class RelaxingElement : public testing::TestWithParam<Form>
{
};

INSTANTIATE_TEST_SUITE_P(Forms, RelaxingElement,
                         testing::Values(Form::one_point, Form::integrated, Form::own_tensors),
                         [](const auto &info) { return name_of(info.param); });

/// sum lambda_k (E - E_b,k) and the share that does not relax, under E = rate t.
double held_strain(const RelaxationSeries &series, const double rate, const double t)
{
  double strain = rate * t;
  for (const auto &branch : series)
    strain -= branch.share * rate * (t + branch.time * std::expm1(-t / branch.time));
  return strain;
}

TEST_P(RelaxingElement, UniaxialStrainAtAnyRateFollowsThePronySeries)
{
  for (double rate = 1e-3; rate < 2e4; rate *= 10.)
  {
    const double duration = 0.02 / rate;
    const int n           = std::max(200, static_cast<int>(std::ceil(duration / 95e-6)));
    const double dt = duration / n, h = 1e-3;
    const auto body =
        make_body(GetParam(), {Vector3::Zero(), h, {1, 1, 1}, false, {}}, pmma_series, dt);
    for (int i = 1; i <= n; ++i)
    {
      // Green's strain grows at a constant rate.
      const double E = rate * i * dt, F = std::sqrt(1. + 2. * E);
      for (int node = 0; node < 8; ++node)
      {
        const Vector3 X = body->mesh().reference_position(node);
        set(body->position(), node, Vector3(F * X.x(), X.y(), X.z()));
      }
      body->update_ghosts();
      body->compute_internal_forces({false});
      if (i % (n / 20) != 0)
        continue;
      const double held  = held_strain(pmma_series, rate, i * dt);
      const double axial = K * E + 4. / 3. * mu * held, lateral = K * E - 2. / 3. * mu * held;
      Eigen::Matrix3d S = Vector3(axial, lateral, lateral).asDiagonal();
      EXPECT_LT((body->stress(0) - S).norm(), 1e-10 * S.norm()) << rate;
      // The face x = 0 is pulled by F S A, a quarter at each node.
      EXPECT_NEAR(at(body->force(), 0).x() / (0.25 * F * axial * h * h), 1., 1e-10) << rate;
    }
  }
}

TEST_P(RelaxingElement, HeldStrainRelaxesLikeThePronySeries)
{
  const double dt = 0.3e-6, E = 0.01;
  const auto body =
      make_body(GetParam(), {Vector3::Zero(), 1e-3, {1, 1, 1}, false, {}}, pmma_series, dt);
  const auto stretch = [&](const double strain)
  {
    for (int node = 0; node < 8; ++node)
    {
      const Vector3 X = body->mesh().reference_position(node);
      set(body->position(), node, Vector3(std::sqrt(1. + 2. * strain) * X.x(), X.y(), X.z()));
    }
    body->update_ghosts();
    body->compute_internal_forces({false});
  };
  for (int i = 1; i <= 1000; ++i)
  {
    stretch(E);
    double share = 1.;
    for (const auto &branch : pmma_series)
    {
      const double pulled = -branch.time / dt * std::expm1(-dt / branch.time);
      share -= branch.share * (1. - pulled * std::exp(-(i - 1) * dt / branch.time));
    }
    EXPECT_NEAR(body->stress(0)(0, 0) / ((K + 4. / 3. * mu * share) * E), 1., 1e-12);
  }
}

TEST_P(RelaxingElement, ClosedLoopDissipatesTheAnalyticWork)
{
  // Shear swings for many relaxation times: pi (2 mu_k) E0^2 2 x/(1 + x^2) per period and volume,
  // with E12 = E21 = E0 sin(omega t), x = omega theta.
  const RelaxationSeries series{{0.4, 20e-6}, {0.3, 2e-6}};
  const double period = 10e-6, h = 1e-3, E0 = 1e-5; // so small that Green's strain is linear
  const int n = 400;
  const auto body =
      make_body(GetParam(), {Vector3::Zero(), h, {1, 1, 1}, false, {}}, series, period / n);
  double before = 0.;
  for (int i = 1; i <= 40 * n; ++i)
  {
    const double shear = 2. * E0 * std::sin(2. * M_PI * i / n);
    for (int node = 0; node < 8; ++node)
    {
      const Vector3 X = body->mesh().reference_position(node);
      set(body->position(), node, X + Vector3(shear * X.y(), 0., 0.));
    }
    body->update_ghosts();
    body->compute_internal_forces({false});
    if (i == 39 * n)
      before = body->energies(period / n).viscous;
  }
  const double loss = body->energies(period / n).viscous - before;
  double expected   = 0.;
  for (const auto &branch : series)
  {
    const double x = 2. * M_PI / period * branch.time;
    expected += M_PI * 2. * mu * branch.share * 2. * E0 * E0 * x / (1. + x * x) * std::pow(h, 3);
  }
  EXPECT_NEAR(loss / expected, 1., 1e-4);
}

TEST_P(RelaxingElement, SwingingBodyKeepsItsEnergyToTheLastJoule)
{
  // Free, refined, from rest in a strained state: kinetic + strain + hourglass + viscous stays.
  const RelaxationSeries series{{0.3, 10e-6}, {0.4, 1e-6}};
  const double h  = 0.25e-3; // the smallest edge
  const double c  = std::sqrt((K + 4. / 3. * mu) / 1190.);
  const double dt = 0.5 * h / c;
  const auto body = make_body(GetParam(), refined_box(), series, dt);
  const auto bent = [&](const Vector3 &X) -> Vector3
  { return X + 0.003e-3 * Vector3(std::sin(1e3 * X.y()), std::cos(1.5e3 * X.z()), 0.); };
  deform(*body, bent);
  double start = 0., worst = 0.;
  for (int step = 0; step < 400; ++step)
  {
    body->advance(step == 0 ? 0.5 * dt : dt, dt);
    body->update_ghosts();
    body->compute_internal_forces({true});
    const auto e       = body->energies(dt);
    const double total = e.kinetic + e.strain + e.hourglass + e.viscous;
    if (step == 0)
      start = total;
    worst = std::max(worst, std::abs(total / start - 1.));
  }
  const auto e = body->energies(dt);
  EXPECT_LT(worst, 2e-3); // strains of 0.3 %: the scheme is exact for linear systems only
  EXPECT_GT(e.viscous, 0.3 * start);
}

TEST(RelaxingElements, HistoryStaysWhenStiffnessIsGivenAnew)
{
  const RelaxationSeries series{{0.3, 10e-6}, {0.4, 1e-6}};
  const double dt  = 0.03e-6;
  const auto body  = make_body(Form::integrated, refined_box(), series, dt),
             other = make_body(Form::integrated, refined_box(), series, dt);
  const auto bent  = [](const double step)
  {
    return [step](const Vector3 &X) -> Vector3
    { return X + 1e-6 * step * Vector3(std::sin(1e3 * X.y()), std::cos(1.5e3 * X.z()), 0.); };
  };
  for (int step = 1; step <= 20; ++step)
  {
    for (auto *one : {body.get(), other.get()})
      deform(*one, bent(step));
    if (step % 5 == 0)
    {
      std::vector<ElementStiffness> own;
      for (std::size_t e = step; e < other->mesh().elements().size(); e += 3)
        own.push_back(own_stiffness(static_cast<int>(e)));
      other->set_stiffness(own);
    }
    for (int node = 0; node < body->mesh().n_owned_nodes(); ++node)
      EXPECT_LT((at(body->force(), node) - at(other->force(), node)).norm(),
                1e-12 * largest_force(*body));
  }
  EXPECT_NEAR(body->energies(dt).viscous, other->energies(dt).viscous,
              1e-12 * body->energies(dt).viscous);
}

TEST(RelaxingElements, BondsTakeOverWhereElementsStop)
{
  // A uniform strain, its history in an element; peridynamics goes on from there, and the traction
  // in the middle of a block is the element's for all times.
  const RelaxationSeries series{{0.3, 20e-6}, {0.4, 3e-6}};
  const double dt = 0.3e-6;
  Eigen::Matrix3d strain;
  strain << 1e-4, 3e-5, 0., 3e-5, -4e-5, 0., 0., 0., 2e-5;
  const auto element =
      make_body(Form::one_point, {Vector3::Zero(), 1e-3, {1, 1, 1}, false, {}}, series, dt);
  const auto strained = [&](const double share)
  { return [&strain, share](const Vector3 &X) -> Vector3 { return X + share * strain * X; }; };
  for (int i = 1; i <= 20; ++i)
    deform(*element, strained(i / 20.));

  const PeridynamicMaterial material{
      &bond_law("linear peridynamic solid"), 1190., K, mu, 1., series,
      HistoryPrecision::double_precision};
  PeridynamicBody bonds(MPI_COMM_SELF, 0, {Vector3::Zero(), 1e-3, {10, 17, 17}, false},
                        make_stencil(1e-3, 3., InfluenceFunction::cone), material);
  bonds.start_relaxation(dt);
  const auto move = [&](const double share)
  {
    const auto &l = bonds.lattice();
    for (std::ptrdiff_t p = l.owned_begin(); p < l.owned_end(); ++p)
      if (l.owned(p))
      {
        const Vector3 x = strained(share)(l.reference_position(l.coordinates(p)));
        for (int d = 0; d < 3; ++d)
          bonds.state().arrays.position[d][p] = x[d];
      }
    bonds.update_ghosts();
  };
  move(1.);
  bonds.history()->take_over(
      bonds.state().arrays, bonds.bond_damage().sound_bonds(),
      [&](std::ptrdiff_t, const int k) -> Eigen::Matrix3d
      { return element->back_strain(0, k) - maxwell_step(series[k], dt).lag * strain; });
  for (int i = 0; i < 60; ++i)
  {
    // The force on the left half of a column in the middle is the traction on its cut.
    bonds.end_step();
    bonds.compute_internal_forces({false});
    Vector3 traction = Vector3::Zero();
    for (int x = 0; x < 5; ++x)
      for (int d = 0; d < 3; ++d)
        traction[d] += bonds.state().arrays.force[d][bonds.lattice().index(x, 8, 8)] / 1e-6;
    const Vector3 expected = element->stress(0).col(0);
    // Isotropy of the lattice: 0.5 %.
    EXPECT_LT((traction - expected).norm(), 0.005 * expected.norm()) << "step " << i;
    deform(*element, strained(1.));
    move(1.);
  }
}

TEST(RelaxingElements, TensorsMayBeGivenSeveralTimesBetweenTwoSteps)
{
  // An element that passes through the shared moduli, with one Gauss point, on its way from one set
  // of tensors to the next keeps the histories of its eight points apart.
  const double dt = 1e-7;
  const HexMesh::Box box{Vector3::Zero(), 1e-3, {3, 2, 2}, false, {}};
  const auto forces_with = [&](const int n_detours, const bool is_activated_again)
  {
    const auto body = make_body(Form::one_point, box, {{0.3, 3e-6}}, dt);
    std::vector<ElementStiffness> stiffness;
    for (int e = 0; e < 12; ++e)
      stiffness.push_back(own_stiffness(e));
    body->set_stiffness(stiffness);
    for (int step = 1; step < 4; ++step)
      deform(*body,
             [&](const Vector3 &X) -> Vector3 { return X + 0.02e-3 * step * noise_at(X, 1e-3); });
    if (is_activated_again)
      body->set_active([](const Vector3 &) { return true; });
    for (int i = 0; i < n_detours; ++i)
      body->set_stiffness({});
    body->set_stiffness(stiffness);
    deform(*body, [&](const Vector3 &X) -> Vector3 { return X; });
    return body->force();
  };
  const auto straight = forces_with(0, false);
  EXPECT_EQ(forces_with(1, false), straight);
  EXPECT_EQ(forces_with(2, false), straight);
  EXPECT_EQ(forces_with(1, true), straight);
}

TEST(RelaxingElements, ElasticWithoutASeries)
{
  const auto body =
      make_body(Form::one_point, {Vector3::Zero(), 1e-3, {1, 1, 1}, false, {}}, {}, 1e-7);
  EXPECT_FALSE(body->relaxes());
  EXPECT_THROW(make_body(Form::one_point, {Vector3::Zero(), 1e-3, {1, 1, 1}, false, {}},
                         {{0.5, 1e-8}}, 1e-7),
               InputError);
}
} // namespace
} // namespace ricochet::tests
