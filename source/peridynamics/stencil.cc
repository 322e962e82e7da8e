// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/stencil.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
Stencil make_stencil(const double spacing, const double horizon_ratio,
                     const InfluenceFunction influence_function)
{
  if (!(horizon_ratio >= 1. && horizon_ratio <= 8.))
    throw InputError("The horizon ratio is " + std::to_string(horizon_ratio) +
                     "; it must lie between 1 and 8 (3 is usual).");

  Stencil stencil;
  stencil.spacing       = spacing;
  stencil.horizon       = horizon_ratio * spacing;
  stencil.reach         = 0;
  stencil.squared_range = 0;
  const int n           = static_cast<int>(std::floor(horizon_ratio + 1e-6));
  // Offsets that differ only along the contiguous axis y write to overlapping addresses. The outer
  // loop over y keeps such pairs far apart in time, so that the second does not wait for the store
  // of the first.
  for (int y = -n; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
      for (int z = -n; z <= n; ++z)
      {
        if (!(x > 0 || (x == 0 && (z > 0 || (z == 0 && y > 0)))))
          continue;
        const double r     = std::sqrt(double(x * x + y * y + z * z));
        const double ratio = std::min(r / horizon_ratio, 1.);
        const double omega = influence(influence_function, ratio);
        if (r > horizon_ratio * (1. + 1e-6) || omega <= 1e-9)
          continue;
        stencil.offsets.push_back({x, y, z, r * spacing, omega});
        stencil.reach         = std::max({stencil.reach, x, std::abs(y), std::abs(z)});
        stencil.squared_range = std::max(stencil.squared_range, x * x + y * y + z * z);
      }
  return stencil;
}

FamilyConstants family_constants(const Stencil &stencil, const double bulk_modulus,
                                 const double shear_modulus)
{
  const double volume = std::pow(stencil.spacing, 3);
  double m = 0., first = 0.;
  for (const auto &o : stencil.offsets)
  {
    m += 2. * o.omega * o.length * o.length * volume;
    first += 2. * o.omega * o.length * volume;
  }
  return {bulk_modulus, shear_modulus, volume, m, first};
}

double fracture_energy_per_squared_stretch(const Stencil &stencil, const BondLaw &law,
                                           const double bulk_modulus, const double shear_modulus)
{
  // A crack opens the medium normal to its plane, so theta is the stretch 1, and not three times it
  // as under uniform dilation (tests/verification/test_crack_energy.cc measures it). A bond then
  // holds half its tension times its length. An offset (x, y, z) crosses a plane normal to an axis
  // as often per dx^2 as its component along that axis; the mean over the axes is taken, they are
  // equal for a full stencil.
  const FamilyConstants family = family_constants(stencil, bulk_modulus, shear_modulus);
  double sum                   = 0.;
  for (const auto &o : stencil.offsets)
  {
    const BondConstants c = law.bond(family, o.length, o.omega);
    const double crossing = (std::abs(o.x) + std::abs(o.y) + std::abs(o.z)) / 3.;
    sum += crossing * 0.5 * law.tension(c, o.length, /*theta_sum=*/2.) * o.length;
  }
  return sum / (stencil.spacing * stencil.spacing);
}

CubicAnisotropy lattice_anisotropy(const Stencil &stencil, const BondLaw &law,
                                   const double bulk_modulus, const double shear_modulus)
{
  const FamilyConstants family = family_constants(stencil, bulk_modulus, shear_modulus);
  // Stresses under the strains 11 (which dilates) and 12 (in the engineering sense, which does
  // not).
  double c11 = 0., c12 = 0., c44 = 0.;
  for (const auto &o : stencil.offsets)
  {
    const BondConstants c = law.bond(family, o.length, o.omega);
    const double x = o.x * stencil.spacing / o.length, y = o.y * stencil.spacing / o.length,
                 z = o.z * stencil.spacing / o.length, share = o.length / family.volume;
    for (const double normal : {x, y, z}) // the strain; all axes are alike
    {
      const double tension = law.tension(c, normal * normal * o.length, /*theta_sum=*/2.);
      const double own     = normal * normal;
      c11 += share * tension * own / 3.;
      c12 += share * tension * (1. - own) / 6.;
    }
    for (const double shear : {y * z, x * z, x * y})
      c44 += share * law.tension(c, shear * o.length, /*theta_sum=*/0.) * shear / 3.;
  }
  return {0.5 * (c11 - c12) / shear_modulus, c44 / shear_modulus};
}
} // namespace ricochet
