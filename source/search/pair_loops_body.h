// SPDX-License-Identifier: LGPL-2.1-or-later
// The loops behind search/pair_loops.h, written once on a SIMD type. Each including file defines,
// in an unnamed namespace before this header, a struct Lanes of its instruction set.
#pragma once

#include "ricochet/search/pair_loops.h"

namespace ricochet
{
namespace
{
/// One point, its coordinates moved to where its partners are expected.
struct Query
{
  float u[3];
  int32_t image;
  float sure;
  float place[3];
};

/// Pairs on their way to the sink.
class PairBuffer
{
public:
  static constexpr int64_t chunk = 1024; // points compared between two looks at the fill

  explicit PairBuffer(const PairSink &sink) : sink_(sink) {}
  ~PairBuffer() { flush(); }
  PairBuffer(const PairBuffer &)            = delete;
  PairBuffer &operator=(const PairBuffer &) = delete;

  PointPair *room() // for a chunk
  {
    if (n_ > capacity - chunk)
      flush();
    return pairs_ + n_;
  }
  void filled_to(const PointPair *end) { n_ = end - pairs_; }

private:
  static constexpr int64_t capacity = 8192;

  void flush()
  {
    if (n_ > 0)
      sink_.take(sink_.target, pairs_, n_);
    n_ = 0;
  }

  const PairSink &sink_;
  int64_t n_ = 0;
  PointPair pairs_[capacity + SortedPoints::padding];
};

/// In double precision, as every method does it.
inline bool is_closer(const SortedPoints &p, const int32_t a, const int32_t b)
{
  const double *x = p.position + int64_t(3) * a, *y = p.position + int64_t(3) * b;
  const double d0 = x[0] - y[0], d1 = x[1] - y[1], d2 = x[2] - y[2];
  return (d0 * d0 + d1 * d1) + d2 * d2 < p.squared_radius;
}

/// Bits of those points from number j on that are of the same family.
inline unsigned int family(const SortedPoints &p, const Query &q, const int64_t j)
{
  const Lanes::F dx = Lanes::load(p.place[0] + j) - Lanes::set(q.place[0]),
                 dy = Lanes::load(p.place[1] + j) - Lanes::set(q.place[1]),
                 dz = Lanes::load(p.place[2] + j) - Lanes::set(q.place[2]);
  // Whole numbers.
  return Lanes::less(dx * dx + dy * dy + dz * dz, Lanes::set(p.squared_family_range + 0.5f));
}

/// Appends the pairs of point `i` with the points begin ... end - 1 that are close to it.
template <bool only_inactive>
inline PointPair *compare(const SortedPoints &p, const Query &q, const int32_t i,
                          const int64_t begin, const int64_t end, PointPair *out)
{
  const Lanes::F qx = Lanes::set(q.u[0]), qy = Lanes::set(q.u[1]), qz = Lanes::set(q.u[2]);
  const Lanes::F sure = Lanes::set(q.sure), possible = Lanes::set(p.possible);
  const Lanes::I image = Lanes::set(q.image);
  for (int64_t j = begin; j < end; j += Lanes::width)
  {
    const Lanes::F dx = Lanes::load(p.u[0] + j) - qx, dy = Lanes::load(p.u[1] + j) - qy,
                   dz  = Lanes::load(p.u[2] + j) - qz;
    const Lanes::F d2  = dx * dx + dy * dy + dz * dz;
    unsigned int close = Lanes::less(d2, possible);
    if (end - j < Lanes::width)
      close &= (1u << (end - j)) - 1u;
    if constexpr (only_inactive)
      close &= ~Lanes::negative(p.active + j);
    if (close != 0 && p.place[0] != nullptr)
      close &= ~family(p, q, j);
    if (close == 0)
      continue;
    unsigned int doubtful = close & ~(Lanes::less(d2, sure) & Lanes::equal(p.image + j, image));
    for (; doubtful != 0; doubtful &= doubtful - 1)
    {
      const int lane = __builtin_ctz(doubtful);
      if (!is_closer(p, p.number[i], p.number[j + lane]))
        close &= ~(1u << lane);
    }
    out = Lanes::append(out, p.number[i], p.number + j, close);
  }
  return out;
}

/// The same in chunks, for any number of points.
template <bool only_inactive>
inline void compare(const SortedPoints &p, const Query &q, const int32_t i, int64_t begin,
                    const int64_t end, PairBuffer &buffer)
{
  for (; begin < end; begin += PairBuffer::chunk)
  {
    const int64_t stop   = begin + PairBuffer::chunk < end ? begin + PairBuffer::chunk : end;
    PointPair *const out = buffer.room();
    buffer.filled_to(compare<only_inactive>(p, q, i, begin, stop, out));
  }
}

inline Query query(const SortedPoints &p, const int32_t i)
{
  Query q{{p.u[0][i], p.u[1][i], p.u[2][i]}, p.image[i], p.image[i] < 0 ? -1.f : p.sure, {}};
  for (int d = 0; d < 3 && p.place[0] != nullptr; ++d)
    q.place[d] = p.place[d][i];
  return q;
}

/// Points of neighbouring cells that lie behind one another, and where they are if the grid wraps
/// around.
struct Run
{
  int64_t begin, end;
  float shift[3]; // of the query [cells]
  int32_t image_shift;
};

class Runs
{
public:
  explicit Runs(const CellTable &table) : t_(table) {}

  /// Those of four neighbouring columns around height z: the ones behind the column x, y
  /// (direction = 1) or the ones before it (-1); and beyond a seam those of the own column.
  void collect(const int32_t x, const int32_t y, const int32_t z, const int direction)
  {
    n_                               = 0;
    static constexpr int column[][2] = {{0, 1}, {1, -1}, {1, 0}, {1, 1}};
    for (const auto &step : column)
    {
      const int32_t to_x = x + direction * step[0], to_y = y + direction * step[1];
      const int step_x = seam(to_x, 0), step_y = seam(to_y, 1);
      add_column(to_x - step_x * t_.n[0], to_y - step_y * t_.n[1], z, step_x, step_y);
    }
    if (t_.wraps[2] && direction == 1 && z + 1 == t_.n[2])
      add(x, y, 0, 0, 0, 0, 1);
    if (t_.wraps[2] && direction == -1 && z == 0)
      add(x, y, t_.n[2] - 1, t_.n[2] - 1, 0, 0, -1);
  }
  const Run *begin() const { return runs_; }
  const Run *end() const { return runs_ + n_; }

private:
  /// How often the grid must be shifted for cell c.
  int seam(const int32_t c, const int axis) const { return c < 0 ? -1 : c >= t_.n[axis] ? 1 : 0; }

  void add_column(const int32_t x, const int32_t y, const int32_t z, const int step_x,
                  const int step_y)
  {
    add(x, y, z > 0 ? z - 1 : 0, z + 1 < t_.n[2] ? z + 1 : z, step_x, step_y, 0);
    if (t_.wraps[2] && z == 0)
      add(x, y, t_.n[2] - 1, t_.n[2] - 1, step_x, step_y, -1);
    if (t_.wraps[2] && z + 1 == t_.n[2])
      add(x, y, 0, 0, step_x, step_y, 1);
  }

  void add(const int32_t x, const int32_t y, const int32_t first_z, const int32_t last_z,
           const int step_x, const int step_y, const int step_z)
  {
    const int64_t column = (int64_t(x) * t_.n[1] + y) * t_.n[2];
    Run &run             = runs_[n_];
    run.begin            = t_.begin[column + first_z];
    run.end              = t_.begin[column + last_z + 1];
    // The neighbour is `step` periods ahead: the query goes back by as much.
    run.shift[0]         = float(-step_x * t_.n[0]);
    run.shift[1]         = float(-step_y * t_.n[1]);
    run.shift[2]         = float(-step_z * t_.n[2]);
    run.image_shift =
        step_x * t_.next_image[0] + step_y * t_.next_image[1] + step_z * t_.next_image[2];
    n_ += run.begin < run.end;
  }

  const CellTable &t_;
  int n_ = 0;
  Run runs_[4 * 2 + 1 + 1];
};

/// Pairs of point `i` with all points of some runs.
template <bool only_inactive>
inline void compare(const SortedPoints &p, const Query &q, const int32_t i, const Runs &runs,
                    PairBuffer &buffer)
{
  for (const Run &run : runs)
  {
    Query moved = q;
    for (int d = 0; d < 3; ++d)
      moved.u[d] += run.shift[d];
    moved.image += run.image_shift;
    compare<only_inactive>(p, moved, i, run.begin, run.end, buffer);
  }
}

inline void cells(const SortedPoints &p, const CellTable &t, const int64_t first,
                  const int64_t last, const PairSink &sink)
{
  PairBuffer buffer(sink);
  Runs behind(t), before(t);
  for (int64_t c = first; c < last; ++c)
  {
    const int32_t begin = t.begin[c], end = t.begin[c + 1];
    int32_t n_active = 0;
    for (int32_t i = begin; i < end && p.active; ++i)
      n_active -= p.active[i];
    if (begin == end || (p.active && n_active == 0))
      continue;
    const int32_t z = c % t.n[2], y = c / t.n[2] % t.n[1], x = c / t.n[2] / t.n[1];
    const int64_t own_begin = z > 0 ? t.begin[c - 1] : begin;
    const int64_t own_end   = z + 1 < t.n[2] ? t.begin[c + 2] : end;
    behind.collect(x, y, z, 1);
    if (p.active)
      before.collect(x, y, z, -1);
    for (int32_t i = begin; i < end; ++i)
    {
      if (p.active && !p.active[i])
        continue;
      const Query own = query(p, i);
      compare<false>(p, own, i, i + 1, own_end, buffer);
      compare<false>(p, own, i, behind, buffer);
      if (p.active)
      {
        // Two active points meet where the first one of them is at i.
        compare<true>(p, own, i, own_begin, i, buffer);
        compare<true>(p, own, i, before, buffer);
      }
    }
  }
}

inline void rows(const SortedPoints &p, const int64_t last, const int64_t n_points,
                 const int64_t first, const int64_t stride, const PairSink &sink)
{
  PairBuffer buffer(sink);
  for (int64_t i = first; i < last; i += stride)
    compare<false>(p, query(p, int32_t(i)), int32_t(i), i + 1, n_points, buffer);
}

const PairLoops loops = {Lanes::name, &cells, &rows};
} // namespace
} // namespace ricochet
