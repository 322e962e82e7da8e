// SPDX-License-Identifier: LGPL-2.1-or-later
// The rows of a section 'Plate N' that say what the plate lacks from the start: holes, notches,
// cracks.
#pragma once

#include "ricochet/scene/scene.h"
#include "section.h"

#include <array>

namespace ricochet
{
class CutoutRows
{
public:
  /// The plate and the scene must outlive this object, and this object the section's checks.
  CutoutRows(PlateParameters &plate, const Scene &scene) : plate_(plate), scene_(scene) {}

  void add_to(Section &in);
  /// Into the plate what is given. Throws InputError if it is empty or misses the plate.
  void read();
  /// Throws InputError if it needs points where there are none, or is not symmetric in a symmetric
  /// scene.
  void check_with_others() const;

private:
  /// A row that may be given twice.
  template <class Cutout>
  struct Row
  {
    Cutout value;
    const Entry *entry;
  };

  PlateParameters &plate_;
  const Scene &scene_;
  std::array<Row<Cutouts::Hole>, 2> holes_    = {};
  std::array<Row<Cutouts::Notch>, 2> notches_ = {};
  std::array<Row<Cutouts::Crack>, 4> cracks_  = {}; // two across, two along the flight
};
} // namespace ricochet
