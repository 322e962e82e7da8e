// SPDX-License-Identifier: LGPL-2.1-or-later
#include "observed_order.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet
{
namespace
{
using Three = std::array<GridResult, 3>; // from the coarsest

// An order above this is a difference that vanishes by chance [-].
constexpr double highest_order = 16.;
// Bisection of that range down to rounding [-].
constexpr int n_halvings       = 60;

/// (h1^p - h2^p)/(h2^p - h3^p), which rises with p from ln(h1/h2)/ln(h2/h3) at 0.
double ratio_at(const Three &grids, const double p)
{
  const double coarse = std::pow(grids[0].size / grids[1].size, p),
               fine   = std::pow(grids[2].size / grids[1].size, p);
  return (coarse - 1.) / (1. - fine);
}

/// Nothing if the differences change their sign or do not fall.
std::optional<double> order_of(const Three &grids)
{
  const double wanted = (grids[0].value - grids[1].value) / (grids[1].value - grids[2].value);
  const double least =
      std::log(grids[0].size / grids[1].size) / std::log(grids[1].size / grids[2].size);
  if (!(wanted > least) || !std::isfinite(wanted) || wanted > ratio_at(grids, highest_order))
    return {};
  double low = 0., high = highest_order;
  for (int i = 0; i < n_halvings; ++i)
  {
    const double middle                             = 0.5 * (low + high);
    (ratio_at(grids, middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::string why_none(const Three &grids)
{
  const double first = grids[0].value - grids[1].value, second = grids[1].value - grids[2].value;
  const auto is_lost = [](const double difference, const GridResult &a, const GridResult &b)
  { return std::abs(difference) <= 2. * std::hypot(a.error, b.error); };
  if (first == 0. || second == 0.)
    return "two grids agree to the last digit";
  if (is_lost(first, grids[0], grids[1]) || is_lost(second, grids[1], grids[2]))
    return "differences are lost in the scatter of the runs";
  if (first * second < 0.)
    return "values go to and fro";
  return order_of(grids) ? "" : "differences do not fall as those of a power of the size would";
}

/// What the standard errors of the values make of the order.
double propagated(const Three &grids, const double order)
{
  double sum = 0.;
  for (std::size_t i = 0; i < grids.size(); ++i)
    if (grids[i].error > 0.)
    {
      auto moved = grids;
      moved[i].value += grids[i].error;
      const auto other = order_of(moved);
      sum += other ? std::pow(*other - order, 2) : order * order; // it may be anything
    }
  return std::sqrt(sum);
}
} // namespace

ObservedOrder observed_order(std::vector<GridResult> grids)
{
  std::sort(grids.begin(), grids.end(),
            [](const GridResult &a, const GridResult &b) { return a.size > b.size; });
  ObservedOrder observed;
  if (grids.size() < 3)
  {
    observed.why_none = "three grids are needed";
    return observed;
  }
  std::vector<double> orders;
  Three finest{};
  for (std::size_t i = 0; i + 3 <= grids.size(); ++i)
  {
    finest            = {grids[i], grids[i + 1], grids[i + 2]};
    observed.why_none = why_none(finest);
    if (!observed.why_none.empty())
      return observed;
    orders.push_back(*order_of(finest));
  }
  const double p     = orders.back();
  observed.order     = p;
  const auto [a, b]  = std::minmax_element(orders.begin(), orders.end());
  const double wider = std::max(0.5 * (*b - *a), propagated(finest, p));
  if (orders.size() > 1 || wider > 0.)
    observed.uncertainty = wider;
  const double second = std::pow(finest[1].size, p), third = std::pow(finest[2].size, p);
  observed.limit = finest[2].value - (finest[1].value - finest[2].value) / (second - third) * third;
  return observed;
}
} // namespace ricochet
