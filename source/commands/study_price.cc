// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_price.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/output/table.h"
#include "ricochet/scene/scene_reader.h"
#include "run_price.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

/// None of a stability experiment, which has no end that it must reach.
std::optional<RunPrice> price_of_case(const MPI_Comm communicator, const StudyCase &one)
{
  if (one.is_experiment)
    return {};
  try
  {
    forget_most_memory();
    const Simulation simulation(communicator, read_scene(one.file));
    return price_of(communicator, simulation);
  }
  catch (const InputError &error)
  {
    throw InputError("Case " + one.name + ": " + error.what());
  }
}

std::string duration(const double seconds)
{
  return seconds < 120.    ? with_decimals(seconds, 0) + " s"
         : seconds < 7200. ? with_decimals(seconds / 60., 0) + " min"
                           : with_decimals(seconds / 3600., 1) + " h";
}

struct Sum
{
  double core_seconds = 0., seconds = 0.;
  std::vector<double> memories; // [bytes]
  int n_to_run = 0, n_unknown = 0;
};

void print_sum(const Sum &sum, const int n_jobs)
{
  // What is in memory at the same time are at worst the largest cases.
  auto memories = sum.memories;
  std::sort(memories.rbegin(), memories.rend());
  double memory = 0.;
  for (std::size_t i = 0; i < std::min<std::size_t>(n_jobs, memories.size()); ++i)
    memory += memories[i];
  std::printf("%d to run: %.3g core-seconds (%s of one core), %s with %d at a time, %.3g GB of "
              "memory%s\n",
              sum.n_to_run, sum.core_seconds, duration(sum.core_seconds).c_str(),
              duration(sum.seconds / n_jobs).c_str(), n_jobs, memory / 1e9,
              sum.n_unknown > 0 ? ", besides what has no price" : "");
  std::printf("Runs that are decided early cost less, and runs with much debris up to a quarter "
              "more.\nNothing was started.\n");
}
} // namespace

void print_prices(const MPI_Comm communicator, const StudyParameters &study,
                  const std::vector<bool> &is_finished, const int n_jobs)
{
  Table table({"number", "case", "steps", "core-seconds", "memory MB", "status"});
  Sum sum;
  for (std::size_t i = 0; i < study.cases.size(); ++i)
  {
    const auto &one = study.cases[i];
    if (is_finished[i])
    {
      table.add({i + 1, one.label, nullptr, nullptr, nullptr, "finished"});
      continue;
    }
    const auto price = price_of_case(communicator, one);
    ++sum.n_to_run;
    sum.n_unknown += !price;
    if (!price)
    {
      table.add({i + 1, one.label, nullptr, nullptr, nullptr, "to run, no price: an experiment"});
      continue;
    }
    sum.core_seconds += price->core_seconds;
    sum.seconds += price->seconds;
    sum.memories.push_back(price->memory);
    table.add({i + 1, one.label, price->steps, price->core_seconds, price->memory / 1e6, "to run"});
  }
  if (rank_in(communicator) == 0)
  {
    std::printf("%s\n\n%s\n", study.title.c_str(), table.text().c_str());
    print_sum(sum, n_jobs);
  }
  std::fflush(stdout);
}
} // namespace ricochet
