// SPDX-License-Identifier: LGPL-2.1-or-later
// Small peridynamic bodies whose broken bonds go on to push, or which flow.
#pragma once

#include "support/body.h"

namespace ricochet::tests
{
/// The body of a sample with more of its material's failure.
inline std::unique_ptr<PeridynamicBody> make_failing_body(const BodySample &sample,
                                                          const FlowLaw &flow                = {},
                                                          const bool cracks_push             = true,
                                                          const RelaxationSeries &relaxation = {})
{
  const auto &law = sample.family.law;
  const PeridynamicMaterial material{&bond_law(law.law),
                                     sample.density_factor * law.density,
                                     law.bulk_modulus,
                                     law.shear_modulus,
                                     sample.critical_stretch,
                                     relaxation,
                                     HistoryPrecision::single_precision,
                                     cracks_push,
                                     flow};
  const Lattice::Box box{sample.corner, sample.spacing, sample.n, sample.mirror_y};
  return std::make_unique<PeridynamicBody>(
      sample.communicator, sample.number, box,
      make_stencil(sample.spacing, sample.family.horizon_ratio, sample.family.influence_function),
      material, sample.mask, sample.instruction_set);
}

/// For PeridynamicBody::sever().
inline bool all_bonds(const Vector3 &, const Vector3 &)
{
  return true;
}
} // namespace ricochet::tests
