// SPDX-License-Identifier: LGPL-2.1-or-later
// The menu of bond laws: one line each. Included by the kernels, so no library headers here.
#pragma once

#include "ricochet/materials/linear_peridynamic_solid.h"
#include "ricochet/materials/microelastic_brittle.h"

/// Calls LAW(name of the struct) for each law; the order numbers them.
#define RICOCHET_BOND_LAWS(LAW)                                                                    \
  LAW(LinearPeridynamicSolid)                                                                      \
  LAW(MicroelasticBrittle)
