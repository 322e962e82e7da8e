// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench_elements.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/units.h"
#include "ricochet/finite_elements/finite_element_body.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace ricochet
{
namespace
{
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
} // namespace

void bench_elements(const MPI_Comm communicator, const ElementBenchOptions &options)
{
  using namespace units;
  const int n = options.elements_per_edge;
  if (n < 8 || n > 200 || options.repeats < 1)
    throw InputError("bench elements: --edge " + std::to_string(n) + " and --repeats " +
                     std::to_string(options.repeats) + " must lie in 8 to 200 and be at least 1.");
  if (options.element == "general")
    return bench_general_elements(communicator, options);
  if (options.element != "one point" && options.element != "full" &&
      options.element != "own tensors")
    throw InputError("bench elements: there is no element '" + options.element +
                     "'; choose 'one point', 'full', 'own tensors' or 'general'.");
  if (options.branches < 0 || options.branches > max_maxwell_branches)
    throw InputError("bench elements: --viscous " + std::to_string(options.branches) +
                     " must lie in 0 to " + std::to_string(max_maxwell_branches) + ".");
  const double edge = 1. * mm;
  FiniteElementBody::Options force;
  force.quadrature = options.element == "one point" ? Quadrature::one_point : Quadrature::full;
  force.instruction_set =
      options.instruction_set.empty() ? nullptr : options.instruction_set.c_str();
  // An eighth of the edge refined: 1.4 % more elements.
  const HexMesh::Region corner{Vector3::Zero(), Vector3::Constant(n / 8 * edge), 1};
  const double dt      = 0.1e-6; // six tenths of the small elements' limit, 0.94 h/c_P
  const auto make_body = [&](const int branches)
  {
    FiniteElementMaterial material{1190., 5.9 * GPa, 2.258 * GPa};
    // PMMA's fast branch, split.
    material.relaxation.assign(branches, {0.541 / std::max(1, branches), 95.4e-6});
    auto body = std::make_unique<FiniteElementBody>(
        communicator, HexMesh::Box{Vector3::Zero(), edge, {n, n, n}, false, {corner}}, material,
        force);
    if (options.element == "own tensors")
      give_own_tensors(*body);
    body->start_relaxation(dt);
    // A stretched cube that swings freely: nothing is at rest.
    for (std::size_t i = 0; i < body->position().size(); i += 3)
      body->position()[i] *= 1.001;
    return body;
  };
  const auto asked   = make_body(options.branches);
  const auto elastic = options.branches > 0 ? make_body(0) : nullptr;
  auto &body         = *asked;

  const double elements = static_cast<double>(body.mesh().n_global_elements());
  const int steps       = std::max(1, static_cast<int>(1e7 / elements));
  const int n_ranks     = size_of(communicator);
  const auto rate       = [&](FiniteElementBody &timed)
  {
    MPI_Barrier(communicator);
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; ++step)
    {
      timed.update_ghosts();
      timed.evaluate(/*energy=*/false);
      timed.advance(dt, dt);
    }
    MPI_Barrier(communicator);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return elements * steps / seconds / n_ranks;
  };
  std::vector<double> rates, shares; // shares: of the elastic rate just before
  for (int repeat = 0; repeat < options.repeats; ++repeat)
  {
    const double comparison = elastic ? rate(*elastic) : 0.;
    rates.push_back(rate(body));
    if (elastic)
      shares.push_back(rates.back() / comparison);
  }
  std::sort(rates.begin(), rates.end());
  std::sort(shares.begin(), shares.end());
  if (rank_in(communicator) != 0)
    return;

  nlohmann::ordered_json result;
  result["instruction_set"]                         = body.kernel().instruction_set;
  result["element"]                                 = options.element;
  result["elements"]                                = std::llround(elements);
  result["nodes"]                                   = body.mesh().n_global_nodes();
  result["ranks"]                                   = n_ranks;
  result["steps"]                                   = steps * options.repeats;
  result["element_steps_per_second_per_core"]       = rates[rates.size() / 2];
  result["element_steps_per_second_per_core_best"]  = rates.back();
  result["element_steps_per_second_per_core_worst"] = rates.front();
  if (elastic)
  {
    result["relaxing_branches"]     = options.branches;
    result["share_of_elastic_rate"] = shares[shares.size() / 2];
  }
  if (options.json)
    std::cout << result.dump(2) << std::endl;
  else
    std::printf("%s, %s: %.0f elements, %d rank%s: %.1f M element steps/s per core (worst %.1f, "
                "best %.1f of %d)\n",
                body.kernel().instruction_set, options.element.c_str(), elements, n_ranks,
                n_ranks == 1 ? "" : "s", 1e-6 * rates[rates.size() / 2], 1e-6 * rates.front(),
                1e-6 * rates.back(), options.repeats);
  if (elastic && !options.json)
    std::printf("%d relaxing branch%s: %.2f of the elastic rate (worst %.2f, best %.2f)\n",
                options.branches, options.branches == 1 ? "" : "es", shares[shares.size() / 2],
                shares.front(), shares.back());
}
} // namespace ricochet
