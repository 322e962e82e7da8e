// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_numbering.h"

#include <algorithm>
#include <limits>

namespace ricochet
{
ContactNumbering::ContactNumbering(const Bodies &bodies) :
  squared_range_(std::numeric_limits<int>::max())
{
  int first_place = 0;
  for (const auto &body : bodies)
  {
    const auto &stencil = body->lattice().stencil();
    const auto &n       = body->lattice().box().n;
    // Rows and planes are kept apart by the stencil's reach: a difference has one meaning only.
    Body numbers{2 * n[1] + stencil.reach, n[2] + stencil.reach, -n[1], {}};
    const auto difference = [&](const Stencil::Offset &o)
    { return (o.x * numbers.n_z + o.z) * numbers.n_y + o.y; };
    std::int64_t largest = 0;
    for (const auto &offset : stencil.offsets)
      largest = std::max(largest, difference(offset));
    numbers.offsets.assign(largest + 1, -1);
    for (std::size_t k = 0; k < stencil.offsets.size(); ++k)
      numbers.offsets[difference(stencil.offsets[k])] = static_cast<std::int16_t>(k);
    bodies_.push_back(std::move(numbers));
    first_place_.push_back(first_place);
    first_place += n[0] + 2 * stencil.reach; // out of reach for the body before
    squared_range_ = std::min(squared_range_, stencil.squared_range);
  }
}

std::int64_t ContactNumbering::id(const int body, const std::array<int, 3> &at) const
{
  const auto &b = bodies_[body];
  return (std::int64_t(body) << body_bits) + (at[0] * b.n_z + at[2]) * b.n_y + at[1] - b.first_y;
}

ContactNumbering::Place ContactNumbering::place(const std::int64_t id) const
{
  const int body         = static_cast<int>(id >> body_bits);
  const auto &b          = bodies_[body];
  const std::int64_t at  = id - (std::int64_t(body) << body_bits);
  const std::int64_t row = at / b.n_y;
  return {body,
          {static_cast<int>(row / b.n_z), static_cast<int>(at % b.n_y) + b.first_y,
           static_cast<int>(row % b.n_z)}};
}

Families ContactNumbering::families(const std::vector<std::int64_t> &ids) const
{
  Families families;
  families.squared_range = static_cast<float>(squared_range_);
  families.place.reserve(ids.size());
  for (const auto id : ids)
  {
    const Place at = place(id);
    families.place.push_back({static_cast<float>(first_place_[at.body] + at.lattice[0]),
                              static_cast<float>(at.lattice[1]),
                              static_cast<float>(at.lattice[2])});
  }
  return families;
}
} // namespace ricochet
