// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/drivers/bench_elements.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/units.h"
#include "ricochet/forces/elastic_body.h"
#include "ricochet/forces/finite_element_force.h"
#include "ricochet/output/collective.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace ricochet
{
namespace
{
/// The material's own tensor at every Gauss point: the same motion at the price of any tensor.
void give_own_tensors(FiniteElementForce &body)
{
  const double mu = body.material().shear_modulus, lambda = body.material().bulk_modulus - mu / 1.5;
  ElementStiffness stiffness;
  for (auto &tensor : stiffness.tensors)
    for (int i = 0, k = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j, ++k)
        tensor[k] = (j < 3 ? lambda : 0.) + (i == j ? (i < 3 ? 2. * mu : mu) : 0.);
  std::vector<ElementStiffness> all(body.mesh().elements().size(), stiffness);
  for (std::size_t e = 0; e < all.size(); ++e)
    all[e].element = static_cast<int>(e);
  body.set_stiffness(all);
}

void report(const MPI_Comm communicator, const ElementBenchOptions &options,
            const char *instruction_set, const double elements, const long nodes, const int steps,
            std::vector<double> rates)
{
  int n_ranks;
  MPI_Comm_size(communicator, &n_ranks);
  std::sort(rates.begin(), rates.end());
  if (rank_in(communicator) != 0)
    return;
  nlohmann::ordered_json result;
  result["instruction_set"]                         = instruction_set;
  result["element"]                                 = options.element;
  result["elements"]                                = std::llround(elements);
  result["nodes"]                                   = nodes;
  result["ranks"]                                   = n_ranks;
  result["steps"]                                   = steps * options.repeats;
  result["element_steps_per_second_per_core"]       = rates[rates.size() / 2];
  result["element_steps_per_second_per_core_best"]  = rates.back();
  result["element_steps_per_second_per_core_worst"] = rates.front();
  if (options.json)
    std::cout << result.dump(2) << std::endl;
  else
    std::printf("%s, %s: %.0f elements, %d rank%s: %.1f M element steps/s per core (worst %.1f, "
                "best %.1f of %d)\n",
                instruction_set, options.element.c_str(), elements, n_ranks,
                n_ranks == 1 ? "" : "s", 1e-6 * rates[rates.size() / 2], 1e-6 * rates.front(),
                1e-6 * rates.back(), options.repeats);
}

/// One cube of distorted elements per rank, as every rank computes a projectile whole.
void bench_general(const MPI_Comm communicator, const ElementBenchOptions &options)
{
  using namespace units;
  const int n       = options.elements_per_edge;
  const double edge = 1. * mm;
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
  ElasticBody::Options body_options;
  body_options.instruction_set =
      options.instruction_set.empty() ? nullptr : options.instruction_set.c_str();
  ElasticBody body(solid, {7850., 168. * GPa, 77.7 * GPa}, /*mirrored=*/false, body_options);
  for (std::size_t i = 0; i < body.position().size(); i += 3)
    body.position()[i] *= 1.001;
  const double dt = 0.05e-6; // about a third of the limit

  const double elements = static_cast<double>(solid.cells.size());
  const int steps       = std::max(1, static_cast<int>(1e7 / elements));
  std::vector<double> rates;
  for (int repeat = 0; repeat < options.repeats; ++repeat)
  {
    MPI_Barrier(communicator);
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; ++step)
    {
      body.evaluate(/*energy=*/false);
      body.advance(dt, dt);
    }
    MPI_Barrier(communicator);
    rates.push_back(
        elements * steps /
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  report(communicator, options, body.kernel().instruction_set, elements,
         static_cast<long>(solid.nodes.size()), steps, rates);
}
} // namespace

void bench_elements(const MPI_Comm communicator, const ElementBenchOptions &options)
{
  using namespace units;
  const int n = options.elements_per_edge;
  if (n < 8 || n > 200 || options.repeats < 1)
    throw InputError("bench elements: --edge " + std::to_string(n) + " and --repeats " +
                     std::to_string(options.repeats) + " must lie in 8 to 200 and be at least 1.");
  if (options.element == "general")
    return bench_general(communicator, options);
  if (options.element != "one point" && options.element != "full" &&
      options.element != "own tensors")
    throw InputError("bench elements: there is no element '" + options.element +
                     "'; choose 'one point', 'full', 'own tensors' or 'general'.");
  const double edge = 1. * mm;
  FiniteElementForce::Options force;
  force.quadrature = options.element == "one point" ? Quadrature::one_point : Quadrature::full;
  force.instruction_set =
      options.instruction_set.empty() ? nullptr : options.instruction_set.c_str();
  // An eighth of the edge refined: 1.4 % more elements.
  const HexMesh::Region corner{Vector3::Zero(), Vector3::Constant(n / 8 * edge), 1};
  FiniteElementForce body(communicator, {Vector3::Zero(), edge, {n, n, n}, false, {corner}},
                          {1190., 5.9 * GPa, 2.258 * GPa}, force);
  if (options.element == "own tensors")
    give_own_tensors(body);

  // A stretched cube that swings freely: nothing is at rest.
  for (std::size_t i = 0; i < body.position().size(); i += 3)
    body.position()[i] *= 1.001;
  const double dt = 0.1e-6; // six tenths of the small elements' limit, 0.94 h/c_P

  const double elements = static_cast<double>(body.mesh().n_global_elements());
  const int steps       = std::max(1, static_cast<int>(1e7 / elements));
  std::vector<double> rates;
  int n_ranks;
  MPI_Comm_size(communicator, &n_ranks);
  for (int repeat = 0; repeat < options.repeats; ++repeat)
  {
    MPI_Barrier(communicator);
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; ++step)
    {
      body.update_ghosts();
      body.evaluate(/*energy=*/false);
      body.advance(dt, dt);
    }
    MPI_Barrier(communicator);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rates.push_back(elements * steps / seconds / n_ranks);
  }
  report(communicator, options, body.kernel().instruction_set, elements,
         static_cast<long>(body.mesh().n_global_nodes()), steps, rates);
}
} // namespace ricochet
