// SPDX-License-Identifier: LGPL-2.1-or-later
// The cells of one plate that choices of a zone mean: boxes that were asked for, the corridor of
// the impact, and what the other plates of a stack ask of this one.
#pragma once

#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/coupling/zone_extent.h"
#include "ricochet/scene/scene.h"

namespace ricochet
{
/// Of every projectile on one of the scene's plates, whose upper face lies `depth` below that of
/// the first [m].
std::vector<ImpactOnPlate> impacts_on(const Scene &scene, const PlateParameters &plate,
                                      double depth, double thickness, double horizon);

/// The smallest box around all; without any, an empty one.
Zone::Cells hull(const std::vector<Zone::Cells> &boxes);

class ZoneCells
{
public:
  /// `box`: lattice of the plate. Both must outlive this object.
  ZoneCells(const Scene &scene, const Lattice::Box &box);

  /// A choice is no sharp limit: the nearest cells will do.
  Zone::Cells of(const ZoneChoice &choice) const;
  /// Boxes that were asked for are filled.
  std::vector<Zone::Cells> boxes_of(const PlateParameters &plate) const;
  /// Around holes, notches and cracks: no element may lie there.
  std::vector<Zone::Cells> around_cutouts_of(const PlateParameters &plate) const;
  /// The corridor, or all that a growing zone may become, one box around those of all impacts.
  Zone::Cells widest(const std::vector<ImpactOnPlate> &impacts) const;
  /// Where a plate must be ready to be touched: in a stack, wherever any plate has points or may
  /// get some, those around its zone included. What lay in the other plate before it could be
  /// touched would be thrown out of it.
  Zone::Cells touchable() const;

private:
  Zone::Cells columns(double x_low, double x_high, double y_low, double y_high) const;

  const Scene &scene_;
  const Lattice::Box &box_;
  int edge_; // of a cell, in points
};
} // namespace ricochet
