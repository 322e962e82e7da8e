// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_history.h"

#include "plane_exchange.h"
#include "ricochet/peridynamics/plane_archive.h"

namespace ricochet
{
BondHistory::BondHistory(const std::ptrdiff_t n_points, const std::size_t n_offsets,
                         const std::size_t n_branches, const HistoryPrecision precision) :
  n_offsets_(n_offsets),
  n_branches_(n_branches)
{
  const std::size_t n = n_points * n_offsets * n_branches;
  if (precision == HistoryPrecision::single_precision)
    single_.assign(n, 0.f);
  else
    double_.assign(n, 0.);
}

void BondHistory::redistribute(const PlaneExchange &planes)
{
  const double n_per_point = static_cast<double>(n_offsets_ * n_branches_);
  if (!single_.empty())
    planes.move(single_, n_per_point);
  if (!double_.empty())
    planes.move(double_, n_per_point);
}

void BondHistory::exchange_state(PlaneArchive &planes, const std::string &name)
{
  const auto per_point = static_cast<double>(n_offsets_ * n_branches_);
  if (single_.empty())
    planes.field(name, double_.data(), per_point);
  else
    planes.field(name, single_.data(), per_point);
}
} // namespace ricochet
