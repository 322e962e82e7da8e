// SPDX-License-Identifier: LGPL-2.1-or-later
// The menu of friction laws: one line each.
#pragma once

#include "ricochet/base/law_list.h"
#include "ricochet/contact/constant_friction.h"
#include "ricochet/contact/exponential_friction.h"
#include "ricochet/contact/flash_heating_friction.h"
#include "ricochet/contact/hyperbolic_friction.h"

namespace ricochet
{
/// All of them, in the order in which they are listed to the user.
// clang-format off
using FrictionLaws = LawList<FrictionLaw,
  ExponentialFriction,
  ConstantFriction,
  FlashHeatingFriction,
  HyperbolicFriction>;
// clang-format on

/// The constants of one law, ConstantFriction::Parameters{0.2}.
using FrictionParameters = FrictionLaws::Parameters;

/// The law whose constants these are.
inline std::unique_ptr<FrictionLaw> make_friction_law(const FrictionParameters &parameters)
{
  return FrictionLaws::make(parameters);
}
} // namespace ricochet
