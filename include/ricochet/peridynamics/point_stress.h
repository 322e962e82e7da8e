// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress, dilatation and energy density of peridynamic points, for pictures: nothing here enters a
// step. With the bond xi as it is now, y, and a point's own part T<xi> of its tension,
//   tau = (1/V) sum_xi T<xi> y (x) y / |y|,
// the collapsed stress tensor of Silling and Lehoucq 2008 with the bonds of now, symmetric because
// the bond laws here are ordinary. It is the derivative of the point's energy density with respect
// to a homogeneous strain, and V tau of all points together is the virial of the bond forces. In a
// homogeneous deformation it is lambda tr(eps) 1 + 2 mu eps but for the anisotropy of the lattice;
// its trace is 3 K theta exactly while the family is whole. Of a family that has lost bonds, with
// the share r of the weighted volume sum omega |xi|^2 V left, a linear peridynamic solid has
//   tr(tau) = [3 K r + 5 mu (1 - r)] theta:
// beside cracks and surfaces stress is what is left, not what a continuum would have there.
#pragma once

#include "ricochet/base/stress_state.h"
#include "ricochet/peridynamics/peridynamic_body.h"

#include <cstddef>
#include <vector>

namespace ricochet
{
class PointStress
{
public:
  /// `body` must outlive this object.
  explicit PointStress(const PeridynamicBody &body);

  /**
   * Of an owned point that has all bonds it ever had to points whose motion is known: a free one.
   * Ghosts must be up to date; with relaxation the forces of the present step must have been
   * computed, and advance() not. Bonds that are broken do not count unless they push; all others
   * count in full, whatever weight the point's energy has.
   */
  StressState of(std::ptrdiff_t point);

private:
  /// A bond of a point, intact or a crack that is closed.
  struct Bond
  {
    std::size_t offset;   // its number in the stencil
    std::ptrdiff_t first; // the end at which its bit and its history are kept
    Vector3 now;          // y [m]
    double inverse;       // 1/|y| [1/m]
    double extension;     // |y| - |xi| [m]
    double elastic;       // less its plastic part [m]
    bool cracked;
  };
  void find_bonds(std::ptrdiff_t point);
  /// Of the bits of all bonds, or null if there are none.
  bool is_set(const std::uint8_t *const bonds, const std::ptrdiff_t point,
              const std::size_t k) const
  {
    return bonds != nullptr && (bonds[(point / Lattice::block_size) * shifts_.size() + k] >>
                                (point % Lattice::block_size)) &
                                   1;
  }
  /// What the branches take from the elastic answer; all of it times V.
  void relax(std::ptrdiff_t point, StressState &state) const;

  const PeridynamicBody &body_;
  std::vector<std::int64_t> shifts_; // per offset
  std::vector<double> dilatation_;   // per offset: theta per extension, 3 omega |xi| V/m [1/m]
  std::vector<Bond> bonds_;          // of the point in question
};
} // namespace ricochet
