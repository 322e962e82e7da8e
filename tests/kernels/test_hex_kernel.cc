// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/element_body.h"

#include <gtest/gtest.h>

#include <limits>

namespace ricochet::tests
{
namespace
{
constexpr const char *instruction_sets[] = {"baseline", "avx2", "avx512"};

enum class Form
{
  one_point,
  integrated,
  own_tensors
};
constexpr Form forms[] = {Form::one_point, Form::integrated, Form::own_tensors};

/// Cubes of different edges between random ones of a heap of nodes: neither loops nor formulas may
/// care. 19 elements: two full blocks and three lanes of a third.
struct Heap
{
  static constexpr int n_nodes = 40, n_elements = 19;
  static constexpr double modulus = 2.7e9; // any [Pa]
  // Poisson's ratio 0.35, as in PMMA; hourglass numbers of no special value.
  static constexpr double nu      = 0.35;
  double lambda = modulus * nu / (1. + nu) / (1. - 2. * nu), mu = modulus / 2. / (1. + nu);
  double bending = modulus / 37., warping = modulus / 91.;

  std::vector<double> position = std::vector<double>(3 * n_nodes);
  std::vector<double> force    = std::vector<double>(3 * n_nodes, 0.);
  std::vector<double> strain = std::vector<double>(n_elements, -1.), hourglass = strain;
  std::vector<HexBlock> blocks    = std::vector<HexBlock>(3);
  std::vector<HexTensors> tensors = std::vector<HexTensors>(3);
  std::vector<Matrix6> matrices;

  explicit Heap(const unsigned int seed)
  {
    Random random(seed);
    for (double &x : position)
      x = 1e-3 * random.uniform();
    for (int e = 0; e < n_elements; ++e)
    {
      std::vector<int> free(n_nodes);
      for (int node = 0; node < n_nodes; ++node)
        free[node] = node;
      for (int corner = 0; corner < 8; ++corner)
      {
        const auto pick = free.begin() + int(0.5 * (random.uniform() + 1.) * (free.size() - 1));
        blocks[e / 8].entry[corner][e % 8] = 3 * *pick;
        free.erase(pick);
      }
      blocks[e / 8].edge[e % 8] = (1. + 0.5 * random.uniform()) * 1e-3;
      for (int point = 0; point < 8; ++point)
      {
        matrices.push_back(random_tensor(random, modulus));
        const auto c = upper_triangle(matrices.back());
        for (int k = 0; k < HexTensors::n_entries; ++k)
          tensors[e / 8].c[point][k][e % 8] = c[k];
      }
    }
    // Padding: the last element again.
    for (int lane = n_elements % 8; lane < 8; ++lane)
    {
      for (int corner = 0; corner < 8; ++corner)
        blocks[2].entry[corner][lane] = blocks[2].entry[corner][n_elements % 8 - 1];
      blocks[2].edge[lane] = blocks[2].edge[n_elements % 8 - 1];
      for (int point = 0; point < 8; ++point)
        for (auto &entry : tensors[2].c[point])
          entry[lane] = entry[n_elements % 8 - 1];
    }
  }

  double edge(const int e) const { return blocks[e / 8].edge[e % 8]; }
  Eigen::Matrix<double, 3, 8> corners(const int e) const
  {
    Eigen::Matrix<double, 3, 8> x;
    for (int a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d)
        x(d, a) = position[blocks[e / 8].entry[a][e % 8] + d];
    return x;
  }

  void run(const HexKernel &kernel, const Form form, const bool energy)
  {
    std::fill(force.begin(), force.end(), 0.);
    const HexArrays arrays{position.data(), force.data(), strain.data(), hourglass.data()};
    const HexGroup group{blocks.data(), tensors.data(), n_elements, lambda, mu,
                         0.8 * mu,      bending,        warping};
    const auto loop =
        form == Form::one_point    ? (energy ? kernel.one_point_and_energy : kernel.one_point)
        : form == Form::integrated ? (energy ? kernel.integrated_and_energy : kernel.integrated)
                                   : (energy ? kernel.own_tensors_and_energy : kernel.own_tensors);
    loop(arrays, group);
  }

  ReferenceElement reference(const int e, const Form form) const
  {
    ReferenceElement result;
    const auto x        = corners(e);
    const double volume = std::pow(edge(e), 3);
    const Matrix6 C     = cubic_tensor(lambda, mu, 0.8 * mu);
    if (form == Form::one_point)
    {
      result.add_point(x, edge(e), Vector3::Zero(), volume, C);
      result.add_hourglass(x, edge(e), bending, warping);
    }
    else
      for (int point = 0; point < 8; ++point)
        result.add_point(x, edge(e), ReferenceElement::corner(point) / std::sqrt(3.), volume / 8.,
                         form == Form::integrated ? C : matrices[8 * e + point]);
    return result;
  }
};

struct KernelCase
{
  const char *instruction_set;
  Form form;
};

class HexKernelLoop : public testing::TestWithParam<KernelCase>
{
};

std::vector<KernelCase> kernel_cases()
{
  std::vector<KernelCase> cases;
  for (const char *set : instruction_sets)
    for (const Form form : forms)
      cases.push_back({set, form});
  return cases;
}

std::string name_of(const KernelCase &test)
{
  return std::string(test.form == Form::one_point    ? "OnePoint"
                     : test.form == Form::integrated ? "Integrated"
                                                     : "OwnTensors") +
         "On" + test.instruction_set;
}

INSTANTIATE_TEST_SUITE_P(Cases, HexKernelLoop, testing::ValuesIn(kernel_cases()),
                         [](const auto &info) { return name_of(info.param); });

TEST_P(HexKernelLoop, AgreesWithTheTextbookElementByElement)
{
  const auto &test        = GetParam();
  const HexKernel *kernel = hex_kernel(test.instruction_set);
  if (kernel == nullptr)
    GTEST_SKIP() << "this processor does not have " << test.instruction_set;
  Heap heap(5);
  heap.run(*kernel, test.form, /*energy=*/true);

  std::vector<double> expected(heap.force.size(), 0.);
  double force_scale = 0., energy_scale = 0.;
  std::vector<ReferenceElement> elements;
  for (int e = 0; e < Heap::n_elements; ++e)
  {
    elements.push_back(heap.reference(e, test.form));
    for (int a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d)
        expected[heap.blocks[e / 8].entry[a][e % 8] + d] += elements[e].force(d, a);
    force_scale  = std::max(force_scale, elements[e].force.cwiseAbs().maxCoeff());
    energy_scale = std::max(energy_scale, elements[e].strain_energy);
  }
  // A few hundred operations on numbers of order one: 1e-16 times some tens.
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(heap.force[i], expected[i], 1e-14 * force_scale);
  for (int e = 0; e < Heap::n_elements; ++e)
  {
    EXPECT_NEAR(heap.strain[e], elements[e].strain_energy, 1e-14 * energy_scale);
    EXPECT_NEAR(heap.hourglass[e], elements[e].hourglass_energy, 1e-14 * energy_scale);
    EXPECT_EQ(heap.hourglass[e] > 0., test.form == Form::one_point);
  }

  // The force without energies is another loop and leaves energies alone.
  const auto with_energy = heap.force;
  std::fill(heap.strain.begin(), heap.strain.end(), -1.);
  heap.run(*kernel, test.form, /*energy=*/false);
  EXPECT_EQ(heap.force, with_energy);
  EXPECT_EQ(heap.strain, std::vector<double>(Heap::n_elements, -1.));
}

TEST_P(HexKernelLoop, AgreesWithTheBaselineToRounding)
{
  const auto &test        = GetParam();
  const HexKernel *kernel = hex_kernel(test.instruction_set);
  if (kernel == nullptr)
    GTEST_SKIP() << "this processor does not have " << test.instruction_set;
  Heap here(6), there(6);
  here.run(*kernel, test.form, true);
  there.run(*hex_kernel("baseline"), test.form, true);
  double scale = 0.;
  for (const double f : there.force)
    scale = std::max(scale, std::abs(f));
  for (std::size_t i = 0; i < here.force.size(); ++i)
    EXPECT_NEAR(here.force[i], there.force[i], 1e-14 * scale); // fused products round differently
}

TEST_P(HexKernelLoop, ForceIsMinusTheGradientOfTheEnergy)
{
  const auto &test        = GetParam();
  const HexKernel *kernel = hex_kernel(test.instruction_set);
  if (kernel == nullptr)
    GTEST_SKIP() << "this processor does not have " << test.instruction_set;
  Heap heap(7);
  heap.run(*kernel, test.form, true);
  const auto force = heap.force, start = heap.position;
  Random random(8);
  std::vector<double> direction(start.size());
  double power = 0., scale = 0.;
  for (std::size_t i = 0; i < direction.size(); ++i)
  {
    direction[i] = 1e-3 * random.uniform();
    power -= force[i] * direction[i];
    scale += std::abs(force[i] * direction[i]);
  }
  const auto energy = [&](const double step)
  {
    for (std::size_t i = 0; i < start.size(); ++i)
      heap.position[i] = start[i] + step * direction[i];
    heap.run(*kernel, test.form, true);
    double sum = 0.;
    for (int e = 0; e < Heap::n_elements; ++e)
      sum += heap.strain[e] + heap.hourglass[e];
    return sum;
  };
  // Energies are polynomials of degree four, for which this difference is exact; a step of the size
  // of the elements keeps rounding at 1e-15 of the energies.
  const double s = 0.5;
  const double slope =
      (8. * (energy(s) - energy(-s)) - (energy(2. * s) - energy(-2. * s))) / (12. * s);
  EXPECT_NEAR(slope, power, 1e-12 * scale);
  EXPECT_GT(std::abs(power), 1e-3 * scale);
}

TEST_P(HexKernelLoop, HasNeitherNetForceNorNetMoment)
{
  const auto &test        = GetParam();
  const HexKernel *kernel = hex_kernel(test.instruction_set);
  if (kernel == nullptr)
    GTEST_SKIP() << "this processor does not have " << test.instruction_set;
  Heap heap(9);
  heap.run(*kernel, test.form, false);
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  double force_scale = 0., moment_scale = 0.;
  for (int node = 0; node < Heap::n_nodes; ++node)
  {
    const Vector3 f = at(heap.force, node), x = at(heap.position, node);
    force += f;
    moment += x.cross(f);
    force_scale += f.norm();
    moment_scale += x.norm() * f.norm();
  }
  EXPECT_LT(force.norm(), 1e-14 * force_scale); // sums of 40 terms
  EXPECT_LT(moment.norm(), 1e-14 * moment_scale);
}

TEST(HexKernelTable, UnknownInstructionSetHasNoKernel)
{
  EXPECT_EQ(hex_kernel("abacus"), nullptr);
  ASSERT_NE(hex_kernel("baseline"), nullptr);
  ASSERT_NE(hex_kernel(), nullptr);
  EXPECT_STREQ(hex_kernel("baseline")->instruction_set, "baseline");
}

TEST(HexKernelTable, AdvanceKicksWhatHasMassAndDriftsAll)
{
  const int n = 21; // no multiple of a width
  Random random(10);
  std::vector<double> x(n), v(n), f(n), inverse_mass(n);
  for (int i = 0; i < n; ++i)
  {
    x[i]            = random.uniform();
    v[i]            = random.uniform();
    f[i]            = random.uniform();
    inverse_mass[i] = i % 5 == 0 ? 0. : 1.5 + random.uniform();
  }
  const double kick = 0.25, drift = 0.5;
  for (const char *set : instruction_sets)
  {
    const HexKernel *kernel = hex_kernel(set);
    if (kernel == nullptr)
      continue;
    auto position = x, velocity = v;
    kernel->advance(position.data(), velocity.data(), f.data(), inverse_mass.data(), n, kick,
                    drift);
    for (int i = 0; i < n; ++i)
    {
      const double after = v[i] + kick * f[i] * inverse_mass[i];
      EXPECT_NEAR(velocity[i], after, 1e-15) << set;
      EXPECT_NEAR(position[i], x[i] + drift * after, 1e-15) << set;
      if (i % 5 == 0)
      {
        EXPECT_EQ(velocity[i], v[i]) << set;
      }
    }
  }
}
} // namespace
} // namespace ricochet::tests
