// SPDX-License-Identifier: LGPL-2.1-or-later
// The hot loops of a mesh of eight-node cubes, total Lagrangian: with F = dx/dX, E = (F^T F - 1)/2
// and S = lambda tr(E) 1 + 2 mu E (St Venant-Kirchhoff; mu may be another one for shear along the
// axes of the cubes than for their normal strains) or S = C : E, the energy of an element is the
// sum over its quadrature points of w/2 S : E; forces are minus its gradient, hence conservative
// and free of net force and moment at any rotation. If the shear stiffness relaxes,
//   S = C : E - C_mu : sum_k lambda_k E_b,k,
// with C_mu the part of C that relaxes (2 mu times the deviator, or a tensor of its own) and E_b,k
// the strain that the dashpot of branch k has taken over, see materials/maxwell_branch.h.
// Numbers in, numbers out; this header is compiled for several instruction sets and must stay free
// of library headers.
#pragma once

#include "ricochet/materials/maxwell_branch.h"

#include <stdint.h>

namespace ricochet
{
/// Fields of a mesh; per node three numbers in a row (x, y, z), per element one.
struct HexArrays
{
  const double *position;   // current [m]
  double *force;            // [N], added to
  double *strain_energy;    // per element [J], overwritten, only if asked for
  double *hourglass_energy; // the same [J]
};

/// Eight cubes side by side, axis-aligned in the reference configuration. Entries of the lanes
/// beyond the last element must be those of an element that exists: they are read, not written.
struct HexBlock
{
  int32_t entry[8][8]; // [corner][lane]: 3 * local node; corner = x + 2 y + 4 z of the unit cube
  double edge[8];      // h in the reference configuration [m]
};

/// An own stiffness of each Gauss point, C in S_i = C_ij e_j with e = (E11, E22, E33, 2 E23, 2 E13,
/// 2 E12): upper triangle, row by row. Gauss points in the order of the corners they are next to.
struct HexTensors
{
  static constexpr int n_entries = 21; // of an upper triangle of 6 x 6
  double c[8][n_entries][8];           // [Gauss point][entry][lane] [Pa]
};

/// Elements of one kind; `element` of HexArrays counts from 0 in each group.
struct HexGroup
{
  const HexBlock *blocks;    // of eight elements each
  const HexTensors *tensors; // per block; null: all have these moduli
  int64_t n_elements;        // in all blocks; the last may not be full
  double lambda;             // C12 [Pa]
  double mu_tetragonal;      // (C11 - C12)/2 [Pa]
  double mu_diagonal;        // C44 [Pa]
  /// Stiffness of the hourglass modes, k = coefficient * edge, in the energy k/2 |q|^2, q = sum_a
  /// Gamma_a x_a with Gamma_a = +-1: for the three bending and twisting vectors (st) and for the
  /// warping one (rst) [Pa]. One-point elements only.
  double hourglass_bending;
  double hourglass_warping; // of rst [Pa]
};

/// The history of a group of elements whose shear stiffness relaxes.
struct HexRelaxation
{
  int n_branches;              // of the series
  const MaxwellStep *branches; // one each
  /// Per block and Gauss point (one or eight) rows of eight lanes: six of 2 E one step ago, then
  /// six of 2 (E - E_b,k) for each branch, in the order 11, 22, 33, 23, 13, 12 [-].
  double *history;
  const HexTensors *shear; // C_mu of elements with own tensors, per block; otherwise null
  double *dissipated;      // per element, added to [J]
};

struct HexKernel
{
  /// Adds to the forces.
  using ForceLoop         = void (*)(const HexArrays &, const HexGroup &);
  /// The same with history.
  using RelaxingForceLoop = void (*)(const HexArrays &, const HexGroup &, const HexRelaxation &);

  const char *instruction_set; // that the loops are compiled for

  /// One quadrature point, with Flanagan and Belytschko's (1981) hourglass control in its stiffness
  /// form. On a cube their hourglass vectors are the four products of corner coordinates.
  ForceLoop one_point;
  ForceLoop one_point_and_energy; // and both energies of each element
  /// 2 x 2 x 2 Gauss points, lambda and mu.
  ForceLoop integrated;
  ForceLoop integrated_and_energy; // and both energies of each element
  /// 2 x 2 x 2 Gauss points, each with its own stiffness.
  ForceLoop own_tensors;
  ForceLoop own_tensors_and_energy; // and both energies of each element
  /// The same with relaxation; each call moves the history on by one step.
  RelaxingForceLoop relaxing_one_point;
  RelaxingForceLoop relaxing_one_point_and_energy; // and both energies of each element
  /// As integrated, with relaxation.
  RelaxingForceLoop relaxing_integrated;
  RelaxingForceLoop relaxing_integrated_and_energy; // and both energies of each element
  /// As own_tensors, with relaxation.
  RelaxingForceLoop relaxing_own_tensors;
  RelaxingForceLoop relaxing_own_tensors_and_energy; // and both energies of each element

  /// Kick and drift of n components: v += kick f/m, x += drift v; where the inverse mass is zero,
  /// the velocity stays.
  void (*advance)(double *position, double *velocity, const double *force,
                  const double *inverse_mass, int64_t n, double kick, double drift);
};

/// The kernel for the best instruction set of this processor, or for the one named ("avx512",
/// "avx2", "baseline"); null if the processor lacks it.
const HexKernel *hex_kernel(const char *instruction_set = nullptr);
} // namespace ricochet
