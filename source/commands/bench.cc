// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/units.h"
#include "ricochet/peridynamics/peridynamic_body.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace ricochet
{
void bench_kernel(const MPI_Comm communicator, const KernelBenchOptions &options)
{
  using namespace units;
  if (options.points_per_edge < 8 || options.points_per_edge > 400 || options.repeats < 1)
    throw InputError("bench kernel: --edge " + std::to_string(options.points_per_edge) +
                     " and --repeats " + std::to_string(options.repeats) +
                     " must lie in 8 to 400 and be at least 1.");
  if (options.branches < 0 || options.branches > max_maxwell_branches ||
      (options.history != "single" && options.history != "double"))
    throw InputError("bench kernel: --viscous " + std::to_string(options.branches) +
                     " must lie in 0 to " + std::to_string(max_maxwell_branches) + ", --history '" +
                     options.history + "' be 'single' or 'double'.");
  const int n           = options.points_per_edge;
  const Stencil stencil = make_stencil(1. * mm, 3., InfluenceFunction::cone);
  const double K        = 5.9 * GPa;
  const auto &law       = bond_law(options.bond_model);
  const PeridynamicMaterial material{&law, 1190., K,
                                     law.fixes_poisson_ratio ? 0.6 * K : 2.258 * GPa, 0.01};
  const Lattice::Mask sphere = [n](const int x, const int y, const int z)
  {
    const auto square = [](const double d) { return d * d; };
    return square(x - n / 2) + square(y - n / 2) + square(z - n / 2) > square(n / 4.);
  };
  const double dt      = 0.2e-6;
  const auto make_body = [&](const int branches)
  {
    auto described = material;
    // PMMA's fast branch, split.
    described.relaxation.assign(branches, {0.541 / std::max(1, branches), 95.4e-6});
    described.history_precision = options.history == "double" ? HistoryPrecision::double_precision
                                                              : HistoryPrecision::single_precision;
    auto body                   = std::make_unique<PeridynamicBody>(
        communicator, 0, Lattice::Box{Vector3::Zero(), stencil.spacing, {n, n, n}, false}, stencil,
        described, options.holes ? sphere : Lattice::Mask{},
        options.instruction_set.empty() ? nullptr : options.instruction_set.c_str());
    body->start_relaxation(dt);
    // A stretched cube that swings freely: nothing is at rest, nothing breaks.
    auto &a = body->state().arrays;
    for (std::ptrdiff_t p = body->lattice().owned_begin(); p < body->lattice().owned_end(); ++p)
      a.position[0][p] *= 1.001;
    return body;
  };
  const auto asked   = make_body(options.branches);
  const auto elastic = options.branches > 0 ? make_body(0) : nullptr;
  auto &body         = *asked;

  const double bonds = body.count_bonds();
  const int steps    = std::max(1, static_cast<int>(2e8 / (2. * bonds)));
  const int n_ranks  = size_of(communicator);
  const auto rate    = [&](PeridynamicBody &timed)
  {
    MPI_Barrier(communicator);
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; ++step)
    {
      timed.update_ghosts();
      timed.evaluate(/*breaking=*/true, /*energy=*/false);
      timed.advance(dt, dt);
    }
    MPI_Barrier(communicator);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return 2. * bonds * steps / seconds / n_ranks;
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
  double points = static_cast<double>(body.lattice().n_owned_points());
  MPI_Allreduce(MPI_IN_PLACE, &points, 1, MPI_DOUBLE, MPI_SUM, communicator);
  if (rank_in(communicator) != 0)
    return;

  nlohmann::ordered_json result;
  result["instruction_set"]                          = body.kernel().instruction_set;
  result["bond_model"]                               = law.name;
  result["points"]                                   = std::llround(points);
  result["directed_bonds"]                           = std::llround(2. * bonds);
  result["ranks"]                                    = n_ranks;
  result["steps"]                                    = steps * options.repeats;
  result["directed_bonds_per_second_per_core"]       = rates[rates.size() / 2];
  result["directed_bonds_per_second_per_core_best"]  = rates.back();
  result["directed_bonds_per_second_per_core_worst"] = rates.front();
  if (elastic)
  {
    result["relaxing_branches"]       = options.branches;
    result["history_precision"]       = options.history;
    result["history_bytes_per_point"] = body.history()->bytes_per_point();
    result["share_of_elastic_rate"]   = shares[shares.size() / 2];
  }
  if (options.json)
    std::cout << result.dump(2) << std::endl;
  else
    std::printf("%s, %s: %.0f points, %.3g M directed bonds, %d rank%s: %.0f M directed bonds/s "
                "per core (worst %.0f, best %.0f of %d)\n",
                body.kernel().instruction_set, law.name, points, 2e-6 * bonds, n_ranks,
                n_ranks == 1 ? "" : "s", 1e-6 * rates[rates.size() / 2], 1e-6 * rates.front(),
                1e-6 * rates.back(), options.repeats);
  if (elastic && !options.json)
    std::printf(
        "%d relaxing branch%s in %s precision, %.0f bytes per point: %.2f of the elastic rate "
        "(worst %.2f, best %.2f)\n",
        options.branches, options.branches == 1 ? "" : "es", options.history.c_str(),
        body.history()->bytes_per_point(), shares[shares.size() / 2], shares.front(),
        shares.back());
}
} // namespace ricochet
