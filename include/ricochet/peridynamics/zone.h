// SPDX-License-Identifier: LGPL-2.1-or-later
// Which part of a plate is peridynamic. The plate is divided into cells, cubes of n x n x n points
// with n = 2 unless chosen otherwise; in the zone the points are free, everywhere else finite
// elements of (at least) that size carry the plate. Around the zone lie layers of cells whose
// points follow the elements' nodes:
//   pad    its points have their full (or blended) peridynamic energy, so that those in the zone
//          feel an intact family of families;
//   halo   its points have no energy, they are only neighbours of others.
// Cells on the plate's surface may carry slaved points without bonds, for contact alone. Known to
// all ranks; the same on all.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ricochet
{
/// What moves a point.
enum class PointKind : std::uint8_t
{
  absent,  // there is none
  contact, // slaved, no bonds
  slaved,  // follows the nodes of its cell
  free     // moves by itself
};

/// How the peridynamic energy of a point falls from 1 to 0 over the blend.
enum class BlendFunction
{
  step, // 1 in the whole pad
  linear,
  cubic
};

/// The blend as a function of the distance from the zone in parts of its width [-].
double blend(BlendFunction function, double t);

class Zone
{
public:
  /// Cells low <= (i, j, k) < high.
  struct Cells
  {
    std::array<int, 3> low, high;
  };
  /// Its numbers along x, y, z.
  using Cell = std::array<int, 3>;

  static constexpr int usual_points_per_edge = 2; // of a cell

  /// `reach`: of the stencil, in points. `blend_layers`: width of the blend in cells; 0 with the
  /// step function takes what the horizon needs. `points_per_edge`: of a cell, 1, 2 or 4.
  Zone(const std::array<int, 3> &n_cells, int reach, BlendFunction blend = BlendFunction::step,
       int blend_layers = 0, int points_per_edge = usual_points_per_edge);

  int points_per_edge() const { return points_per_edge_; } // of a cell

  const std::array<int, 3> &n_cells() const { return n_; } // of the plate
  int pad_layers() const { return pad_; }                  // of cells
  int halo_layers() const { return halo_; }                // of cells
  int slaved_layers() const { return pad_ + halo_; }       // of cells

  /// The zone will never grow beyond these cells, the whole plate unless said otherwise: lattices
  /// need no room there. Must contain the zone as it is. Set before lattices are built.
  void set_limit(const Cells &limit) { limit_ = limit; }
  const Cells &limit() const { return limit_; } // see set_limit()
  /// Lattice coordinates low <= y < high of all points that may ever exist.
  std::array<int, 2> rows() const;

  /// Adds cells to the zone (those inside plate and limit) and finds the layers anew. Returns
  /// whether anything changed.
  bool grow(const std::vector<Cells> &boxes);
  /// The cells of the zone as boxes of one cell each, for grow().
  std::vector<Cells> free_cells() const;
  /// Surface cells in these boxes carry contact points where no layer lies.
  void set_contact_region(const std::vector<Cells> &boxes);

  /// Layer of a cell: 0 in the zone, 1, 2 ... outwards; beyond the slaved ones, far().
  int layer(const Cell &cell) const { return layers_[number(cell)]; }
  /// The layer of cells without points, but for contact.
  int far() const { return pad_ + halo_ + 1; }
  /// Its points move by themselves.
  bool is_free(const Cell &cell) const { return layer(cell) == 0; }
  /// Pad or halo.
  bool is_slaved(const Cell &cell) const { return layer(cell) > 0 && layer(cell) < far(); }
  /// Its points are for contact alone.
  bool has_contact(const Cell &cell) const
  {
    return layer(cell) == far() && contact_[number(cell)] != 0;
  }
  /// Whether the plate has such a cell.
  bool contains(const Cell &cell) const
  {
    for (int d = 0; d < 3; ++d)
      if (cell[d] < 0 || cell[d] >= n_[d])
        return false;
    return true;
  }

  /// With the point of these lattice coordinates inside the plate.
  Cell cell_of(int x, int y, int z) const
  {
    return {x / points_per_edge_, y / points_per_edge_, z / points_per_edge_};
  }
  /// Of the point with these lattice coordinates inside the plate.
  PointKind kind(int x, int y, int z) const
  {
    const Cell cell = cell_of(x, y, z);
    const int layer = this->layer(cell);
    return layer == 0               ? PointKind::free
           : layer < far()          ? PointKind::slaved
           : contact_[number(cell)] ? PointKind::contact
                                    : PointKind::absent;
  }
  /// Share of the point's peridynamic energy that counts [-].
  double weight(int x, int y, int z) const;

  /// Per cell (see number()), whether it is free and at most so many cells away from one that is
  /// not.
  std::vector<char> interface_band(int width) const;
  /// Whether grow() would change anything.
  bool would_grow(const std::vector<Cells> &boxes) const;

  /// Of a cell, in the order of for_each_cell().
  std::size_t number(const Cell &cell) const
  {
    return (static_cast<std::size_t>(cell[0]) * n_[1] + cell[1]) * n_[2] + cell[2];
  }
  /// Cells whose points move by themselves.
  std::int64_t n_free_cells() const;
  /// Cells of pad and halo.
  std::int64_t n_slaved_cells() const;
  /// Cells of the plate.
  std::int64_t n_cells_in_all() const { return static_cast<std::int64_t>(layers_.size()); }

  /// Calls visit(cell) for all cells of the plate.
  template <class Visitor>
  void for_each_cell(Visitor &&visit) const
  {
    for (int i = 0; i < n_[0]; ++i)
      for (int j = 0; j < n_[1]; ++j)
        for (int k = 0; k < n_[2]; ++k)
          visit(Cell{i, j, k});
  }

private:
  template <class Visitor>
  void for_each_cell_in(const Cells &box, Visitor &&visit) const;
  void find_layers();

  std::array<int, 3> n_;
  Cells limit_;
  int points_per_edge_, pad_, halo_;
  BlendFunction blend_;
  std::vector<std::uint8_t> layers_, contact_; // per cell
};
} // namespace ricochet
