// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/discretization/lattice.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>

namespace ricochet
{
Lattice::Lattice(const Box &box, const Stencil &stencil, const int rank, const int n_ranks,
                 const Mask &mask) :
  box_(box),
  stencil_(stencil), mask_(mask), full_(true)
{
  mirror_layers_ = box.mirror_y ? stencil.reach : 0;
  if (box.mirror_y && box.n[1] < stencil.reach)
    throw InputError(
        "Only " + std::to_string(box.n[1]) +
        " points lie between the symmetry plane and the plate's edge; the horizon needs " +
        std::to_string(stencil.reach) + ". Widen the plate or refine the grid spacing.");
  const int n_planes_all = box.n[0];
  first_plane_ = static_cast<int>(static_cast<std::int64_t>(n_planes_all) * rank / n_ranks);
  n_planes_    = static_cast<int>(static_cast<std::int64_t>(n_planes_all) * (rank + 1) / n_ranks) -
              first_plane_;
  if (n_ranks > 1 && n_planes_all / n_ranks < stencil.reach)
    throw InputError("A plate of " + std::to_string(n_planes_all) +
                     " lattice planes cannot be shared by " + std::to_string(n_ranks) +
                     " ranks: each must own at least " + std::to_string(stencil.reach) +
                     " planes. Use at most " +
                     std::to_string(std::max(1, n_planes_all / stencil.reach)) + " ranks.");

  row_stride_   = box.n[1] + mirror_layers_;
  plane_stride_ = (row_stride_ * box.n[2] + block_size - 1) / block_size * block_size;
  // Behind the last ghost plane: room for the loads of lanes whose bond does not exist.
  const std::ptrdiff_t overshoot = (stencil.reach + 1) * row_stride_ + 2 * block_size;
  size_ = ((n_planes_ + 2 * stencil.reach) * plane_stride_ + overshoot + block_size - 1) /
          block_size * block_size;

  exists_.assign(size_ / block_size, 0);
  owned_.assign(size_ / block_size, 0);
  n_owned_points_ = 0;
  for (int x = first_plane_ - stencil.reach; x < first_plane_ + n_planes_ + stencil.reach; ++x)
    for (int z = 0; z < box.n[2]; ++z)
      for (int y = -mirror_layers_; y < box.n[1]; ++y)
      {
        if (x < 0 || x >= n_planes_all)
          continue;
        if (mask_ && !mask_(x, y < 0 ? -1 - y : y, z))
        {
          full_ = false;
          continue;
        }
        const std::ptrdiff_t p = index(x, y, z);
        const std::uint8_t bit = 1u << (p % block_size);
        exists_[p / block_size] |= bit;
        if (y >= 0 && x >= first_plane_ && x < first_plane_ + n_planes_)
        {
          owned_[p / block_size] |= bit;
          ++n_owned_points_;
        }
      }
}

std::array<int, 3> Lattice::coordinates(const std::ptrdiff_t index) const
{
  const std::ptrdiff_t in_plane = index % plane_stride_;
  return {static_cast<int>(index / plane_stride_) + first_plane_ - stencil_.reach,
          static_cast<int>(in_plane % row_stride_) - mirror_layers_,
          static_cast<int>(in_plane / row_stride_)};
}

std::ptrdiff_t Lattice::index(const int x, const int y, const int z) const
{
  return (x - first_plane_ + stencil_.reach) * plane_stride_ + z * row_stride_ + y + mirror_layers_;
}

Vector3 Lattice::reference_position(const std::array<int, 3> &c) const
{
  return box_.corner + box_.spacing * Vector3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
}

std::vector<std::uint8_t> Lattice::intact_bonds() const
{
  const std::size_t n_offsets = stencil_.offsets.size();
  std::vector<std::uint8_t> bonds((size_ / block_size) * n_offsets, 0);
  for (std::ptrdiff_t p = 0; p < owned_end(); ++p)
  {
    if (!exists(p))
      continue;
    const auto c = coordinates(p);
    for (std::size_t k = 0; k < n_offsets; ++k)
    {
      const auto &o = stencil_.offsets[k];
      const int y = c[1] + o.y, z = c[2] + o.z;
      if (y < -mirror_layers_ || y >= box_.n[1] || z < 0 || z >= box_.n[2])
        continue;
      const std::ptrdiff_t q = p + shift(o);
      if (q < size_ && exists(q) && (owned(p) || owned(q)))
        bonds[(p / block_size) * n_offsets + k] |= std::uint8_t(1u << (p % block_size));
    }
  }
  return bonds;
}
} // namespace ricochet
