// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench_elements.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/units.h"
#include "ricochet/finite_elements/hexahedral_body.h"

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
void report(const MPI_Comm communicator, const ElementBenchOptions &options,
            const char *instruction_set, const double elements, const long nodes, const int steps,
            std::vector<double> rates)
{
  const int n_ranks = size_of(communicator);
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
} // namespace

void bench_general_elements(const MPI_Comm communicator, const ElementBenchOptions &options)
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
  HexahedralBody::Options body_options;
  body_options.instruction_set =
      options.instruction_set.empty() ? nullptr : options.instruction_set.c_str();
  HexahedralBody body(solid, {7850., 168. * GPa, 77.7 * GPa}, /*mirrored=*/false, body_options);
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
} // namespace ricochet
