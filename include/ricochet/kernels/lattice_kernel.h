// SPDX-License-Identifier: LGPL-2.1-or-later
// The hot loops of a lattice, as a table of plain functions per bond law and instruction set.
// Numbers in, numbers out; this header is compiled for several instruction sets and must stay free
// of library headers.
#pragma once

#include "ricochet/materials/bond_law.h"
#include "ricochet/materials/maxwell_branch.h"

#include <stdint.h>

namespace ricochet
{
/// A lattice's moving fields; arrays are 64-byte aligned, padded as Lattice says, indexed by the
/// flat point index.
struct LatticeArrays
{
  double *position[3];  // current [m]
  double *velocity[3];  // at the half step [m/s]
  double *force[3];     // [N]
  double *theta;        // dilatation [-]
  double *theta_before; // the same one step ago [-]
  double *energy;       // strain energy of the point [J], only if asked for
  uint8_t *bonds;       // one bit per bond, see Lattice::intact_bonds
  uint8_t *cracked;     // likewise: broken bonds that still push; null: none ever does
  const uint8_t *free;  // one bit per point that moves by its own force
  // Of a material that flows, else null:
  const float *plastic;  // plastic extension per bond, [block][offset][lane] [m]
  const uint8_t *flowed; // per block: whether it has any
  double *strained;      // per point: how many of its bonds might make it yield [-]
  // Near an interface to finite elements only, else null:
  double *half_weight; // half the share of a point's energy that counts [-]
  double *hold;        // 0 for free points; 1 for others, whose bonds do not break [-]
};

/// The bonds of any point of a lattice.
struct BondTable
{
  int n;                          // forward offsets
  const int64_t *shift;           // flat index distance
  const BondConstants *constants; // per offset
  double point_stiffness;         // [J], energy of a point per theta^2
  double cracked_share;           // stiffness of a shortened cracked bond over `extension` [-]
  double parting;                 // extension at which a cracked bond is gone for good [m]
  double yield_stretch;           // least of a bond's that may make its ends yield [-]
};

/// What one step did to up to 8 bonds of the same offset.
struct BrokenBonds
{
  int32_t block;  // first point / 8
  int16_t offset; // number in the stencil
  uint8_t broken; // bit l: the bond of point 8 block + l
  uint8_t parted; // likewise: carries nothing from now on
};

/// History of bonds whose shear stiffness relaxes, and the numbers of a step.
struct RelaxingBonds
{
  int n_branches;              // of the series
  const MaxwellStep *branches; // one each
  /// g of each bond and branch, see maxwell_branch.h: [block][offset][branch][lane], in the one or
  /// the other precision, the other null [m].
  float *single_history;
  double *double_history; // see single_history
  /// Per point, ghosts and images too: its part of the tension of any of its bonds, over that
  /// bond's `extension` and length [-].
  const double *volumetric;
  double *dissipated; // per point, in the step before; only with energies [J]
  double dt;          // length of that step [s]
};

/// Bonds that flow, and the numbers of a step; see peridynamics/bond_flow.h. Per point, ghosts and
/// images too, but for the first.
struct FlowingBonds
{
  float *plastic;         // see LatticeArrays
  const double *relaxing; // half the share of the deviatoric part that goes in this step [-]
  const double *mean;     // of u/|xi| over bonds that carry [-]
  // Sums over the bonds, which must be zero before:
  double *carrying;   // of 3 omega |xi|^2 V/m over bonds that carry: 3 in the bulk [-]
  double *sum;        // of 3 omega |xi| u V/m [-]
  double *square;     // of the energy (15 mu/2m) omega u^2 V^2 [J]
  double *dissipated; // so far: added to [J]
  double dt;          // length of the step that led here [s]
};

struct LatticeKernel
{
  const char *instruction_set; // that the loops are compiled for
  int registers_per_block;     // of points

  /// Breaks bonds stretched beyond their limit, unless an end of them is held, lets cracked ones
  /// part, and adds every intact bond's part to theta, which must be zero before. `log` must hold
  /// registers_per_block entries per block and offset; returns how many were written.
  int64_t (*stretch)(const LatticeArrays &, const BondTable &, int64_t first_block,
                     int64_t last_block, BrokenBonds *log);

  /// Adds bond forces to both ends; `force` must be zero before, theta complete.
  void (*force)(const LatticeArrays &, const BondTable &, int64_t first_block, int64_t last_block);

  /// The same and adds each point's strain energy to `energy`, half a bond to either end.
  void (*force_and_energy)(const LatticeArrays &, const BondTable &, int64_t first_block,
                           int64_t last_block);

  /// The same two where points have a weight w: a bond has the mean of its ends', and theta stands
  /// for w theta.
  void (*weighted_force)(const LatticeArrays &, const BondTable &, int64_t first_block,
                         int64_t last_block);
  /// See weighted_force and force_and_energy.
  void (*weighted_force_and_energy)(const LatticeArrays &, const BondTable &, int64_t first_block,
                                    int64_t last_block);

  /// The same four for bonds that relax; move their history on by one step. Null where a law
  /// cannot. Those with energy add the bonds' part of energy and dissipation, half to either end,
  /// and need the velocities that led here.
  using RelaxingLoop = void (*)(const LatticeArrays &, const BondTable &, const RelaxingBonds &,
                                int64_t first_block, int64_t last_block);
  RelaxingLoop relaxing_force;                     // forces alone
  RelaxingLoop relaxing_force_and_energy;          // with energies
  RelaxingLoop weighted_relaxing_force;            // with weights
  RelaxingLoop weighted_relaxing_force_and_energy; // with both

  /// Lets bonds flow, and sums up what their ends carry then; theta must be complete.
  using FlowLoop = void (*)(const LatticeArrays &, const BondTable &, const FlowingBonds &,
                            int64_t first_block, int64_t last_block);
  FlowLoop flow;          // of points without weights
  FlowLoop weighted_flow; // see weighted_force; sums are those of whole bonds

  /// Kick and drift of free points: v += f dt/m, x += v dt.
  void (*advance)(const LatticeArrays &, int64_t first_block, int64_t last_block,
                  double dt_over_mass, double dt);
};

/// The kernel of a law (its number in materials/bond_law_list.h) for the best instruction set of
/// this processor, or for the one named ("avx512", "avx2", "baseline"); null if the processor lacks
/// it.
const LatticeKernel *lattice_kernel(int law, const char *instruction_set = nullptr);
} // namespace ricochet
