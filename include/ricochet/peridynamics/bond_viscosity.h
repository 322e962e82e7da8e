// SPDX-License-Identifier: LGPL-2.1-or-later
// The viscous memory of one peridynamic body whose shear modulus relaxes.
//
// The energy of a linear peridynamic solid is K theta^2/2 and mu times a quadratic form Q of the
// extensions of a point's bonds,
//   Q(e) = (15/2m) sum omega e^2 V - (5/6) theta^2,   theta = (3/m) sum omega |xi| e V.
// With relaxation it is K theta^2/2 + mu_inf Q(e) + sum_k mu_k Q(e - e_b,k), each bond having its
// own back-extensions e_b,k. Their deviatoric part, e_b - theta_b |xi|/3 with theta_b = (3/m) sum
// omega |xi| e_b V, obeys the same equation as e_b because that is linear, so the published model
// for the directed deviatoric extension (Mitchell 2011) needs one number per undirected bond and
// branch, and theta_b, a sum over bonds, one per point and branch. The form is never negative, also
// at surfaces and beside broken bonds: so is the dissipation, 2 mu_k Q(e - e_b,k)/theta_k.
//
// A bond that breaks takes its back-extension along: theta_b is the sum over intact bonds. Where
// points have a weight w (near finite elements), theta and theta_b stand for w theta and w theta_b.
#pragma once

#include "ricochet/materials/relaxation.h"
#include "ricochet/peridynamics/bond_history.h"
#include "ricochet/peridynamics/broken_bond_log.h"
#include "ricochet/peridynamics/lattice_state.h"
#include "ricochet/peridynamics/plane_sums.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace ricochet
{
class PlaneArchive;
class PlaneExchange;

class BondViscosity
{
public:
  /// What is measured between two records of the energies, at least: the dissipation is known
  /// exactly in the steps in which it is measured and interpolated between them, because to measure
  /// it costs as much as the force.
  static constexpr int measuring_interval = 8;

  /// `family` with the instantaneous shear modulus; `constants` per offset, without the limit of
  /// breaking. All history zero.
  BondViscosity(const Lattice &lattice, const FamilyConstants &family,
                const std::vector<BondConstants> &constants, const RelaxationSeries &series,
                HistoryPrecision precision, double dt);

  // One evaluation of forces calls, in this order:

  /// Before theta is overwritten: the histories of points move on from the step before; once per
  /// step, however often it is called.
  void begin(const LatticeArrays &arrays);
  /// After bonds were broken and w theta of owned points is complete: takes broken bonds out of
  /// theta_b and fills volumetric() of owned points, which then goes to ghosts and images.
  void close_theta(const LatticeArrays &arrays, const BrokenBondLog &broken);
  /// What theta holds back, of all points [-]; see close_theta().
  double *volumetric() { return volumetric_.data(); }
  /// For the kernel; if this is no step, it leaves the history where it is.
  RelaxingBonds bonds(bool is_step);
  /// After the kernel: with `measured`, adds the points' part to energy and, in a step,
  /// dissipation.
  void end(const LatticeArrays &arrays, bool measured, bool is_step);

  /// Whether the dissipation ought to be measured in the present step.
  bool measurement_is_due() const { return steps_since_measured_ + 1 >= measuring_interval; }

  /// Work that the branches have turned into heat so far [J]. Collective.
  double dissipated(MPI_Comm communicator) const { return dissipated_.total(communicator)[0]; }

  /// Of the series.
  int n_branches() const { return static_cast<int>(branches_.size()); }
  const std::vector<MaxwellStep> &branches() const { return branches_; } // for the time step
  /// g of the bonds that the last close_theta() took out: per bond, in the order of the log and
  /// then of the lanes, one number per branch [m].
  const std::vector<double> &broken() const { return broken_; }
  /// g of theta [-].
  double of_theta(const std::ptrdiff_t point, const int branch) const
  {
    return theta_history_[branch][point];
  }

  /// What a branch holds of an extension e, e - e_b, at the time of e, after the forces of that
  /// step and before the next: of a bond, kept at `point` [m] ...
  double held_of_bond(const std::ptrdiff_t point, const std::size_t offset, const int branch,
                      const double e) const
  {
    return held_before(branches_[branch], e, history_.read(point, offset, branch));
  }
  /// ... and of theta, or w theta [-].
  double held_of_theta(const std::ptrdiff_t point, const int branch, const double theta) const
  {
    return held(branches_[branch], theta, of_theta(point, branch));
  }

  /// Bonds of `chosen` (bits as LatticeArrays::bonds) start from what a step of finite elements
  /// would have left: g = xi . G xi / |xi| with the mean of G at the bond's ends, G = r E_b + (1 -
  /// r
  /// - beta) E of the step before. `history(p, branch)` is G [-], asked at points, ghosts and
  /// images too. theta_b of all points is summed anew, with their weights.
  void take_over(const LatticeArrays &arrays, const std::vector<std::uint8_t> &chosen,
                 const std::function<Eigen::Matrix3d(std::ptrdiff_t, int)> &history);

  /// The lattice's planes are moving to other ranks: takes over what belongs to them. `share`:
  /// the new one. Collective.
  void redistribute(const PlaneExchange &planes, const Lattice &share, MPI_Comm communicator);

  /// Saves or restores the memory. Collective.
  void exchange_state(PlaneArchive &planes);

  /// Memory of the history.
  double bytes_per_point() const;

private:
  void sum_theta(const LatticeArrays &arrays);
  /// xi . G . xi/|xi|
  double along(std::size_t offset, const Eigen::Matrix3d &G) const;
  /// All lanes of blocks with owned points.
  template <class Visitor>
  void for_each_block_point(Visitor &&visit) const
  {
    for (const auto &range : lattice_.owned_ranges())
      for (std::ptrdiff_t p = range.first * Lattice::block_size;
           p < range.last * Lattice::block_size; ++p)
        visit(p);
  }
  void find_losers();
  void take_out(const LatticeArrays &arrays, const BrokenBondLog &broken);
  double extension_before(const LatticeArrays &arrays, std::ptrdiff_t p, std::size_t offset) const;

  const Lattice &lattice_;
  FamilyConstants family_;
  std::vector<BondConstants> constants_;
  std::vector<std::int64_t> shifts_;
  std::vector<MaxwellStep> branches_, halted_branches_;
  double dt_; // [s]
  BondHistory history_;
  std::vector<std::vector<double>> theta_history_; // [branch][point]
  std::vector<double> volumetric_, dissipated_at_; // per point, see RelaxingBonds
  std::vector<double> lost_theta_;     // of bonds just broken, one step ago; per point [-]
  std::vector<std::ptrdiff_t> losers_; // points with an entry there
  std::vector<double> broken_;
  PlaneSums<1> dissipated_;  // [J]
  PlaneSums<1> in_one_step_; // when last measured [J]
  bool first_step_ = true, begun_ = false;
  int steps_since_measured_ = 0;
};
} // namespace ricochet
