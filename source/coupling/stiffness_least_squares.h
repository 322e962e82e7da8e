// SPDX-License-Identifier: LGPL-2.1-or-later
// The smallest change of the elements' tensors, in the sense of least squares, that makes the nodal
// forces under the unit strains vanish, with no tensor negative.
//
// The method: nonlinear conjugate gradients with the share of Polak and Ribiere (1969, Revue
// francaise d'informatique et de recherche operationnelle 3, 35-43), never negative (Gilbert and
// Nocedal 1992, SIAM Journal on Optimization 2, 21-42), on the normal equations, matrix-free. After
// a few steps each tensor is projected on those without negative eigenvalues, a convex set, and
// only tensors near forces that are too large take part.
#pragma once

#include "calibrated_elements.h"

#include "ricochet/coupling/calibration.h"

namespace ricochet
{
class StiffnessLeastSquares
{
public:
  struct Start
  {
    std::vector<GaussPointTensors> tensors; // per element, in units of M
    std::vector<char> kept; // per element: surroundings and tensors are those of the last time
    NodalForces residual;   // of the tensors
  };

  /// `system` must outlive this object.
  StiffnessLeastSquares(MPI_Comm communicator, const CalibratedElements &system, Start &&start,
                        const CalibrationOptions &options);

  /// Fills the report. Collective.
  void solve(CalibrationReport &report);

  const std::vector<GaussPointTensors> &tensors() const { return tensors_; }

private:
  void choose_active();
  void next_direction();
  int conjugate_gradient_steps(int n_steps);
  double project();
  bool project(int element, GaussPointTensors &change, double &smallest);
  void add_to_residual(double factor, const NodalForces &forces);
  double product(const std::vector<GaussPointTensors> &x,
                 const std::vector<GaussPointTensors> &y) const;

  MPI_Comm communicator_;
  const CalibratedElements &system_;
  CalibrationOptions options_;
  std::vector<GaussPointTensors> tensors_;
  std::vector<char> kept_;
  NodalForces residual_;
  std::vector<int> active_; // elements that change
  // Per element; zero but for active ones.
  std::vector<GaussPointTensors> slope_, last_slope_, direction_;
  double squared_slope_ = 0.;
  int n_directions_     = 0;
};
} // namespace ricochet
