// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plate_cutouts.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ricochet
{
namespace
{
/// Reference positions of a lattice in the plate's coordinates, see Cutouts.
class PlateCoordinates
{
public:
  explicit PlateCoordinates(const Lattice::Box &box) :
    box_(box), top_(box.corner.z() + box.n[2] * box.spacing)
  {
  }
  Vector3 of(const Vector3 &position) const
  {
    return {position.x() - box_.corner.x(), position.y(), top_ - position.z()};
  }
  Vector3 of(const int x, const int y, const int z) const
  {
    return of(box_.corner + box_.spacing * Vector3(x + 0.5, y + 0.5, z + 0.5));
  }

private:
  Lattice::Box box_;
  double top_;
};

/// Whether `holds` for any point of the box between x from and to, y from and to.
template <class Condition>
bool any_point(const Lattice::Box &box, const std::array<double, 4> &column, Condition &&holds)
{
  std::array<int, 2> low, high;
  for (int d = 0; d < 2; ++d)
  {
    const double from = (column[2 * d] - box.corner[d]) / box.spacing,
                 to   = (column[2 * d + 1] - box.corner[d]) / box.spacing;
    low[d]            = static_cast<int>(std::clamp<double>(std::floor(from), 0., box.n[d]));
    high[d]           = static_cast<int>(std::clamp<double>(std::ceil(to), 0., box.n[d]));
  }
  for (int x = low[0]; x < high[0]; ++x)
    for (int y = low[1]; y < high[1]; ++y)
      for (int z = 0; z < box.n[2]; ++z)
        if (holds(x, y, z))
          return true;
  return false;
}

std::string entry(const unsigned int plate, const char *name, const std::size_t number)
{
  return "'Plate " + std::to_string(plate) + "/" + name + (number > 0 ? " 2" : "") + "'";
}

template <class Cutout>
void check_each(const std::vector<Cutout> &cutouts, const Lattice::Box &box,
                const unsigned int plate, const char *name)
{
  const PlateCoordinates coordinates(box);
  for (std::size_t i = 0; i < cutouts.size(); ++i)
    if (!any_point(box, column_of(cutouts[i]),
                   [&](const int x, const int y, const int z)
                   { return removes(cutouts[i], coordinates.of(x, y, z)); }))
      throw InputError(entry(plate, name, i) +
                       " removes no point: it is too small for the grid spacing of " +
                       std::to_string(1e3 * box.spacing) +
                       " mm. Enlarge it, choose a smaller 'Grid spacing', or cut bonds with "
                       "'Crack across' or 'Crack along'.");
}
} // namespace

Lattice::Mask mask_of(const Cutouts &cutouts, const Lattice::Box &box, const unsigned int plate)
{
  if (cutouts.holes.empty() && cutouts.notches.empty())
    return {};
  check_each(cutouts.holes, box, plate, "Hole");
  check_each(cutouts.notches, box, plate, "Notch");
  const auto exists =
      [cutouts, coordinates = PlateCoordinates(box)](const int x, const int y, const int z)
  { return !cutouts.removes(coordinates.of(x, y, z)); };
  const Vector3 far = box.corner + box.spacing * Vector3(box.n[0], box.n[1], box.n[2]);
  if (!any_point(box, {box.corner.x(), far.x(), box.corner.y(), far.y()}, exists))
    throw InputError("Nothing is left of plate " + std::to_string(plate) +
                     ": its holes and notches remove all of its points. Make them smaller.");
  return exists;
}

void sever_cracks(const Cutouts &cutouts, PeridynamicBody &points, const unsigned int plate)
{
  const PlateCoordinates coordinates(points.lattice().box());
  for (std::size_t i = 0, number[2] = {0, 0}; i < cutouts.cracks.size(); ++i)
  {
    const auto &crack = cutouts.cracks[i];
    if (points.sever([&](const Vector3 &p, const Vector3 &q)
                     { return severs(crack, coordinates.of(p), coordinates.of(q)); }) == 0.)
      throw InputError(
          entry(plate, crack.normal == 0 ? "Crack across" : "Crack along", number[crack.normal]) +
          " crosses no bond that is not broken yet. Move it into the plate, apart "
          "from holes, notches and other cracks, or leave it out.");
    ++number[crack.normal];
  }
}
} // namespace ricochet
