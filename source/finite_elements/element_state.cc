// SPDX-License-Identifier: LGPL-2.1-or-later
// How elements and their nodes are saved and restored: by their places in the reference
// configuration, which do not depend on the ranks.
#include "absorbing_boundary.h"
#include "consistent_mass.h"
#include "element_groups.h"
#include "ricochet/base/voigt.h"
#include "ricochet/finite_elements/finite_element_body.h"

#include <algorithm>

namespace ricochet
{
void ElementGroups::exchange_state(StateArchive &archive)
{
  if (!relaxes())
    return;
  // Per element: how many Gauss points remember something, what it has dissipated, now and before
  // it was switched off, then as many values per point as fit the largest number of points.
  constexpr std::size_t most_points = 8;
  const std::size_t n_values        = voigt::n * (1 + branches_.size()),
                    n_columns       = 3 + most_points * n_values;
  std::vector<std::int64_t> places;
  for (const auto &element : mesh_.elements())
    places.push_back(mesh_.place_number(mesh_.centre(element)));
  const auto now = memories_.empty() ? memories() : memories_;
  std::vector<double> rows(places.size() * n_columns, 0.);
  for (std::size_t e = 0; e < now.size(); ++e)
  {
    double *const row = rows.data() + e * n_columns;
    row[0]            = static_cast<double>(now[e].points.size());
    row[1]            = now[e].dissipated;
    row[2]            = dissipated_before_[e];
    for (std::size_t g = 0; g < now[e].points.size(); ++g)
      std::copy(now[e].points[g].begin(), now[e].points[g].end(), row + 3 + g * n_values);
  }
  archive.rows("element histories", places, rows, n_columns);
  if (!archive.is_restoring())
    return;
  memories_.assign(places.size(), {});
  for (std::size_t e = 0; e < places.size(); ++e)
  {
    const double *const row = rows.data() + e * n_columns;
    memories_[e].dissipated = row[1];
    dissipated_before_[e]   = row[2];
    for (std::size_t g = 0; g < std::min(most_points, static_cast<std::size_t>(row[0])); ++g)
      memories_[e].points.emplace_back(row + 3 + g * n_values, row + 3 + (g + 1) * n_values);
  }
  restore_histories();
}

void FiniteElementBody::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "elements");
  const int n = mesh_.n_owned_nodes();
  std::vector<std::int64_t> places;
  std::vector<double> motion(6 * static_cast<std::size_t>(n));
  for (int node = 0; node < n; ++node)
  {
    places.push_back(mesh_.place_number(mesh_.reference_position(node)));
    std::copy_n(position_.data() + 3 * node, 3, motion.data() + 6 * node);
    std::copy_n(velocity_.data() + 3 * node, 3, motion.data() + 6 * node + 3);
  }
  archive.rows("position and velocity", places, motion, 6);
  for (int node = 0; node < n; ++node)
  {
    std::copy_n(motion.data() + 6 * node, 3, position_.data() + 3 * node);
    std::copy_n(motion.data() + 6 * node + 3, 3, velocity_.data() + 3 * node);
  }
  if (consistent_mass_)
    consistent_mass_->exchange_state(archive);
  if (boundary_)
    boundary_->exchange_state(archive);
  elements_->exchange_state(archive);
}
} // namespace ricochet
