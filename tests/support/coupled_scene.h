// SPDX-License-Identifier: LGPL-2.1-or-later
// The small impact of the other tests on a plate that is peridynamic around the entry point only.
#pragma once

#include "support/small_scene.h"

namespace ricochet::tests
{
inline Scene coupled_scene()
{
  Scene scene                  = small_scene();
  scene.plates[0].length       = 40e-3;
  scene.plates[0].width        = 24e-3;
  scene.plates[0].thickness    = 8e-3;
  scene.plates[0].zone_boxes   = {{2e-3, 28e-3, -8e-3, 8e-3}};
  scene.zone.kind              = ZoneKind::boxes;
  scene.zone.coarsening_levels = 0;
  return scene;
}
} // namespace ricochet::tests
