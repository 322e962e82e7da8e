// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench/elements.h"

#include "bench/harness.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"
#include "ricochet/finite_elements/finite_element_body.h"
#include "ricochet/finite_elements/hexahedral_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace ricochet
{
namespace
{
using namespace units;

constexpr double edge       = 1. * mm;
constexpr double dt         = 0.1 * us;  // six tenths of the small elements' limit, 0.94 h/c_P
constexpr double general_dt = 0.05 * us; // about a third of the limit

void check(const ElementBenchOptions &options)
{
  const int n = options.elements_per_edge;
  if (n < 8 || n > 200 || options.repeats < 1)
    throw InputError("bench elements: --edge " + std::to_string(n) + " and --repeats " +
                     std::to_string(options.repeats) + " must lie in 8 to 200 and be at least 1.");
  const std::array<const char *, 4> known{"one point", "full", "own tensors", "general"};
  if (std::find(known.begin(), known.end(), options.element) == known.end())
    throw InputError("bench elements: there is no element '" + options.element +
                     "'; choose 'one point', 'full', 'own tensors' or 'general'.");
  if (options.branches < 0 || options.branches > max_maxwell_branches)
    throw InputError("bench elements: --viscous " + std::to_string(options.branches) +
                     " must lie in 0 to " + std::to_string(max_maxwell_branches) + ".");
}

/// Null: the best one.
const char *instruction_set(const ElementBenchOptions &options)
{
  return options.instruction_set.empty() ? nullptr : options.instruction_set.c_str();
}

/// The material's own tensor at every Gauss point: the same motion at the price of any tensor.
void give_own_tensors(FiniteElementBody &body)
{
  const double mu = body.material().shear_modulus, lambda = body.material().bulk_modulus - mu / 1.5;
  ElementStiffness stiffness;
  const auto isotropic = [&](const double first)
  {
    std::array<double, HexTensors::n_entries> tensor;
    for (int i = 0, k = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j, ++k)
        tensor[k] = (j < 3 ? first : 0.) + (i == j ? (i < 3 ? 2. * mu : mu) : 0.);
    return tensor;
  };
  stiffness.tensors.fill(isotropic(lambda));
  stiffness.shear.fill(isotropic(-mu / 1.5));
  std::vector<ElementStiffness> all(body.mesh().elements().size(), stiffness);
  for (std::size_t e = 0; e < all.size(); ++e)
    all[e].element = static_cast<int>(e);
  body.set_stiffness(all);
}

/// Stretched, to swing freely: nothing is at rest.
template <class Body>
void stretch(Body &body)
{
  for (std::size_t i = 0; i < body.position().size(); i += 3)
    body.position()[i] *= 1.001;
}

std::unique_ptr<FiniteElementBody>
swinging_cube(const MPI_Comm communicator, const ElementBenchOptions &options, const int branches)
{
  const int n = options.elements_per_edge;
  // An eighth of the edge refined: 1.4 % more elements.
  const HexMesh::Region corner{Vector3::Zero(), Vector3::Constant(n / 8 * edge), 1};
  FiniteElementBody::Options force;
  force.quadrature      = options.element == "one point" ? Quadrature::one_point : Quadrature::full;
  force.instruction_set = instruction_set(options);
  FiniteElementMaterial material{1190., 5.9 * GPa, 2.258 * GPa};
  // PMMA's fast branch, split.
  material.relaxation.assign(branches, {0.541 / std::max(1, branches), 95.4e-6});
  auto body = std::make_unique<FiniteElementBody>(
      communicator, HexMesh::Box{Vector3::Zero(), edge, {n, n, n}, false, {corner}}, material,
      force);
  if (options.element == "own tensors")
    give_own_tensors(*body);
  body->start_relaxation(dt);
  stretch(*body);
  return body;
}

void make_step(FiniteElementBody &body)
{
  body.update_ghosts();
  body.compute_internal_forces({});
  body.advance(dt, dt);
}

/// A cube of distorted elements, as in a projectile.
HexSolid distorted_cube(const int n)
{
  HexSolid solid;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        solid.nodes.push_back(edge * Vector3(i + 0.1 * std::sin(1.3 * j + k),
                                             j + 0.1 * std::sin(1.7 * k + i),
                                             k + 0.1 * std::sin(1.9 * i + j)));
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        std::array<int, 8> cell;
        for (int a = 0; a < 8; ++a)
          cell[a] = ((k + (a >> 2)) * (n + 1) + j + ((a >> 1) & 1)) * (n + 1) + i + (a & 1);
        solid.cells.push_back(cell);
      }
  return solid;
}

int steps_for(const double elements)
{
  return std::max(1, static_cast<int>(1e7 / elements));
}

void report(const MPI_Comm communicator, const ElementBenchOptions &options,
            const std::string &instruction_set, const double elements, const std::int64_t nodes,
            const Rates &rates)
{
  if (rank_in(communicator) != 0)
    return;
  const int n_ranks = size_of(communicator);
  const RateName rate{"element_steps", "element steps", 1};
  nlohmann::ordered_json facts{{"instruction_set", instruction_set},
                               {"element", options.element},
                               {"elements", std::llround(elements)},
                               {"nodes", nodes}};
  add_rates(facts, rate, n_ranks, rates);
  std::vector<std::string> lines{instruction_set + ", " + options.element + ": " +
                                 with_decimals(elements, 0) + " elements, " +
                                 describe(rate, n_ranks, rates)};
  if (!rates.shares.empty())
  {
    facts["relaxing_branches"]     = options.branches;
    facts["share_of_elastic_rate"] = median(rates.shares);
    lines.push_back(counted(options.branches, "relaxing branch", "es") + ": " +
                    describe_shares(rates));
  }
  print_report(options.json, facts, lines);
}

void bench_general_elements(const MPI_Comm communicator, const ElementBenchOptions &options)
{
  const HexSolid solid = distorted_cube(options.elements_per_edge);
  HexahedralBody::Options body_options;
  body_options.instruction_set = instruction_set(options);
  HexahedralBody body(solid, {7850., 168. * GPa, 77.7 * GPa}, /*mirrored=*/false, body_options);
  stretch(body);
  const double elements = static_cast<double>(solid.cells.size()); // of every rank
  const Rates rates     = time_steps(communicator, options.repeats, steps_for(elements), elements,
                                     [&]
                                     {
                                   body.compute_internal_forces({});
                                   body.advance(general_dt, general_dt);
                                 });
  report(communicator, options, body.kernel().instruction_set, elements,
         static_cast<std::int64_t>(solid.nodes.size()), rates);
}
} // namespace

void bench_elements(const MPI_Comm communicator, const ElementBenchOptions &options)
{
  check(options);
  if (options.element == "general")
    return bench_general_elements(communicator, options);
  const auto body       = swinging_cube(communicator, options, options.branches);
  const auto elastic    = options.branches > 0 ? swinging_cube(communicator, options, 0) : nullptr;
  const double elements = static_cast<double>(body->mesh().n_global_elements());
  const Rates rates     = time_steps(
          communicator, options.repeats, steps_for(elements), elements / size_of(communicator),
          [&] { make_step(*body); }, elastic ? [&] { make_step(*elastic); } : std::function<void()>());
  report(communicator, options, body->kernel().instruction_set, elements,
         body->mesh().n_global_nodes(), rates);
}
} // namespace ricochet
