// SPDX-License-Identifier: LGPL-2.1-or-later
// What the benches share: timing in turns and the report.
#pragma once

#include <mpi.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace ricochet
{
/// Wall time from when the first rank may start to when the last one is done [s]. Collective.
double seconds_of(MPI_Comm communicator, const std::function<void()> &action);

/// Of at least one value.
double median(std::vector<double> values);

/// Repeated measurements, sorted.
struct Rates
{
  int n_steps;                // in each repeat
  std::vector<double> values; // work per second and rank [1/s]
  std::vector<double> shares; // of the rate of the comparison just before; empty without one [-]
};

/**
 * Times repeats of `n_steps` steps each, with a comparison in turn: a machine whose speed drifts is
 * as unfair to one as to the other. Collective.
 *
 * @param work_per_step  Of one rank in a step, in whatever the rate is to be given.
 * @param step           Makes one step.
 * @param comparison     The same of the body to compare with, or an empty function.
 */
Rates time_steps(MPI_Comm communicator, int n_repeats, int n_steps, double work_per_step,
                 const std::function<void()> &step, const std::function<void()> &comparison = {});

/// A rate for the report.
struct RateName
{
  const char *json; // "element_steps"
  const char *text; // "element steps"
  int n_decimals;   // of millions, in the text
};

/// Adds ranks, steps and the rates to the facts of the bench so far.
void add_rates(nlohmann::ordered_json &facts, const RateName &name, int n_ranks,
               const Rates &rates);

/// "2 ranks: 14.1 M element steps/s per core (worst 14.0, best 14.2 of 7)"
std::string describe(const RateName &name, int n_ranks, const Rates &rates);

/// "0.61 of the elastic rate (worst 0.60, best 0.62)"
std::string describe_shares(const Rates &rates);

/// Prints the facts as JSON or else the lines.
void print_report(bool json, const nlohmann::ordered_json &facts,
                  const std::vector<std::string> &lines);

/// "1 rank", "2 ranks"
std::string counted(long n, const std::string &what, const std::string &plural_ending = "s");
} // namespace ricochet
