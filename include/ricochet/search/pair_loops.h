// SPDX-License-Identifier: LGPL-2.1-or-later
// The hot loops of the pair searches, as a table of plain functions per instruction set. Single
// precision picks the candidates, sixteen at a time; only those on the edge of the radius are
// decided in double precision, so the pairs found are exactly those of double precision. This
// header is compiled for several instruction sets and must stay free of library headers.
#pragma once

#include <stdint.h>

namespace ricochet
{
/// Two points by their numbers, in no particular order.
struct PointPair
{
  int32_t first;  // number of one
  int32_t second; // and of the other
};

/// Points in the order in which they are to be compared. Arrays have `padding` readable entries
/// behind the last point.
struct SortedPoints
{
  static constexpr int padding = 16; // entries that one loop looks at together

  const float *u[3];      // coordinates, in cells
  const int32_t *image;   // points with different ones may be further apart than their u; -1: is
                          // different from all
  const int32_t *active;  // -1 or 0; null: all are
  const int32_t *number;  // of the caller
  const double *position; // x, y, z of the caller's point 0, 1, ... [m]
  double squared_radius;  // [m^2]
  float sure;             // squared distance below which a pair is one [cells^2]
  float possible;         // and below which it may be one [cells^2]
  const float *place[3]      = {};  // see search/families.h; null: there are no families
  float squared_family_range = 0.f; // of the places of a family
};

/// The cells of a grid in the order z fastest, then y, then x. See search/cell_grid.h.
struct CellTable
{
  const int32_t *begin;  // first point of each cell, and one entry more
  int32_t n[3];          // cells along x, y, z
  bool wraps[3];         // whether the last cell's neighbour is the first one
  int32_t next_image[3]; // what behind the last cell is added to the image, along x, y, z
};

/// Where the pairs go.
struct PairSink
{
  void (*take)(void *target, const PointPair *pairs, int64_t n); // is called with n pairs at a time
  void *target;                                                  // is handed to it
};

struct PairLoops
{
  const char *instruction_set; // that they are compiled for

  /// Pairs of each active point of the cells first ... last - 1 with the points behind it in its
  /// own cell and in half of the 26 neighbours, and with the inactive ones in the other half.
  void (*cells)(const SortedPoints &, const CellTable &, int64_t first, int64_t last,
                const PairSink &);

  /// Pairs of the points first, first + stride, ... < last with all of the n_points behind them.
  void (*rows)(const SortedPoints &, int64_t last, int64_t n_points, int64_t first, int64_t stride,
               const PairSink &);
};

/// The loops for the best instruction set of this processor, or for the one named ("avx512",
/// "avx2", "baseline"). Throws InputError if the processor lacks it.
const PairLoops &pair_loops(const char *instruction_set = nullptr);
} // namespace ricochet
