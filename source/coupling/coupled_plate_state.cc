// SPDX-License-Identifier: LGPL-2.1-or-later
// How a coupled plate is saved and restored: first what it is made of, then how that moves.
#include "ricochet/base/mpi_tools.h"
#include "ricochet/coupling/coupled_plate.h"

#include <algorithm>

namespace ricochet
{
namespace
{
/// What was found for a cell.
struct Cell
{
  std::size_t number; // in the zone
  GaussPointTensors tensors;
};

/// All that is in a map, in the order of its keys, and back.
void exchange_found(StateArchive &archive, const std::string &name,
                    std::unordered_map<CellPattern, GaussPointTensors> &found)
{
  std::string patterns;
  std::vector<double> tensors;
  std::vector<CellPattern> keys;
  keys.reserve(found.size());
  for (const auto &entry : found)
    keys.push_back(entry.first);
  std::sort(keys.begin(), keys.end());
  std::vector<std::int64_t> lengths;
  for (const auto &key : keys)
  {
    lengths.push_back(static_cast<std::int64_t>(key.size()));
    patterns += key;
    for (const auto &tensor : found.at(key))
      tensors.insert(tensors.end(), tensor.begin(), tensor.end());
  }
  archive.common(name + " lengths", lengths);
  archive.common(name + " patterns", patterns);
  archive.common(name + " tensors", tensors);
  if (!archive.is_restoring())
    return;
  found.clear();
  const double *next = tensors.data();
  std::size_t at     = 0;
  for (const auto length : lengths)
  {
    auto &own = found[patterns.substr(at, static_cast<std::size_t>(length))];
    at += static_cast<std::size_t>(length);
    for (auto &tensor : own)
    {
      std::copy_n(next, tensor.size(), tensor.begin());
      next += tensor.size();
    }
  }
}
} // namespace

void Calibration::exchange_state(StateArchive &archive)
{
  exchange_found(archive, "found", found_);
  exchange_found(archive, "similar", similar_);
  // All cells on all ranks: with another number of ranks they lie elsewhere.
  std::vector<Cell> own;
  for (const auto &[number, present] : present_)
    own.push_back({number, present.tensors});
  auto all = gather_on_every_rank(communicator_, own);
  std::sort(all.begin(), all.end(),
            [](const Cell &a, const Cell &b) { return a.number < b.number; });
  archive.common("cells", all);
  if (!archive.is_restoring())
    return;
  const Zone &zone = *points_.lattice().zone();
  present_.clear();
  auto next = all.begin();
  zone.for_each_cell(
      [&](const Zone::Cell &cell)
      {
        if (next == all.end() || next->number != zone.number(cell))
          return;
        present_[next->number] = {pattern(cell, /*alike=*/false), next->tensors};
        ++next;
      });
}

/// With the planes' share, and what was found for the cells around the zone: not what is found for
/// them now, which depends on how the zone got there.
void CoupledPlate::exchange_zone(StateArchive &archive)
{
  auto cells        = zone_->free_cells();
  const auto before = layers();
  archive.common("zone", cells);
  const bool has_grown = zone_->grow(cells);
  {
    const StateArchive::Group group(archive, "calibration");
    calibration_.exchange_state(archive);
  }
  if (shear_calibration_)
  {
    const StateArchive::Group group(archive, "shear calibration");
    shear_calibration_->exchange_state(archive);
  }
  if (has_grown)
    follow_zone(before);
  auto plane_starts = points_->lattice().plane_starts();
  archive.common("plane starts", plane_starts);
  if (!archive.is_restoring())
    return;
  // Other ranks share the planes as they would have in the end.
  if (plane_starts.size() != points_->lattice().plane_starts().size())
    plane_starts = points_->lattice().fair_plane_starts();
  if (plane_starts != points_->lattice().plane_starts())
    share_planes(plane_starts);
}

void CoupledPlate::exchange_state(StateArchive &archive)
{
  exchange_zone(archive);
  points_->exchange_state(archive);
  elements_.exchange_state(archive);
  if (archive.is_restoring())
    interpolate_to_slaved_points();
}
} // namespace ricochet
