// SPDX-License-Identifier: LGPL-2.1-or-later
// Stiffness of the elements around a zone, such that peridynamic points and elements together are
// in equilibrium under any uniform strain, as the plate of elements alone would be.
//
// Peridynamic energy ends gradually: bonds reach out of the zone into the pad and the halo. What is
// missing there to the full stiffness is left to the elements, as a symmetric tensor C_g at every
// Gauss point. Starting from C_g = w C, where w is the share of the bond stress that is missing,
// the smallest change of all C_g (in the sense of least squares) is sought that makes the nodal
// forces under six unit strains those of the plate of elements alone: zero inside, tractions on
// free surfaces. The solution is found by conjugate gradients on the normal equations, matrix-free,
// and made non-negative: a sum of energies none of which is negative cannot become unstable.
//
// "In full" is the lattice's own stiffness, cubic by 0.3 % of the shear modulus, which the elements
// of the plate share: of an isotropic one the difference in traction would have to be carried along
// the whole interface to the plate's faces, and a fine grid would not converge.
//
// Zones grow by the same few shapes again and again. What has been found last for a cell is the
// start for all cells with the same surroundings, and only where that is not good enough is
// anything sought. Cells that have kept their surroundings keep their tensors, whatever grows
// elsewhere: the energy they hold would jump otherwise.
//
// All is linear in the moduli. A material whose shear modulus relaxes needs C_g of what is left in
// the end and of the shear part one by one; if neither is negative, no sum on the way is.
#pragma once

#include "ricochet/coupling/cell_forces.h"
#include "ricochet/coupling/coupling_method.h"
#include "ricochet/finite_elements/finite_element_body.h"

namespace ricochet
{
class CalibratedElements;
struct NodalForces;

/// How well the tensors fit.
struct CalibrationReport
{
  // Largest force at a node under a unit strain, in units of M h^2, M = K + 4 mu/3 [-].
  double ghost_before        = 0.; // of the scaled C alone
  double ghost_after         = 0.; // of what was found
  double smallest_eigenvalue = 0.; // of any C_g before it is made non-negative, if negative [M]
  int n_iterations           = 0;  // of the least squares
  std::int64_t n_elements    = 0;  // with tensors of their own, over all ranks
};

class Calibration
{
public:
  /// The points must have a zone; both must outlive this object.
  Calibration(MPI_Comm communicator, const PeridynamicBody &points,
              const FiniteElementBody &elements, const ElasticModuli &moduli,
              const CalibrationOptions &options);

  /// The tensors of this rank's elements in the pad and halo of the zone as it is now. Collective.
  std::vector<ElementStiffness> find();

  /// Saves or restores what has been found, for the zone as it is now: the next find() takes it.
  /// Collective.
  void exchange_state(StateArchive &archive);

  const CalibrationReport &report() const { return report_; } // of the last find()

private:
  /// What was last found for a cell of this rank.
  struct Present
  {
    CellPattern pattern;
    GaussPointTensors tensors;
  };

  CellPattern pattern(const Zone::Cell &cell, bool alike) const;
  const GaussPointTensors *kept_tensors(std::size_t cell, const CellPattern &pattern) const;
  void find_start(const CalibratedElements &system, std::vector<GaussPointTensors> &tensors,
                  std::vector<char> &kept);
  NodalForces residual_of(const CalibratedElements &system,
                          const std::vector<GaussPointTensors> &tensors);
  void remember(const CalibratedElements &system, const std::vector<GaussPointTensors> &tensors);

  MPI_Comm communicator_;
  const PeridynamicBody &points_;
  const FiniteElementBody &elements_;
  ElasticModuli moduli_;
  CalibrationOptions options_;
  CellForces forces_;
  CalibrationReport report_;
  // By pattern, and by one that is less exact; the same on all ranks [M].
  std::unordered_map<CellPattern, GaussPointTensors> found_, similar_;
  std::unordered_map<std::size_t, Present> present_; // by the cell's number [M]
};
} // namespace ricochet
