// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/cell_forces.h"

#include "ricochet/base/voigt.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
/// The shape function of a corner at the centre of a sub-cube, n along an edge.
double shape(const int corner, const std::array<int, 3> &sub_cube, const int n)
{
  double value = 1.;
  for (int d = 0; d < 3; ++d)
  {
    const double at = (sub_cube[d] + 0.5) / n;
    value *= (corner >> d) & 1 ? at : 1. - at;
  }
  return value;
}

int cells_for(const int points, const Zone &zone)
{
  return (points + zone.points_per_edge() - 1) / zone.points_per_edge();
}
} // namespace

int mending_range(const Stencil &stencil)
{
  return static_cast<int>(std::ceil(2. * stencil.horizon / stencil.spacing - 1e-9));
}

CellPattern cell_pattern(const Zone &zone, const Zone::Cell &cell, const Stencil &stencil,
                         const bool mirrored, const bool alike)
{
  // What a cell's bonds do depends on the cells that they reach, and on faces that the bonds of
  // their ends reach. Its tensor depends on its neighbours, which do the same: once more the reach,
  // and for the faces once more the range over which nodes are mended.
  const int reach  = stencil.reach;
  const int around = cells_for(alike ? reach : 2 * reach, zone),
            faces  = cells_for(mending_range(stencil) + (alike ? 0 : 2 * reach), zone);
  CellPattern pattern;
  const auto add = [&](const int value)
  { pattern.push_back(static_cast<char>(static_cast<unsigned char>(value))); };
  for (int i = -around; i <= around; ++i)
    for (int j = -around; j <= around; ++j)
      for (int k = -around; k <= around; ++k)
      {
        Zone::Cell other{cell[0] + i, cell[1] + j, cell[2] + k};
        if (mirrored && other[1] < 0)
          other[1] = -1 - other[1];
        add(zone.contains(other) ? zone.layer(other) : 255);
      }
  for (int d = 0; d < 3; ++d)
  {
    add(mirrored && d == 1 ? faces : std::min(faces, cell[d]));
    add(std::min(faces, zone.n_cells()[d] - 1 - cell[d]));
  }
  return pattern;
}

CellForces::CellForces(const PeridynamicBody &points, const ElasticModuli &moduli) :
  lattice_(points.lattice()), has_dilatation_(points.material().law->has_dilatation),
  bulk_stress_(0.)
{
  const auto &stencil = lattice_.stencil();
  const auto family   = family_constants(stencil, moduli.bulk, moduli.shear);
  for (std::size_t k = 0; k < stencil.offsets.size(); ++k)
    for (const int sign : {1, -1})
    {
      const auto &o      = stencil.offsets[k];
      const auto c       = points.material().law->bond(family, o.length, o.omega);
      const Vector3 unit = Vector3(sign * o.x, sign * o.y, sign * o.z) * stencil.spacing / o.length;
      Bond bond{{sign * o.x, sign * o.y, sign * o.z},
                unit,
                StrainLanes::Zero(),
                c.dilatation,
                c.volumetric,
                c.extension,
                points.bond_constants()[k].extension};
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
          bond.extension[voigt::number[i][j]] = unit[i] * unit[j] * o.length;
      bulk_stress_ += bond.full_stiffness * o.length;
      bonds_.push_back(bond);
    }
}

const CellForces::Entry &CellForces::of(const Zone::Cell &cell, const CellPattern &pattern)
{
  auto entry = entries_.find(pattern);
  if (entry == entries_.end())
    entry = entries_.emplace(pattern, computed(cell)).first;
  return entry->second;
}

CellForces::Entry CellForces::computed(const Zone::Cell &cell)
{
  Entry entry;
  for (auto &corner : entry.corner)
    corner = {StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()};
  double stress = 0.;
  const int n   = lattice_.zone()->points_per_edge();
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
      {
        const auto force = point_force({n * cell[0] + x, n * cell[1] + y, n * cell[2] + z}, stress);
        for (int a = 0; a < 8; ++a)
          for (int c = 0; c < 3; ++c)
            entry.corner[a][c] += shape(a, {x, y, z}, n) * force[c];
      }
  entry.stress_share = stress / (n * n * n * bulk_stress_);
  return entry;
}

StrainForces CellForces::point_force(const std::array<int, 3> &point, double &stress)
{
  StrainForces force{StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()};
  const double own        = lattice_.zone()->weight(point[0], point[1], point[2]);
  const StrainLanes theta = own * dilatation(point);
  for (const auto &bond : bonds_)
  {
    std::array<int, 3> other;
    const double weight = weight_at(point, bond, other);
    // Beyond the plate's faces the elements lack nothing either.
    const double share  = 0.5 * (own + std::max(weight, weight < 0. ? own : 0.));
    stress += share * bond.full_stiffness * bond.extension.head<3>().sum();
    if (weight < 0. || own + weight <= 0.)
      continue;
    StrainLanes tension = bond.stiffness * share * bond.extension;
    // The dilatation of an image under 23 and 12 is minus that of its original; but near the plane
    // these strains dilate nothing.
    if (has_dilatation_)
      tension += bond.volumetric * (theta + weight * dilatation(other));
    for (int d = 0; d < 3; ++d)
      force[d] += tension * bond.unit[d];
  }
  return force;
}

double CellForces::weight_at(const std::array<int, 3> &point, const Bond &bond,
                             std::array<int, 3> &other) const
{
  const auto &box = lattice_.box();
  for (int d = 0; d < 3; ++d)
  {
    other[d] = point[d] + bond.offset[d];
    if (box.mirror_y && d == 1 && other[d] < 0)
      other[d] = -1 - other[d];
    if (other[d] < 0 || other[d] >= box.n[d])
      return -1.;
  }
  return lattice_.zone()->weight(other[0], other[1], other[2]);
}

/// Of a point with all its bonds inside the plate; depends only on how near the faces are.
const StrainLanes &CellForces::dilatation(const std::array<int, 3> &point)
{
  const auto &box = lattice_.box();
  const int reach = lattice_.stencil().reach;
  int low[3], high[3], key = 0;
  for (int d = 0; d < 3; ++d)
  {
    low[d]  = box.mirror_y && d == 1 ? reach : std::min(reach, point[d]);
    high[d] = std::min(reach, box.n[d] - 1 - point[d]);
    key     = (key * (reach + 1) + low[d]) * (reach + 1) + high[d];
  }
  const auto [entry, is_new] = dilatations_.emplace(key, StrainLanes::Zero());
  if (is_new)
    for (const auto &bond : bonds_)
    {
      bool inside = true;
      for (int d = 0; d < 3; ++d)
        inside = inside && bond.offset[d] >= -low[d] && bond.offset[d] <= high[d];
      if (inside)
        entry->second += bond.dilatation * bond.extension;
    }
  return entry->second;
}
} // namespace ricochet
