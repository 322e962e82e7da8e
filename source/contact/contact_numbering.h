// SPDX-License-Identifier: LGPL-2.1-or-later
// One number for every point of all bodies and every mirror image, the same on all ranks.
#pragma once

#include "ricochet/contact/contact_bodies.h"
#include "ricochet/search/families.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ricochet
{
/// Numbers ascend in the order body, x, z, y. The difference of two numbers tells whether they have
/// been neighbours.
class ContactNumbering
{
public:
  struct Place
  {
    int body;
    std::array<int, 3> lattice; // x, y, z; y negative for an image
  };

  explicit ContactNumbering(const Bodies &bodies);

  std::int64_t id(int body, const std::array<int, 3> &at) const;
  Place place(std::int64_t id) const;
  /// Families of neighbours: of all of them, or some if the bodies differ in their horizon.
  Families families(const std::vector<std::int64_t> &ids) const;
  /// Number in the stencil of the offset from the point with the lower id to the other one; -1 if
  /// they have never been neighbours.
  int offset(const std::int64_t lower, const std::int64_t higher) const
  {
    const auto &numbers           = bodies_[lower >> body_bits].offsets;
    const std::int64_t difference = higher - lower;
    return difference < std::int64_t(numbers.size()) ? numbers[difference] : -1;
  }

private:
  static constexpr int body_bits = 48;

  struct Body
  {
    std::int64_t n_y, n_z;             // numbers for a row, rows for a plane
    int first_y;                       // of the images
    std::vector<std::int16_t> offsets; // per difference of two numbers
  };
  std::vector<Body> bodies_;
  std::vector<int> first_place_; // of each body, along x
  int squared_range_;            // the smallest of all bodies
};
} // namespace ricochet
