// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body_skin.h"

#include "search_levels.h"

#include <limits>

namespace ricochet
{
namespace
{
// A skin lasts for so many steps at the point's present speed, and a little is for those that rest.
// Both share out the cost only, between long lists and many searches. Twelve replaced sixteen when
// the search got cheaper; neither number has a measurement that was kept.
constexpr double steps_ahead   = 12.;
constexpr double thinnest_skin = 0.1; // [spacings]

// Sound points so many lattice steps around damage and rims are active like those: cracks grow
// there.
// By judgement, too: a point further away that breaks a bond is searched alone.
constexpr int band = 2;
} // namespace

BodySkin::BodySkin(const PeridynamicBody &body, const double spacing) :
  body_(body), spacing_(spacing)
{
}

void BodySkin::reset(const double dt)
{
  constexpr double largest = std::numeric_limits<double>::max();
  const Box nowhere{{largest, largest, largest}, {-largest, -largest, -largest}};
  const Lattice &l       = body_.lattice();
  const std::ptrdiff_t n = l.size();
  // What is not a number is neither near anything nor out of its skin.
  for (auto &start : start_)
    start.assign(n, std::numeric_limits<double>::quiet_NaN());
  thickness_.assign(n, 0.);
  boxes_.assign((n + chunk - 1) / chunk, nowhere);
  for (const auto &range : l.existing_ranges())
    for (std::ptrdiff_t p = range.first * Lattice::block_size; p < range.last * Lattice::block_size;
         ++p)
      thickness_[p] = skin_of(p, dt);
  l.for_each_owned([&](const std::ptrdiff_t p) { start_from_here(p); });
  occupied_.clear();
  for (std::size_t c = 0; c < boxes_.size(); ++c)
    if (boxes_[c].low[0] <= boxes_[c].high[0])
      occupied_.push_back(static_cast<std::ptrdiff_t>(c) * chunk);
  mark_active_near_damage();
}

void BodySkin::renew(const std::ptrdiff_t p, const double dt)
{
  thickness_[p] = skin_of(p, dt);
  start_from_here(p);
  // Also a sound point: it may have come near another body.
  active_[p] = 1;
}

double BodySkin::skin_of(const std::ptrdiff_t p, const double dt) const
{
  const auto &a = body_.state().arrays;
  const Vector3 v(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]);
  return std::min(thickest_skin * spacing_, thinnest_skin * spacing_ + steps_ahead * dt * v.norm());
}

void BodySkin::start_from_here(const std::ptrdiff_t p)
{
  const auto &a     = body_.state().arrays;
  Box &box          = boxes_[p / chunk];
  const double skin = thickness_[p];
  for (int d = 0; d < 3; ++d)
  {
    const double x = a.position[d][p];
    start_[d][p]   = x;
    box.low[d]     = std::min(box.low[d], x - skin);
    box.high[d]    = std::max(box.high[d], x + skin);
  }
}

void BodySkin::mark_active_near_damage()
{
  const Lattice &l = body_.lattice();
  std::vector<char> near(l.size()), before;
  for (std::ptrdiff_t p = 0; p < l.size(); ++p)
    near[p] = body_.is_open(p);
  // One axis after the other. Steps across the end of a row mark a few points too many.
  for (const std::ptrdiff_t stride :
       {std::ptrdiff_t(1), l.index(0, 0, 1) - l.index(0, 0, 0), l.plane_stride()})
  {
    before = near;
    for (std::ptrdiff_t shift = stride; shift <= band * stride; shift += stride)
      for (std::ptrdiff_t p = 0; p < l.size() - shift; ++p)
      {
        near[p + shift] |= before[p];
        near[p] |= before[p + shift];
      }
  }
  active_ = std::move(near);
}

void BodySkin::mark_active_near(const Box &box, const double range)
{
  for (std::size_t p = 0; p < thickness_.size(); ++p)
  {
    const double margin = range + thickness_[p];
    bool inside         = true;
    for (int d = 0; d < 3; ++d)
      inside = inside && start_[d][p] > box.low[d] - margin && start_[d][p] < box.high[d] + margin;
    active_[p] |= inside;
  }
}

BodySkin::Box BodySkin::bounding_box() const
{
  constexpr double largest = std::numeric_limits<double>::max();
  Box all{{largest, largest, largest}, {-largest, -largest, -largest}};
  for (const auto &box : boxes_)
    for (int d = 0; d < 3; ++d)
    {
      all.low[d]  = std::min(all.low[d], box.low[d]);
      all.high[d] = std::max(all.high[d], box.high[d]);
    }
  return all;
}
} // namespace ricochet
