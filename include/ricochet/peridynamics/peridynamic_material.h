// SPDX-License-Identifier: LGPL-2.1-or-later
// What a peridynamic body is made of.
#pragma once

#include "ricochet/materials/bond_laws.h"
#include "ricochet/materials/flow_law.h"
#include "ricochet/materials/relaxation.h"

namespace ricochet
{
struct PeridynamicMaterial
{
  /// How a bond pulls.
  const BondLaw *law;
  double density;          // [kg/m^3]
  double bulk_modulus;     // [Pa]
  double shear_modulus;    // [Pa], the instantaneous one
  double critical_stretch; // s_c [-]; infinite: never breaks
  /// Of the shear modulus; takes effect by PeridynamicBody::start_relaxation().
  RelaxationSeries relaxation        = {};
  /// In which histories are kept.
  HistoryPrecision history_precision = HistoryPrecision::single_precision;
  /// Whether broken bonds resist compression until they part, see BondTables.
  bool cracks_push                   = false;
  /// Takes effect, like relaxation, by PeridynamicBody::start_relaxation().
  FlowLaw flow                       = {};
  /// By which a broken bond is too long once its ends have parted [spacings].
  double parting_extension           = usual_parting_extension;
};
} // namespace ricochet
