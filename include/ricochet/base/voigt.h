// SPDX-License-Identifier: LGPL-2.1-or-later
// Six numbers instead of a symmetric 3 x 3 matrix, in one order for all of the program:
//   11, 22, 33, 23, 13, 12                                        (Voigt 1910)
// A strain in this notation has engineering shear, e = (E11, E22, E33, 2 E23, 2 E13, 2 E12), a
// stress has not, so that their product is the work s . e = S : E. Kernels must stay free of this
// header and follow the same order (kernels/hex_kernel.h).
#pragma once

namespace ricochet::voigt
{
constexpr int n            = 6; // components
/// Row and column of each of the six; row <= column.
constexpr int row[n]       = {0, 1, 2, 1, 0, 0};
constexpr int column[n]    = {0, 1, 2, 2, 2, 1}; // see row
/// Position of a component among the six: number[i][j] = number[j][i].
constexpr int number[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
/// 23, 13, 12.
constexpr bool is_shear(const int k)
{
  return k >= 3;
}
} // namespace ricochet::voigt
