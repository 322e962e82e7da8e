// SPDX-License-Identifier: LGPL-2.1-or-later
// The order of convergence that results on three grids or more show, or that they show none.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ricochet
{
/// A result on one grid.
struct GridResult
{
  double size;       // grid spacing or edge of the elements, of any unit
  double value;      // mean of the runs
  double error = 0.; // standard error of that mean; 0 for a single run
};

struct ObservedOrder
{
  std::optional<double> order;       // p in value = limit + C size^p, of the three finest grids
  std::optional<double> uncertainty; // see below; none for three grids of single runs
  std::optional<double> limit;       // for a size of 0
  std::string why_none = "";         // if there is no order
};

/**
 * Solves (q1 - q2)/(q2 - q3) = (h1^p - h2^p)/(h2^p - h3^p) for every three neighbouring grids
 * \cite roache1994. There is no order if values go to and fro, their differences do not fall, are
 * no larger than twice their standard error, or if any three grids show none. The uncertainty is
 * half the spread of the orders of all such threes, or what the standard errors make of it if that
 * is more.
 */
ObservedOrder observed_order(std::vector<GridResult> grids);
} // namespace ricochet
