// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements of a CoupledPlate that become points, and points that change their rank.
#include "nodal_means.h"
#include "ricochet/base/voigt.h"
#include "ricochet/coupling/coupled_plate.h"

#include <algorithm>

namespace ricochet
{
bool CoupledPlate::rebalance()
{
  // Moving planes costs about as much as some steps.
  constexpr double tolerable = 1.1, worth_it = 0.95;
  const Lattice &lattice = points_->lattice();
  const auto fair        = lattice.fair_plane_starts();
  const double now       = lattice.imbalance(lattice.plane_starts());
  if (now < tolerable || lattice.imbalance(fair) > worth_it * now)
    return false;
  share_planes(fair);
  return true;
}

void CoupledPlate::share_planes(const std::vector<int> &plane_starts)
{
  points_->redistribute(plane_starts);
  find_slaved_nodes();
  interpolate_to_slaved_points();
}

std::vector<std::vector<double>> CoupledPlate::nodal_histories() const
{
  const int n_branches = points_->history()->n_branches();
  return nodal_means(elements_, {2 * n_branches,
                                 [&](const int element, double *const values)
                                 {
                                   for (int k = 0; k < n_branches; ++k)
                                   {
                                     const Eigen::Matrix3d G = elements_.history(element, k);
                                     for (int i = 0; i < voigt::n; ++i)
                                       values[voigt::n * k + i] =
                                           G(voigt::row[i], voigt::column[i]);
                                   }
                                 },
                                 [](const int i) { return is_odd_in_mirror(i % voigt::n); }});
}

std::vector<std::uint8_t> CoupledPlate::layers() const
{
  std::vector<std::uint8_t> layers;
  zone_->for_each_cell([&](const Zone::Cell &cell)
                       { layers.push_back(static_cast<std::uint8_t>(zone_->layer(cell))); });
  return layers;
}

bool CoupledPlate::convert(const std::vector<Zone::Cells> &cells)
{
  const auto before = layers();
  if (!zone_->grow(cells))
    return false;
  follow_zone(before);
  return true;
}

void CoupledPlate::follow_zone(const std::vector<std::uint8_t> &before)
{
  int first = zone_->n_cells()[0], last = 0;
  std::size_t i = 0;
  std::vector<bool> was_free(before.size());
  zone_->for_each_cell(
      [&](const Zone::Cell &cell)
      {
        was_free[i] = before[i] == 0;
        if (before[i++] != zone_->layer(cell))
        {
          first = std::min(first, cell[0]);
          last  = std::max(last, cell[0] + 1);
        }
      });
  points_->follow_zone(zone_->points_per_edge() * first, zone_->points_per_edge() * last);

  // All points that did not move by themselves start from where the nodes are.
  SlavedPoints starting(communicator_, elements_, points_->lattice(),
                        [&](const Zone::Cell &cell) {
                          return !was_free[zone_->number(cell)] &&
                                 zone_->layer(cell) < zone_->far();
                        });
  starting.interpolate_to_slaved_points(elements_, points_->state());
  if (points_->history() != nullptr)
  {
    const auto nodal = nodal_histories();
    PeridynamicBody::TensorFields histories(nodal.size() / 2);
    for (std::size_t k = 0; k < histories.size(); ++k)
    {
      for (auto &field : histories[k])
        field.assign(points_->lattice().size(), 0.);
      for (const int half : {0, 1})
      {
        double *const fields[3] = {histories[k][3 * half].data(), histories[k][3 * half + 1].data(),
                                   histories[k][3 * half + 2].data()};
        starting.interpolate(nodal[2 * k + half], fields);
      }
    }
    points_->update_ghosts();
    points_->continue_history(histories);
  }

  elements_.set_active([&](const Vector3 &centre)
                       { return !zone_->is_free(cell_at(points_->lattice(), centre)); });
  build_interface();
  interpolate_to_slaved_points();
}
} // namespace ricochet
