// SPDX-License-Identifier: LGPL-2.1-or-later
// Plane waves in an infinite lattice of points or mesh of cubes: their frequencies, and from the
// largest of them the stable time step, without running anything.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/peridynamics/stencil.h"

#include <vector>

namespace ricochet
{
/// A wave u exp(i k.X) has omega^2 u = D(k) u; D is real, because every bond has its opposite.
using WaveMatrix = Eigen::Matrix3d; // [1/s^2]

/// D = 1/m [ sum_bonds 2 c (1 - cos k.xi) n n^T + 2 a g g^T ], g = sum_bonds 2 d sin(k.xi) n, over
/// the forward half of a family; c, d: tension and dilatation per extension, a: energy per theta^2.
/// Silling 2000 and Silling et al. 2007, linearised.
class LatticeDispersion
{
public:
  /// Density [kg/m^3], bulk and shear modulus [Pa].
  LatticeDispersion(const Stencil &stencil, const BondLaw &law, double density, double bulk_modulus,
                    double shear_modulus);

  /// D for a wave vector in units of 1/spacing [-].
  WaveMatrix matrix(const Vector3 &k) const;
  /// Over all wave vectors [1/s^2].
  double largest_squared_frequency() const;

private:
  struct Bond
  {
    Vector3 offset, unit;         // [spacings], [-]
    double stiffness, dilatation; // [1/s^2] per extension, [1/spacing]
  };
  std::vector<Bond> bonds_;
  double volumetric_; // of g g^T [1/s^2]
};

/// The same of a mesh of cubes with lumped mass, as FiniteElementBody computes it.
class ElementDispersion
{
public:
  /// `edge` of the cubes [m].
  ElementDispersion(double edge, const FiniteElementMaterial &material, Quadrature quadrature,
                    double hourglass_coefficient = 1.);

  /// D for a wave vector in units of 1/edge [-].
  WaveMatrix matrix(const Vector3 &k) const;
  /// Over all wave vectors [1/s^2].
  double largest_squared_frequency() const;
  /// Of a free block of n x n x n cubes, in which edges and corners have less mass [1/s^2]. Exact,
  /// by a dense solution; with 4 cubes the step is at most 2 % below that of a large block, with 3
  /// it is 4 %.
  double largest_squared_frequency_of_block(int n = 4) const;

private:
  Eigen::Matrix<double, 24, 24> stiffness_; // over the mass of a cube; 3 corner + component [1/s^2]
};

/// What theory says about the largest stable step 2/omega of a body, without contact [s]. Of points
/// and of elements each by themselves: safe for the calibrated energy blend, but up to a quarter
/// too large for the others, which have both in the overlap (doc/stability.md).
struct PredictedTimeStep
{
  double points;   // of the infinite lattice; free faces and broken bonds only make it larger
  double elements; // of a free block of the smallest cubes; infinite without elements
  /// The smaller of both [s].
  double step() const { return points < elements ? points : elements; }
};

/// `far` is null for a body of points alone. The corrected mass beside the zone is left out; it
/// takes up to 3 %.
PredictedTimeStep predicted_time_step(const PeridynamicBody &points,
                                      const CoupledPlateOptions *far = nullptr);
} // namespace ricochet
