// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hexahedron.h"

#include "ricochet/base/exceptions.h"

#include <string>

namespace ricochet
{
Hexahedron::Hexahedron(const HexSolid &solid, const int cell, const double hourglass_stiffness)
{
  const CellIntegrals sum = integrals(solid, cell);
  if (!(sum.volume > 0.) || !(sum.shape.minCoeff() > 0.))
    throw InputError("Hexahedron " + std::to_string(cell + 1) +
                     " of the mesh is folded: its volume or a part of it is not positive.\n  "
                     "Mesh the body again with better elements.");
  volume      = sum.volume;
  gradient    = sum.gradient / sum.volume;
  node_volume = sum.shape;

  constexpr int axes[7] = {1, 2, 4, 6, 5, 3, 7}; // bits of r, s, t, st, rt, rs, rst
  for (int m = 0; m < 7; ++m)
    for (int a = 0; a < 8; ++a)
    {
      mode(a, m) = 1.;
      for (int d = 0; d < 3; ++d)
        if ((axes[m] >> d) & 1)
          mode(a, m) *= (a >> d) & 1 ? 1. : -1.;
    }
  Eigen::Matrix<double, 3, 8> X;
  for (int a = 0; a < 8; ++a)
    X.col(a) = solid.nodes[solid.cells[cell][a]];
  for (int alpha = 0; alpha < 4; ++alpha)
    reference.col(alpha) = X * mode.col(3 + alpha);
  // E h/48 and E h/144 on a cube, where V B : B = 3 h/2.
  const double size = volume * gradient.squaredNorm() / 1.5;
  bending           = hourglass_stiffness * size / 48.;
  warping           = hourglass_stiffness * size / 144.;
}

Eigen::Matrix<double, 24, 24> Hexahedron::stiffness(const double lambda, const double mu,
                                                    const double share) const
{
  // gamma_alpha,a = Gamma_alpha,a - B_a . sum_b Gamma_alpha,b X_b
  const Eigen::Matrix<double, 8, 4> gamma = mode.rightCols<4>() - gradient * reference;
  const Eigen::RowVector4d k(bending, bending, bending, warping);
  Eigen::Matrix<double, 24, 24> K;
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b)
    {
      const Vector3 A = gradient.row(a), B = gradient.row(b);
      const double shear     = share * volume * mu * A.dot(B);
      const double hourglass = (gamma.row(a).cwiseProduct(gamma.row(b))).dot(k);
      K.block<3, 3>(3 * a, 3 * b) =
          share * volume * (lambda * A * B.transpose() + mu * B * A.transpose()) +
          (shear + hourglass) * Eigen::Matrix3d::Identity();
    }
  return K;
}
} // namespace ricochet
