// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/lattice.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <utility>

namespace ricochet
{
namespace
{
// Points with bonds cost; a little for all others, so that no rank gets an endless empty share.
constexpr double share_of_none = 0.02;

/// Of the layers of cells before each, and in the end of all, in cells full of points.
std::vector<double> work_before(const Zone &zone)
{
  std::vector<double> work(zone.n_cells()[0] + 1, 0.);
  zone.for_each_cell([&](const Zone::Cell &cell)
                     { work[cell[0] + 1] += zone.layer(cell) < zone.far() ? 1. : share_of_none; });
  for (std::size_t i = 1; i < work.size(); ++i)
    work[i] += work[i - 1];
  return work;
}

/// Planes of a lattice over ranks: equal numbers, or with a zone equal work. Cells of a zone are
/// not cut.
std::vector<int> share_planes(const int n_planes, const int n_ranks, const int reach,
                              const Zone *const zone)
{
  std::vector<int> starts(n_ranks + 1);
  if (zone == nullptr || n_ranks == 1)
  {
    for (int rank = 0; rank <= n_ranks; ++rank)
      starts[rank] = static_cast<int>(static_cast<std::int64_t>(n_planes) * rank / n_ranks);
    return starts;
  }

  const int edge         = zone->points_per_edge();
  const int n_layers     = n_planes / edge;
  const int least_layers = (reach + edge - 1) / edge;
  const auto work        = work_before(*zone);
  starts[n_ranks]        = n_planes;
  for (int rank = 1; rank < n_ranks; ++rank)
  {
    const double target = work[n_layers] * rank / n_ranks;
    int layer = static_cast<int>(std::lower_bound(work.begin(), work.end(), target) - work.begin());
    if (layer > 0 && work[layer] - target > target - work[layer - 1])
      --layer;
    layer        = std::max(layer, starts[rank - 1] / edge + least_layers);
    layer        = std::min(layer, n_layers - (n_ranks - rank) * least_layers);
    starts[rank] = edge * layer;
  }
  return starts;
}
} // namespace

std::vector<Lattice::BlockRange> ranges_of_blocks(const std::vector<std::uint8_t> &masks)
{
  std::vector<Lattice::BlockRange> ranges;
  const auto n = static_cast<std::int64_t>(masks.size());
  for (std::int64_t b = 0; b < n; ++b)
    if (masks[b] != 0)
    {
      if (ranges.empty() || ranges.back().last != b)
        ranges.push_back({b, b});
      ranges.back().last = b + 1;
    }
  return ranges;
}

Lattice::Lattice(const Box &box, const Stencil &stencil, const int rank, const int n_ranks,
                 const Mask &mask, const Zone *const zone) :
  box_(box),
  stencil_(stencil), mask_(mask), zone_(zone)
{
  mirror_layers_ = box.mirror_y ? stencil.reach : 0;
  if (box.mirror_y && box.n[1] < stencil.reach)
    throw InputError(
        "Only " + std::to_string(box.n[1]) +
        " points lie between the symmetry plane and the plate's edge; the horizon needs " +
        std::to_string(stencil.reach) + ". Widen the plate or refine the grid spacing.");
  const int n_planes_all = box.n[0];
  // Cells of a zone are not cut: shares may be smaller than the mean by one of them.
  const int least        = stencil.reach + (zone ? zone->points_per_edge() : 0);
  if (n_ranks > 1 && n_planes_all / n_ranks < least)
    throw InputError(
        "A plate of " + std::to_string(n_planes_all) + " lattice planes cannot be shared by " +
        std::to_string(n_ranks) + " ranks: each must own at least " + std::to_string(least) +
        " planes. Use at most " + std::to_string(std::max(1, n_planes_all / least)) + " ranks.");
  plane_starts_   = share_planes(n_planes_all, n_ranks, stencil.reach, zone);
  const auto rows = zone != nullptr ? zone->rows() : std::array<int, 2>{0, box.n[1]};
  y_low_          = box.mirror_y ? -mirror_layers_ : rows[0];
  y_high_         = std::max(rows[1], rows[0] + std::max(1, mirror_layers_));
  row_stride_     = y_high_ - y_low_;
  plane_stride_   = (row_stride_ * box.n[2] + block_size - 1) / block_size * block_size;
  take_share(rank);
}

Lattice::Lattice(const Lattice &other, std::vector<int> plane_starts, const int rank) :
  Lattice(other)
{
  plane_starts_ = std::move(plane_starts);
  take_share(rank);
}

std::vector<int> Lattice::fair_plane_starts() const
{
  return share_planes(box_.n[0], static_cast<int>(plane_starts_.size()) - 1, stencil_.reach, zone_);
}

double Lattice::imbalance(const std::vector<int> &plane_starts) const
{
  if (zone_ == nullptr)
    return 1.;
  const auto work     = work_before(*zone_);
  const std::size_t n = plane_starts.size() - 1;
  double largest      = 0.;
  for (std::size_t rank = 0; rank < n; ++rank)
    largest = std::max(largest, work[plane_starts[rank + 1] / zone_->points_per_edge()] -
                                    work[plane_starts[rank] / zone_->points_per_edge()]);
  return largest * static_cast<double>(n) / work.back();
}

void Lattice::take_share(const int rank)
{
  first_plane_                   = plane_starts_[rank];
  n_planes_                      = plane_starts_[rank + 1] - first_plane_;
  // Behind the last ghost plane: room for the loads of lanes whose bond does not exist.
  const std::ptrdiff_t overshoot = (stencil_.reach + 1) * row_stride_ + 2 * block_size;
  size_ = ((n_planes_ + 2 * stencil_.reach) * plane_stride_ + overshoot + block_size - 1) /
          block_size * block_size;

  for (auto *masks : {&exists_, &owned_, &free_})
    masks->assign(size_ / block_size, 0);
  place_points(0, box_.n[0]);
  find_ranges();
}

bool Lattice::is_cut_out(const std::array<int, 3> &c) const
{
  const int y = c[1] < 0 && box_.mirror_y ? -1 - c[1] : c[1];
  return mask_ && c[0] >= 0 && c[0] < box_.n[0] && y >= 0 && y < box_.n[1] && c[2] >= 0 &&
         c[2] < box_.n[2] && !mask_(c[0], y, c[2]);
}

PointKind Lattice::kind_at(const int x, const int y, const int z) const
{
  const int folded = y < 0 ? -1 - y : y;
  if (is_cut_out({x, folded, z}))
    return PointKind::absent;
  return zone_ == nullptr ? PointKind::free : zone_->kind(x, folded, z);
}

PointKind Lattice::kind(const std::ptrdiff_t index) const
{
  if (!exists(index))
    return PointKind::absent;
  const auto c = coordinates(index);
  return kind_at(c[0], c[1], c[2]);
}

double Lattice::weight(const std::ptrdiff_t index) const
{
  if (zone_ == nullptr)
    return 1.;
  const auto c = coordinates(index);
  return zone_->weight(c[0], c[1] < 0 ? -1 - c[1] : c[1], c[2]);
}

void Lattice::place_points(const int first, const int last)
{
  const int lowest  = std::max({0, first, first_plane_ - stencil_.reach});
  const int highest = std::min({box_.n[0], last, first_plane_ + n_planes_ + stencil_.reach});
  for (int x = lowest; x < highest; ++x)
    for (int z = 0; z < box_.n[2]; ++z)
      for (int y = y_low_; y < y_high_; ++y)
      {
        const PointKind kind = kind_at(x, y, z);
        if (kind == PointKind::absent)
          continue;
        const std::ptrdiff_t p = index(x, y, z);
        const std::uint8_t bit = 1u << (p % block_size);
        exists_[p / block_size] |= bit;
        if (y >= 0 && x >= first_plane_ && x < first_plane_ + n_planes_)
        {
          owned_[p / block_size] |= bit;
          if (kind == PointKind::free)
            free_[p / block_size] |= bit;
        }
      }
}

void Lattice::find_ranges()
{
  existing_ranges_  = ranges_of_blocks(exists_);
  const auto plane  = [&](const std::int64_t block) { return block * block_size / plane_stride_; };
  inhabited_planes_ = {0, 0};
  if (!existing_ranges_.empty())
    inhabited_planes_ = {plane(existing_ranges_.front().first),
                         plane(existing_ranges_.back().last - 1) + 1};
  owned_ranges_   = ranges_of_blocks(owned_);
  n_owned_points_ = 0;
  for_each_owned([&](std::ptrdiff_t) { ++n_owned_points_; });
}

void Lattice::follow_zone(const int first, const int last)
{
  place_points(first, last);
  find_ranges();
}

std::array<int, 3> Lattice::coordinates(const std::ptrdiff_t index) const
{
  const std::ptrdiff_t in_plane = index % plane_stride_;
  return {static_cast<int>(index / plane_stride_) + first_plane_ - stencil_.reach,
          static_cast<int>(in_plane % row_stride_) + y_low_,
          static_cast<int>(in_plane / row_stride_)};
}

std::ptrdiff_t Lattice::index(const int x, const int y, const int z) const
{
  return (x - first_plane_ + stencil_.reach) * plane_stride_ + z * row_stride_ + y - y_low_;
}

std::vector<std::int64_t> Lattice::shifts() const
{
  std::vector<std::int64_t> shifts;
  for (const auto &offset : stencil_.offsets)
    shifts.push_back(shift(offset));
  return shifts;
}

Vector3 Lattice::reference_position(const std::array<int, 3> &c) const
{
  return box_.corner + box_.spacing * Vector3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
}

std::vector<std::uint8_t> Lattice::intact_bonds() const
{
  std::vector<std::uint8_t> bonds((size_ / block_size) * stencil_.offsets.size(), 0);
  set_intact_bonds(0, owned_end() / block_size, bonds.data());
  return bonds;
}

void Lattice::set_intact_bonds(const std::int64_t first, const std::int64_t last,
                               std::uint8_t *const bonds) const
{
  const std::size_t n_offsets = stencil_.offsets.size();
  // Neighbours of a bond: at least one of them must have energy.
  const auto has_energy       = [&](const std::ptrdiff_t p, const std::array<int, 3> &c)
  { return free(p) || zone_->weight(c[0], c[1] < 0 ? -1 - c[1] : c[1], c[2]) > 0.; };
  for (std::ptrdiff_t p = first * block_size; p < last * block_size; ++p)
  {
    if (!exists(p))
      continue;
    const auto c              = coordinates(p);
    const bool heavy          = zone_ == nullptr || has_energy(p, c);
    const bool image_in_share = c[1] < 0 && p >= owned_begin() && p < owned_end();
    for (std::size_t k = 0; k < n_offsets; ++k)
    {
      const auto &o = stencil_.offsets[k];
      const int x = c[0] + o.x, y = c[1] + o.y, z = c[2] + o.z;
      if (y < y_low_ || y >= y_high_ || z < 0 || z >= box_.n[2])
        continue;
      const std::ptrdiff_t q = p + shift(o);
      // An image and a point of the next rank: of no use here, but whoever takes over the plane
      // needs to know what became of the bond.
      const bool kept        = image_in_share && y >= 0;
      if (q < size_ && exists(q) && (owned(p) || owned(q) || kept) &&
          (heavy || has_energy(q, {x, y, z})))
        bonds[(p / block_size) * n_offsets + k] |= std::uint8_t(1u << (p % block_size));
    }
  }
}
} // namespace ricochet
