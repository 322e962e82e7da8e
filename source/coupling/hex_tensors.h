// SPDX-License-Identifier: LGPL-2.1-or-later
// A cube with a stiffness tensor of its own at each Gauss point, under all six unit strains at
// once. Forces in units of M h^2, stiffness in those of M = K + 4 mu/3.
#pragma once

#include "ricochet/coupling/cell_forces.h"
#include "ricochet/finite_elements/element_stiffness.h"

#include <vector>

namespace ricochet
{
using Matrix6 = Eigen::Matrix<double, 6, 6>;

StiffnessTensor packed(const Matrix6 &m);
Matrix6 unpacked(const StiffnessTensor &t);
/// y += factor x
void add(double factor, const StiffnessTensor &x, StiffnessTensor &y);
/// Of a material without branches, in units of M.
Matrix6 cubic_stiffness(const ElasticModuli &moduli, const CubicAnisotropy &anisotropy);

/// Forces at nodes under each of the unit strains; zero at first.
struct NodalForces : std::vector<StrainForces>
{
  explicit NodalForces(std::size_t n = 0);
};

/// Adds the forces of a cube with these tensors to those of its corners: f_a -= integral of B_a^T C
/// e over the cube.
void add_cube_forces(const GaussPointTensors &tensors, const std::array<int, 8> &corner,
                     NodalForces &forces);
/// Minus the transpose of add_cube_forces(): how f . f/2 falls with each entry of the tensors.
GaussPointTensors descent(const NodalForces &forces, const std::array<int, 8> &corner);
} // namespace ricochet
