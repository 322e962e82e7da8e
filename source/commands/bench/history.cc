// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench/history.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/units.h"
#include "ricochet/peridynamics/peridynamic_body.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

namespace ricochet
{
namespace
{
using namespace units;

constexpr double spacing = 1. * mm;
constexpr MaxwellBranch pmma{0.541, 95.4e-6}; // the fast branch

/// Two points and the bond between them.
class LoneBond
{
public:
  LoneBond(const HistoryPrecision precision, const double dt) :
    body_(MPI_COMM_SELF, 0, {Vector3::Zero(), spacing, {2, 1, 1}, false},
          make_stencil(spacing, 1., InfluenceFunction::constant),
          {&bond_law("linear peridynamic solid"),
           1190.,
           5.9 * GPa,
           2.258 * GPa,
           std::numeric_limits<double>::infinity(),
           {pmma},
           precision}),
    end_(body_.lattice().index(1, 0, 0)), start_(body_.state().arrays.position[0][end_])
  {
    body_.start_relaxation(dt);
  }

  /// One step, to this stretch; returns the force [N].
  double step(const double stretch)
  {
    body_.state().arrays.position[0][end_] = start_ + stretch * spacing;
    body_.update_ghosts();
    body_.compute_internal_forces({});
    return -body_.state().arrays.force[0][end_];
  }

private:
  PeridynamicBody body_;
  std::ptrdiff_t end_;
  double start_; // [m]
};
} // namespace

void bench_history(const MPI_Comm communicator, const HistoryBenchOptions &options)
{
  if (options.decades < 1 || options.decades > 7)
    throw InputError("bench history: --decades " + std::to_string(options.decades) +
                     " must lie in 1 to 7.");
  if (rank_in(communicator) != 0)
    return;
  for (int decade = 0; decade <= options.decades; ++decade)
  {
    const long n    = std::lround(std::pow(10., decade)); // steps per relaxation time
    const double dt = pmma.time / n;
    LoneBond single(HistoryPrecision::single_precision, dt),
        exact(HistoryPrecision::double_precision, dt);
    std::array<double, 2> error{}; // pulled, held
    for (long i = 0; i <= 5 * n; ++i)
    {
      const double stretch = 0.02 * std::min(1., static_cast<double>(i) / n);
      const double force = single.step(stretch), expected = exact.step(stretch);
      if (i > 0)
        error[i > n] = std::max(error[i > n], std::abs(force / expected - 1.));
    }
    nlohmann::ordered_json row;
    row["dt_per_relaxation_time"] = 1. / n;
    row["steps"]                  = 5 * n;
    row["error_pulled"]           = error[0];
    row["error_held"]             = error[1];
    std::cout << row.dump() << std::endl;
  }
}
} // namespace ricochet
