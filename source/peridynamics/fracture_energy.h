// SPDX-License-Identifier: LGPL-2.1-or-later
// Strain energy set free by breaking bonds: the energy of the body with the bonds of the last step
// minus the energy without them. An independent entry of the energy balance, not what is left over.
//
// The leapfrog scheme conserves v-.v+/2 + U(x_n) between the steps, and with it the bilinear form
// U(x_n, x_n-1) of the bonds that are still there. A bond that breaks at step n therefore takes k
// e_n e_n-1 / 2 out of the balance and not k e_n^2 / 2; with steps in which a bond stretches by a
// fifth of its limit the difference is a fifth of the fracture energy. The springs of Maxwell
// branches go the same way, with e - e_b for e.
#pragma once

#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/peridynamics/plane_archive.h"

#include <array>
#include <vector>

namespace ricochet
{
class FractureEnergy
{
public:
  /// `body` must outlive this object; that it is complete is not asked for before record().
  explicit FractureEnergy(const PeridynamicBody &body);

  /// Adds what the last break_bonds() of the body has broken; `dt` is the step that led there [s].
  void record(double dt);

  /// Energy released so far [J], and bonds broken so far, each once; of the half that is computed.
  /// Collective.
  struct Total
  {
    double energy, n_bonds;
  };
  /// Up to the last record().
  Total total(MPI_Comm communicator) const;

  /// The body's planes have moved to other ranks. Collective.
  void redistribute(MPI_Comm communicator);
  /// Saves or restores what has been released. Collective.
  void exchange_state(PlaneArchive &planes) { planes.sums("fracture energy, bond ends", sums_); }

private:
  /// What a broken bond held of an owned point's theta.
  struct LostTheta
  {
    std::ptrdiff_t point;
    double now, before;                                   // at this step and one step ago [-]
    std::array<double, max_maxwell_branches> held_before; // by its branches, one step ago [-]

    void operator+=(const LostTheta &other);
  };
  /// The `number`-th bond of the log, k from p to q.
  void record_bond(std::ptrdiff_t p, std::ptrdiff_t q, std::size_t k, std::size_t number,
                   double dt);
  void record_theta(const LostTheta &lost);

  const PeridynamicBody &body_;
  PlaneSums<2> sums_;                 // energy [J], bond ends
  std::vector<LostTheta> lost_theta_; // of owned points, per bond
};
} // namespace ricochet
