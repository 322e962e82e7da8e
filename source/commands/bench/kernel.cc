// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench/kernel.h"

#include "bench/harness.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"
#include "ricochet/peridynamics/peridynamic_body.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace ricochet
{
namespace
{
using namespace units;

constexpr double dt = 0.2 * us; // a wave at c_P = 2736 m/s goes half a spacing

void check(const KernelBenchOptions &options)
{
  if (options.points_per_edge < 8 || options.points_per_edge > 400 || options.repeats < 1)
    throw InputError("bench kernel: --edge " + std::to_string(options.points_per_edge) +
                     " and --repeats " + std::to_string(options.repeats) +
                     " must lie in 8 to 400 and be at least 1.");
  if (options.branches < 0 || options.branches > max_maxwell_branches ||
      (options.history != "single" && options.history != "double"))
    throw InputError("bench kernel: --viscous " + std::to_string(options.branches) +
                     " must lie in 0 to " + std::to_string(max_maxwell_branches) + ", --history '" +
                     options.history + "' be 'single' or 'double'.");
}

PeridynamicMaterial material(const KernelBenchOptions &options, const int branches)
{
  const double K  = 5.9 * GPa;
  const auto &law = bond_law(options.bond_model);
  PeridynamicMaterial material{&law, 1190., K, law.fixes_poisson_ratio ? 0.6 * K : 2.258 * GPa,
                               0.01};
  // PMMA's fast branch, split.
  material.relaxation.assign(branches, {0.541 / std::max(1, branches), 95.4e-6});
  material.history_precision = options.history == "double" ? HistoryPrecision::double_precision
                                                           : HistoryPrecision::single_precision;
  return material;
}

/// A stretched cube that swings freely: nothing is at rest, nothing breaks.
std::unique_ptr<PeridynamicBody>
swinging_cube(const MPI_Comm communicator, const KernelBenchOptions &options, const int branches)
{
  const int n                = options.points_per_edge;
  const Stencil stencil      = make_stencil(1. * mm, 3., InfluenceFunction::cone);
  const Lattice::Mask sphere = [n](const int x, const int y, const int z)
  {
    const auto square = [](const double d) { return d * d; };
    return square(x - n / 2) + square(y - n / 2) + square(z - n / 2) > square(n / 4.);
  };
  auto body = std::make_unique<PeridynamicBody>(
      communicator, 0, Lattice::Box{Vector3::Zero(), stencil.spacing, {n, n, n}, false}, stencil,
      material(options, branches), options.holes ? sphere : Lattice::Mask{},
      options.instruction_set.empty() ? nullptr : options.instruction_set.c_str());
  body->start_relaxation(dt);
  auto &a = body->state().arrays;
  for (std::ptrdiff_t p = body->lattice().owned_begin(); p < body->lattice().owned_end(); ++p)
    a.position[0][p] *= 1.001;
  return body;
}

void make_step(PeridynamicBody &body)
{
  body.update_ghosts();
  body.break_bonds();
  body.compute_internal_forces({});
  body.advance(dt, dt);
}
} // namespace

void bench_kernel(const MPI_Comm communicator, const KernelBenchOptions &options)
{
  check(options);
  const auto asked   = swinging_cube(communicator, options, options.branches);
  const auto elastic = options.branches > 0 ? swinging_cube(communicator, options, 0) : nullptr;
  auto &body         = *asked;

  const double bonds = body.count_bonds();
  const int n_steps  = std::max(1, static_cast<int>(2e8 / (2. * bonds)));
  const int n_ranks  = size_of(communicator);
  const Rates rates  = time_steps(
       communicator, options.repeats, n_steps, 2. * bonds / n_ranks, [&] { make_step(body); },
      elastic ? [&] { make_step(*elastic); } : std::function<void()>());
  double points = static_cast<double>(body.lattice().n_owned_points());
  MPI_Allreduce(MPI_IN_PLACE, &points, 1, MPI_DOUBLE, MPI_SUM, communicator);
  if (rank_in(communicator) != 0)
    return;

  const RateName rate{"directed_bonds", "directed bonds", 0};
  nlohmann::ordered_json facts{{"instruction_set", body.kernel().instruction_set},
                               {"bond_model", options.bond_model},
                               {"points", std::llround(points)},
                               {"directed_bonds", std::llround(2. * bonds)}};
  add_rates(facts, rate, n_ranks, rates);
  std::vector<std::string> lines{std::string(body.kernel().instruction_set) + ", " +
                                 options.bond_model + ": " + with_decimals(points, 0) +
                                 " points, " + with_digits(2e-6 * bonds, 3) +
                                 " M directed bonds, " + describe(rate, n_ranks, rates)};
  if (elastic)
  {
    const double bytes               = body.history()->bytes_per_point();
    facts["relaxing_branches"]       = options.branches;
    facts["history_precision"]       = options.history;
    facts["history_bytes_per_point"] = bytes;
    facts["share_of_elastic_rate"]   = median(rates.shares);
    lines.push_back(counted(options.branches, "relaxing branch", "es") + " in " + options.history +
                    " precision, " + with_decimals(bytes, 0) +
                    " bytes per point: " + describe_shares(rates));
  }
  print_report(options.json, facts, lines);
}
} // namespace ricochet
