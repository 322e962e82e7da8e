// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the points of one body were when they were last searched, and the skin of each: how far it
// may get before it must be searched again. Points have skins of their own, as thick as their speed
// suggests, so fast fragments do not make the others' lists long or short-lived.
#pragma once

#include "ricochet/peridynamics/peridynamic_body.h"

#include <algorithm>
#include <vector>

namespace ricochet
{
class BodySkin
{
public:
  struct Box
  {
    double low[3], high[3]; // [m]
  };

  /// The body must outlive this object. `spacing`: the unit of skins, the largest of all bodies
  /// [m].
  BodySkin(const PeridynamicBody &body, double spacing);

  /// All points start from where they are; active are those near damage. `dt`: the coming step [s].
  void reset(double dt);
  /// So does one, with a new skin; it is active from now on.
  void renew(std::ptrdiff_t p, double dt);
  /// Points that may touch something in a box within `range` [m] become active.
  void mark_active_near(const Box &box, double range);

  /// Active are the points all of whose pairs are known; of the others only those with active
  /// points.
  bool is_active(const std::ptrdiff_t p) const { return active_[p] != 0; }
  /// Where a point started from; NaN where there is no point of this rank [m].
  Vector3 start(const std::ptrdiff_t p) const { return {start_[0][p], start_[1][p], start_[2][p]}; }
  /// Per entry of the lattice's fields; of ghosts and images as of the last reset() [m].
  const std::vector<double> &thickness() const { return thickness_; }

  /// In the box of its chunk a point stays as long as it does not leave its skin.
  static constexpr std::ptrdiff_t chunk = 8 * Lattice::block_size; // entries looked at together
  const std::vector<Box> &boxes() const { return boxes_; }         // per chunk
  /// In which all points of this rank stay.
  Box bounding_box() const;

  /// Calls visit(p) for each point that has left its skin; it may renew the point.
  template <class Visitor>
  void for_each_outside(Visitor &&visit) const;
  /// Calls visit(p) for each point that may come nearer to a place than `range` [m] before it
  /// leaves its skin.
  template <class Visitor>
  void for_each_near(const double (&place)[3], double range, Visitor &&visit) const;

private:
  double skin_of(std::ptrdiff_t p, double dt) const;
  void start_from_here(std::ptrdiff_t p);
  void mark_active_near_damage();

  const PeridynamicBody &body_;
  double spacing_;
  // Per entry of the lattice's fields.
  std::vector<double> start_[3];  // [m]
  std::vector<double> thickness_; // [m]
  std::vector<char> active_;
  std::vector<Box> boxes_;
  std::vector<std::ptrdiff_t> occupied_; // first entries of the chunks with any point
};

template <class Visitor>
void BodySkin::for_each_outside(Visitor &&visit) const
{
  const double *const *const x = body_.state().arrays.position;
  const double *const start[]  = {start_[0].data(), start_[1].data(), start_[2].data()};
  const double *const skin     = thickness_.data();
  const auto has_left          = [&](const std::ptrdiff_t p)
  {
    const double dx = x[0][p] - start[0][p], dy = x[1][p] - start[1][p], dz = x[2][p] - start[2][p];
    return dx * dx + dy * dy + dz * dz > skin[p] * skin[p];
  };
  // Counted first: this runs over all points at every step, and a sum needs no branches.
  for (const std::ptrdiff_t first : occupied_)
  {
    const std::ptrdiff_t last = std::min(body_.lattice().size(), first + chunk);
    int n_left                = 0;
    for (std::ptrdiff_t p = first; p < last; ++p)
      n_left += has_left(p);
    for (std::ptrdiff_t p = first; p < last && n_left > 0; ++p)
      if (has_left(p))
        visit(p);
  }
}

template <class Visitor>
void BodySkin::for_each_near(const double (&place)[3], const double range, Visitor &&visit) const
{
  const double *const start[] = {start_[0].data(), start_[1].data(), start_[2].data()};
  const double *const skin    = thickness_.data();
  const double x = place[0], y = place[1], z = place[2];
  const auto is_near = [=](const std::ptrdiff_t p)
  {
    const double dx = start[0][p] - x, dy = start[1][p] - y, dz = start[2][p] - z,
                 limit = range + skin[p];
    return dx * dx + dy * dy + dz * dz < limit * limit;
  };
  const auto n = static_cast<std::ptrdiff_t>(thickness_.size());
  for (std::ptrdiff_t first = 0; first < n; first += chunk)
  {
    const Box &box = boxes_[first / chunk];
    if (x + range < box.low[0] || x - range > box.high[0] || y + range < box.low[1] ||
        y - range > box.high[1] || z + range < box.low[2] || z - range > box.high[2])
      continue;
    for (std::ptrdiff_t p = first; p < std::min(n, first + chunk); ++p)
      if (is_near(p))
        visit(p);
  }
}
} // namespace ricochet
