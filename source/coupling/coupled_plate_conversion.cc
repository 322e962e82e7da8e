// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements of a CoupledPlate that become points, and points that change their rank.
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
  points_->redistribute(fair);
  find_slaved_nodes();
  interpolate_to_slaved_points();
  return true;
}

std::vector<std::vector<double>> CoupledPlate::nodal_histories() const
{
  constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
  const auto &mesh     = elements_.mesh();
  const int n_branches = points_->history()->n_branches();
  std::vector<double> weight(elements_.force().size(), 0.);
  std::vector<std::vector<double>> fields(2 * n_branches, weight);
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
  {
    if (!elements_.is_active(static_cast<int>(e)))
      continue;
    const auto &element = mesh.elements()[e];
    const double volume = element.edge * element.edge * element.edge;
    for (int k = -1; k < n_branches; ++k)
    {
      const Eigen::Matrix3d G =
          k < 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Ones()) : elements_.history(e, k);
      for (const int node : element.nodes)
        for (int i = 0; i < (k < 0 ? 3 : 6); ++i)
          (k < 0 ? weight : fields[2 * k + i / 3])[3 * node + i % 3] +=
              volume * G(row[i], column[i]);
    }
  }
  mesh.add_to_owners(weight.data());
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    mesh.add_to_owners(fields[f].data());
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i    = 3 * node + d;
        // The mirrored half takes 23 and 12 away.
        const bool odd = f % 2 == 1 && d != 1 && mesh.on_mirror_plane(node);
        fields[f][i]   = weight[i] > 0. && !odd ? fields[f][i] / weight[i] : 0.;
      }
    mesh.update_ghosts(fields[f].data());
    mesh.follow_masters(fields[f].data());
  }
  return fields;
}

bool CoupledPlate::convert(const std::vector<Zone::Cells> &cells)
{
  std::vector<std::uint8_t> before;
  zone_->for_each_cell([&](const Zone::Cell &cell)
                       { before.push_back(static_cast<std::uint8_t>(zone_->layer(cell))); });
  if (!zone_->grow(cells))
    return false;
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
  return true;
}
} // namespace ricochet
