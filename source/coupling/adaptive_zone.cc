// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/adaptive_zone.h"

#include "ricochet/base/phase_clock.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
// Free points so near to the interface are looked at.
constexpr int band_horizons = 2;
// A zone grows by bricks of so many points along x and y: the same few shapes of the interface come
// again and again, and conversions are few.
constexpr int brick_points  = 8;

/// In cells: the horizon is `horizon_ratio` spacings, which the stencil's reach does not tell (two
/// points along an axis with the cone, which is zero at its end).
int band_width(const CoupledPlate &plate)
{
  const auto &stencil = plate.points().lattice().stencil();
  const int points =
      static_cast<int>(std::ceil(band_horizons * stencil.horizon / stencil.spacing - 1e-9));
  const int n = plate.zone().points_per_edge();
  return (points + n - 1) / n;
}

int brick_below(const int cell, const int brick)
{
  return (cell >= 0 ? cell : cell - brick + 1) / brick * brick;
}
} // namespace

AdaptiveZone::AdaptiveZone(const MPI_Comm communicator, CoupledPlate &coupled_plate,
                           const Parameters &parameters) :
  communicator_(communicator),
  coupled_plate_(coupled_plate), parameters_(parameters), band_width_(band_width(coupled_plate)),
  brick_(brick_points / coupled_plate.zone().points_per_edge())
{
  find_interface_band();
}

void AdaptiveZone::find_interface_band()
{
  const Zone &zone       = coupled_plate_.zone();
  const Lattice &lattice = coupled_plate_.points().lattice();
  interface_band_        = zone.interface_band(band_width_);
  std::vector<std::uint8_t> blocks(lattice.size() / Lattice::block_size, 0);
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (lattice.free(p) && interface_band_[zone.number(coupled_plate_.points().cell_of(p))])
          blocks[p / Lattice::block_size] = 1;
      });
  band_blocks_ = ranges_of_blocks(blocks);
}

/// Columns of cells with stretched bonds, of all ranks, each once.
std::vector<Zone::Cell> AdaptiveZone::columns_in_danger()
{
  const Zone &zone = coupled_plate_.zone();
  auto &points     = coupled_plate_.points();
  const int n_y    = zone.n_cells()[1];
  std::vector<char> columns(static_cast<std::size_t>(zone.n_cells()[0]) * n_y, 0);
  for (const auto p : points.points_stretched(parameters_.stretch, band_blocks_))
    if (points.lattice().free(p))
      if (const auto cell = points.cell_of(p); interface_band_[zone.number(cell)])
        columns[static_cast<std::size_t>(cell[0]) * n_y + cell[1]] = 1;
  MPI_Allreduce(MPI_IN_PLACE, columns.data(), static_cast<int>(columns.size()), MPI_CHAR, MPI_MAX,
                communicator_);
  std::vector<Zone::Cell> found;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c])
      found.push_back({static_cast<int>(c / n_y), static_cast<int>(c % n_y), 0});
  return found;
}

/// Of the plate alone, as the leapfrog scheme conserves it; forces are those of its own.
double AdaptiveZone::energy(const double dt)
{
  coupled_plate_.update_ghosts();
  coupled_plate_.compute_internal_forces({/*energy=*/true, /*is_step=*/false});
  coupled_plate_.complete_forces();
  return coupled_plate_.energies(dt).held();
}

bool AdaptiveZone::update(const double time, const double dt, const double furthest)
{
  const PhaseClock::Work work(Phase::zones);
  if (n_updates_++ % steps_between_looks != 0 || (!parameters_.adaptive && reached_ >= 0.))
    return false;
  const auto columns = columns_in_danger();
  if (columns.empty())
    return false;
  if (!parameters_.adaptive)
  {
    reached_ = time;
    return false;
  }

  const Zone &zone   = coupled_plate_.zone();
  const auto &plate  = coupled_plate_.points().lattice().box();
  const double cells = (furthest - plate.corner.x()) / (zone.points_per_edge() * plate.spacing);
  const int last_column =
      brick_below(static_cast<int>(std::min<double>(zone.n_cells()[0], cells)), brick_) + brick_;
  std::vector<Zone::Cells> boxes;
  for (const auto &c : columns)
  {
    Zone::Cells box = zone.limit();
    for (int d = 0; d < 2; ++d)
    {
      box.low[d]  = brick_below(c[d] - band_width_, brick_);
      box.high[d] = brick_below(c[d] + band_width_, brick_) + brick_;
    }
    // What waits for the projectile has not reached its limit.
    if (reached_ < 0. && !zone.would_grow({box}))
      reached_ = time;
    box.high[0] = std::min(box.high[0], last_column);
    boxes.push_back(box);
  }
  if (!zone.would_grow(boxes))
    return false;
  const double before = energy(dt);
  coupled_plate_.convert(boxes);
  loss_ += before - energy(dt);
  ++n_conversions_;
  if (parameters_.rebalance)
    n_redistributions_ += coupled_plate_.rebalance();
  find_interface_band();
  return true;
}

void AdaptiveZone::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "adaptive zone");
  archive.common("looks", n_updates_);
  archive.common("conversions", n_conversions_);
  archive.common("redistributions", n_redistributions_);
  archive.common("loss", loss_);
  archive.common("reached", reached_);
  if (archive.is_restoring())
    find_interface_band();
}
} // namespace ricochet
