// SPDX-License-Identifier: LGPL-2.1-or-later
// How near two points come before they touch. The lists of pairs and the search must agree on it,
// or pairs are lost.
#pragma once

#include <algorithm>

namespace ricochet
{
/// The largest distance at which any two points touch [m]: 1.35 (r_i + r_j) with radii of half a
/// spacing. The two factors are those of the peridynamic package of LAMMPS, its manual's equation
/// 15 (Parks et al. 2008, doi 10.1016/j.cpc.2008.06.011).
inline double largest_contact_distance(const double spacing)
{
  return 1.35 * spacing;
}

/// Distance below which two points touch [m], given that between them in the reference
/// configuration and the spacing [m]. The factor 0.9 (ibid.) leaves points in place untouched.
inline double contact_distance(const double reference_distance, const double spacing)
{
  return std::min(0.9 * reference_distance, largest_contact_distance(spacing));
}
} // namespace ricochet
