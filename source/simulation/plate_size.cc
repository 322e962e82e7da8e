// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/plate_size.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
// Of the largest elements, in grid spacings.
constexpr int largest_edge     = 8;
// Sizes are told with so many digits, of which the last is no change [-].
constexpr int n_digits         = 6;
constexpr double same_to_users = 1e-6;

int rounded(const double length, const double spacing, const int multiple)
{
  return multiple * std::max(1, static_cast<int>(std::lround(length / (spacing * multiple))));
}

std::string in_mm(const double length)
{
  return with_digits(length / units::mm, n_digits) + " mm";
}

/// Extents are multiples of so many spacings.
int multiple_of(const Scene &scene, const PlateParameters &plate)
{
  return scene.zone.has_elements()
             ? scene.zone.coupling.points_per_edge << coarsening_levels(scene, plate)
             : 1;
}

[[noreturn]] void refuse(const Scene &scene, const std::string &extent, const double asked,
                         const double computed, const double unit)
{
  const bool elements = scene.zone.has_elements();
  throw InputError(
      "The " + extent + " of a plate, " + in_mm(asked) + ", would become " + in_mm(computed) +
      " to be filled with " +
      (elements ? "finite elements of " + in_mm(unit) : "points " + in_mm(unit) + " apart") +
      "; at most " + with_digits(100. * most_rounding, 3) +
      " % are tolerated. Choose a multiple of " + in_mm(unit) +
      (elements ? ", a smaller 'Grid spacing', fewer 'Coupling/Coarsening levels' or "
                  "a smaller 'Coupling/Element size'."
                : " or a smaller 'Grid spacing'."));
}
} // namespace

/// The thickness decides, the other extents are rounded to it.
int coarsening_levels(const Scene &scene, const PlateParameters &plate)
{
  if (scene.zone.coarsening_levels >= 0)
    return scene.zone.coarsening_levels;
  const int n       = scene.zone.coupling.points_per_edge;
  const int n_cells = rounded(plate.thickness, plate.spacing, n) / n;
  int levels        = 0;
  while ((2 * n << levels) <= largest_edge && n_cells % (2 << levels) == 0)
    ++levels;
  return levels;
}

std::array<int, 3> lattice_points(const Scene &scene, const PlateParameters &plate)
{
  const int multiple    = multiple_of(scene, plate);
  const double asked[3] = {plate.length, scene.symmetric ? plate.width / 2. : plate.width,
                           plate.thickness};
  const char *extent[3] = {"length", scene.symmetric ? "half width" : "width", "thickness"};
  std::array<int, 3> n;
  for (int d = 0; d < 3; ++d)
  {
    n[d]                  = rounded(asked[d], plate.spacing, multiple);
    const double computed = n[d] * plate.spacing;
    if (std::abs(computed - asked[d]) > most_rounding * asked[d])
      refuse(scene, extent[d], asked[d], computed, multiple * plate.spacing);
  }
  return n;
}

bool PlateSize::is_as_asked() const
{
  return ((computed - asked).array().abs() <= same_to_users * asked.array()).all();
}

std::vector<PlateSize> plate_sizes(const Scene &scene)
{
  std::vector<PlateSize> sizes;
  for (const auto &plate : scene.plates)
  {
    const auto n        = lattice_points(scene, plate);
    const double halves = scene.symmetric ? 2. : 1.;
    sizes.push_back({{plate.length, plate.width, plate.thickness},
                     plate.spacing * Vector3(n[0], halves * n[1], n[2])});
  }
  return sizes;
}

std::string size_text(const Vector3 &size)
{
  const auto number = [&](const int d) { return with_digits(size[d] / units::mm, n_digits); };
  return number(0) + " x " + number(1) + " x " + number(2) + " mm";
}
} // namespace ricochet
