// SPDX-License-Identifier: LGPL-2.1-or-later
// What the bonds around a zone do to the nodes of its cells in a uniformly strained plate, all six
// unit strains (11, 22, 33, 23, 13, 12; shear in the engineering sense) at once.
#pragma once

#include "ricochet/peridynamics/peridynamic_body.h"

#include <Eigen/Core>

#include <string>
#include <unordered_map>

namespace ricochet
{
constexpr int n_unit_strains = 6; // in the order of base/voigt.h

/// One number per unit strain; two lanes stay empty.
using StrainLanes  = Eigen::Array<double, 8, 1>;
using StrainForces = std::array<StrainLanes, 3>; // per component of a force

/// The surroundings of a cell in full, one byte per cell around it and per face of the plate: cells
/// with equal patterns have the same layers and faces around, and therefore the same bonds and
/// weights.
using CellPattern = std::string;

/// `mirrored`: the plane y = 0 is none of the faces. `alike` looks less far: for a first guess.
CellPattern cell_pattern(const Zone &zone, const Zone::Cell &cell, const Stencil &stencil,
                         bool mirrored, bool alike = false);

/// A node's force can be mended by elements so near, in grid spacings: two horizons, the way over
/// which a bond and, through the dilatation, those of its ends act.
int mending_range(const Stencil &stencil);

/// Parts of a material's moduli: forces and stiffness are linear in them.
struct ElasticModuli
{
  double bulk;  // K [Pa]
  double shear; // mu [Pa]
};

class CellForces
{
public:
  /// What the bonds of one cell's points do.
  struct Entry
  {
    std::array<StrainForces, 8> corner; // forces [N]
    double stress_share; // of the bonds of the cell's points, of that in the bulk [-]
  };

  /// The points must have a zone and outlive this object.
  CellForces(const PeridynamicBody &points, const ElasticModuli &moduli);

  /// `pattern` of the cell, which lies in the pad or the halo. Remembers what it has computed.
  const Entry &of(const Zone::Cell &cell, const CellPattern &pattern);

private:
  struct Bond
  {
    std::array<int, 3> offset;
    Vector3 unit;
    StrainLanes extension; // under the unit strains [m]
    double dilatation, volumetric, stiffness;
    double full_stiffness; // with all of the moduli [N/m]
  };

  Entry computed(const Zone::Cell &cell);
  StrainForces point_force(const std::array<int, 3> &point, double &stress);
  /// Of the point at an offset from another, both in the plate; images folded back. -1: outside.
  double weight_at(const std::array<int, 3> &point, const Bond &bond,
                   std::array<int, 3> &other) const;
  const StrainLanes &dilatation(const std::array<int, 3> &point);

  const Lattice &lattice_;
  bool has_dilatation_;
  double bulk_stress_; // of a point with all its bonds [N m]
  std::vector<Bond> bonds_;
  std::unordered_map<int, StrainLanes> dilatations_; // by distances to the faces
  std::unordered_map<CellPattern, Entry> entries_;
};
} // namespace ricochet
