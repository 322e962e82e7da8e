// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench/harness.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"

#include <algorithm>
#include <chrono>
#include <iostream>

namespace ricochet
{
double seconds_of(const MPI_Comm communicator, const std::function<void()> &action)
{
  MPI_Barrier(communicator);
  const auto start = std::chrono::steady_clock::now();
  action();
  MPI_Barrier(communicator);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Rates time_steps(const MPI_Comm communicator, const int n_repeats, const int n_steps,
                 const double work_per_step, const std::function<void()> &step,
                 const std::function<void()> &comparison)
{
  const auto rate = [&](const std::function<void()> &one)
  {
    return work_per_step * n_steps /
           seconds_of(communicator,
                      [&]
                      {
                        for (int i = 0; i < n_steps; ++i)
                          one();
                      });
  };
  Rates rates{n_steps, {}, {}};
  for (int repeat = 0; repeat < n_repeats; ++repeat)
  {
    const double compared = comparison ? rate(comparison) : 0.;
    rates.values.push_back(rate(step));
    if (comparison)
      rates.shares.push_back(rates.values.back() / compared);
  }
  std::sort(rates.values.begin(), rates.values.end());
  std::sort(rates.shares.begin(), rates.shares.end());
  return rates;
}

void add_rates(nlohmann::ordered_json &facts, const RateName &name, const int n_ranks,
               const Rates &rates)
{
  const std::string key = std::string(name.json) + "_per_second_per_core";
  facts["ranks"]        = n_ranks;
  facts["steps"]        = rates.n_steps * static_cast<int>(rates.values.size());
  facts[key]            = median(rates.values);
  facts[key + "_best"]  = rates.values.back();
  facts[key + "_worst"] = rates.values.front();
}

std::string describe(const RateName &name, const int n_ranks, const Rates &rates)
{
  const auto millions = [&](const double rate)
  { return with_decimals(1e-6 * rate, name.n_decimals); };
  return counted(n_ranks, "rank") + ": " + millions(median(rates.values)) + " M " + name.text +
         "/s per core (worst " + millions(rates.values.front()) + ", best " +
         millions(rates.values.back()) + " of " + std::to_string(rates.values.size()) + ")";
}

std::string describe_shares(const Rates &rates)
{
  return with_decimals(median(rates.shares), 2) + " of the elastic rate (worst " +
         with_decimals(rates.shares.front(), 2) + ", best " +
         with_decimals(rates.shares.back(), 2) + ")";
}

void print_report(const bool json, const nlohmann::ordered_json &facts,
                  const std::vector<std::string> &lines)
{
  if (json)
    std::cout << facts.dump(2) << std::endl;
  else
    for (const auto &line : lines)
      std::cout << line << std::endl;
}

std::string counted(const long n, const std::string &what, const std::string &plural_ending)
{
  return std::to_string(n) + " " + what + (n == 1 ? "" : plural_ending);
}
} // namespace ricochet
