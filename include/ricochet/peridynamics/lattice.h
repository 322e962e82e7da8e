// SPDX-License-Identifier: LGPL-2.1-or-later
// One body's points on a regular lattice, and the share of them that lives on this rank. Never
// changes after construction, unless its zone grows or its planes are shared anew; what moves is in
// LatticeState.
//
// Storage: planes of constant x, cut into contiguous slabs, one per rank; in a plane, rows of
// constant z; in a row, y is contiguous. A bond is a constant shift of the flat index, so kernels
// run over flat blocks of 8 points and never ask where a row ends: whether the bond of a point
// exists is one bit. Around the owned planes lie `reach` ghost planes on either side, and before
// each row `reach` mirror images if y = 0 is a symmetry plane. The plane stride is a multiple of 8,
// hence blocks fall on the same points for any number of ranks and sums are made in the same order.
// Of a coupled body only the points of its zone and those around it exist: rows are no longer than
// the zone may get, and loops run over the ranges of blocks that hold any point.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/peridynamics/stencil.h"
#include "ricochet/peridynamics/zone.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ricochet
{
class Lattice
{
public:
  /// Where the points lie.
  struct Box
  {
    Vector3 corner;       // of lowest coordinates [m]; y = 0 with a mirror plane
    double spacing;       // dx [m]
    std::array<int, 3> n; // points along x, y, z (with a mirror plane: those at y > 0)
    bool mirror_y;        // symmetry plane at the corner's y
  };
  /// Whether a point of the box is part of the body; arguments are its lattice coordinates.
  using Mask = std::function<bool(int, int, int)>;

  static constexpr int block_size = 8; // points whose bonds share a byte

  /// Blocks first <= b < last.
  struct BlockRange
  {
    std::int64_t first, last;
  };

  /// The share of `rank` out of `n_ranks`. With a zone, which must outlive the lattice, only its
  /// points exist. Throws InputError if a rank would own fewer planes than the stencil reaches.
  Lattice(const Box &box, const Stencil &stencil, int rank, int n_ranks, const Mask &mask = {},
          const Zone *zone = nullptr);
  /// The same body, but of its planes this rank owns plane_starts[rank] <= x < plane_starts[rank +
  /// 1].
  Lattice(const Lattice &other, std::vector<int> plane_starts, int rank);

  /// First planes of shares that are fair for the zone as it is now.
  std::vector<int> fair_plane_starts() const;
  /// Work of the busiest rank, with these shares and the zone as it is now, over the mean [-].
  double imbalance(const std::vector<int> &plane_starts) const;

  const Box &box() const { return box_; }             // of the whole body
  const Stencil &stencil() const { return stencil_; } // of every point

  std::ptrdiff_t plane_stride() const { return plane_stride_; } // from x to x + 1, in indices
  std::ptrdiff_t row_stride() const { return row_stride_; }     // from z to z + 1, in indices
  std::ptrdiff_t size() const { return size_; }    // entries of a field array, padding included
  int n_planes() const { return n_planes_; }       // owned by this rank
  int first_plane() const { return first_plane_; } // global number of the first owned one
  /// First plane of every rank, and the number of planes as last entry.
  const std::vector<int> &plane_starts() const { return plane_starts_; }
  /// Flat indices of owned planes: owned_begin() <= index < owned_end(), padding included.
  std::ptrdiff_t owned_begin() const { return stencil_.reach * plane_stride_; }
  /// See owned_begin().
  std::ptrdiff_t owned_end() const { return (stencil_.reach + n_planes_) * plane_stride_; }
  /// What is added to the index of a point to get that of its neighbour.
  std::ptrdiff_t shift(const Stencil::Offset &o) const
  {
    return o.x * plane_stride_ + o.z * row_stride_ + o.y;
  }
  /// The same of all offsets; no matter which planes are owned.
  std::vector<std::int64_t> shifts() const;

  /// Lattice coordinates of a flat index: x global, y negative for a mirror image.
  std::array<int, 3> coordinates(std::ptrdiff_t index) const;
  /// The inverse of coordinates().
  std::ptrdiff_t index(int x, int y, int z) const;
  Vector3 reference_position(const std::array<int, 3> &coordinates) const; // [m]
  /// Global plane of an owned index.
  int plane_of(std::ptrdiff_t index) const
  {
    return first_plane_ + static_cast<int>(index / plane_stride_) - stencil_.reach;
  }

  /// 1 for points that exist (ghosts and images too).
  bool exists(std::ptrdiff_t index) const { return (exists_[index / 8] >> (index % 8)) & 1; }
  /// 1 for points that exist and are integrated by this rank: no ghosts, no images.
  bool owned(std::ptrdiff_t index) const { return (owned_[index / 8] >> (index % 8)) & 1; }
  /// 1 for owned points that are moved by their own forces: not slaved to finite elements.
  bool free(std::ptrdiff_t index) const { return (free_[index / 8] >> (index % 8)) & 1; }
  /// Bits of free(), eight points a byte.
  const std::vector<std::uint8_t> &free_mask() const { return free_; }

  /// Whether the plate's box has a place there, images included, but the body no point: it was cut
  /// out. Not so where finite elements take the place of points.
  bool is_cut_out(const std::array<int, 3> &coordinates) const;
  /// Whether the body lacks any place of its box.
  bool has_cutouts() const { return mask_ != nullptr; }

  const Zone *zone() const { return zone_; } // null: all points are free
  /// Of any point that exists, ghosts and images too.
  PointKind kind(std::ptrdiff_t index) const;
  /// Share of a point's energy that counts [-].
  double weight(std::ptrdiff_t index) const;
  /// After the zone has grown: points of the planes first <= x < last (global) appear or become
  /// free.
  void follow_zone(int first, int last);

  /// One byte per block and offset, block-major: bit l is the bond from point 8 block + l. A bond
  /// is stored on every rank that owns one of its ends.
  std::vector<std::uint8_t> intact_bonds() const;
  /// The same for the blocks first <= b < last only, into `bonds` of all blocks.
  void set_intact_bonds(std::int64_t first, std::int64_t last, std::uint8_t *bonds) const;

  /// Blocks with any point, ghosts and images too.
  const std::vector<BlockRange> &existing_ranges() const { return existing_ranges_; }
  /// Blocks with any owned point.
  const std::vector<BlockRange> &owned_ranges() const { return owned_ranges_; }
  /// Calls visit(index) for the owned points in ascending order.
  template <class Visitor>
  void for_each_owned(Visitor &&visit) const;

  /// For rows of all local planes that may have points: calls visit(image, original) for each
  /// mirror image.
  template <class Visitor>
  void for_each_image(Visitor &&visit) const;

  /// Of this rank.
  std::int64_t n_owned_points() const { return n_owned_points_; }

private:
  /// Lattice coordinates inside the box, images folded back.
  PointKind kind_at(int x, int y, int z) const;
  void take_share(int rank);
  void place_points(int first, int last);
  void find_ranges();

  Box box_;
  Stencil stencil_;
  Mask mask_;
  const Zone *zone_;
  int mirror_layers_;
  int y_low_, y_high_; // coordinates that rows hold, images included
  std::vector<int> plane_starts_;
  int first_plane_, n_planes_;
  std::ptrdiff_t row_stride_, plane_stride_, size_;
  std::int64_t n_owned_points_;
  std::vector<std::uint8_t> exists_, owned_, free_;
  std::vector<BlockRange> existing_ranges_, owned_ranges_;
  BlockRange inhabited_planes_; // local ones between which all points lie
};

/// Runs of blocks, each with any bit of `masks` set.
std::vector<Lattice::BlockRange> ranges_of_blocks(const std::vector<std::uint8_t> &masks);

template <class Visitor>
void Lattice::for_each_owned(Visitor &&visit) const
{
  for (const auto &range : owned_ranges_)
    for (std::ptrdiff_t p = range.first * block_size; p < range.last * block_size; ++p)
      if (owned(p))
        visit(p);
}

template <class Visitor>
void Lattice::for_each_image(Visitor &&visit) const
{
  if (mirror_layers_ == 0)
    return;
  for (std::ptrdiff_t plane = inhabited_planes_.first; plane < inhabited_planes_.last; ++plane)
    for (int z = 0; z < box_.n[2]; ++z)
    {
      const std::ptrdiff_t first = plane * plane_stride_ + z * row_stride_ + mirror_layers_;
      for (int layer = 0; layer < mirror_layers_; ++layer)
        visit(first - 1 - layer, first + layer);
    }
}
} // namespace ricochet
