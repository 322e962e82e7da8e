// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hex_tensors.h"

#include "ricochet/base/voigt.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// dN_a/dX_d times the edge, at the Gauss points.
struct Gradients
{
  double n[8][8][3]; // [Gauss point][corner][direction]

  Gradients()
  {
    const double at = 1. / std::sqrt(3.);
    for (int g = 0; g < 8; ++g)
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d)
        {
          double value = (a >> d) & 1 ? 1. : -1.;
          for (int o = 0; o < 3; ++o)
            if (o != d)
              value *= 0.5 * (1. + ((a >> o) & 1 ? 1. : -1.) * ((g >> o) & 1 ? at : -at));
          n[g][a][d] = value;
        }
  }
};
const Gradients gradients;

constexpr double gauss_weight = 0.125; // of the cube's volume
} // namespace

StiffnessTensor packed(const Matrix6 &m)
{
  StiffnessTensor t;
  for (int i = 0, k = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      t[k++] = m(i, j);
  return t;
}

Matrix6 unpacked(const StiffnessTensor &t)
{
  Matrix6 m;
  for (int i = 0, k = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      m(i, j) = m(j, i) = t[k++];
  return m;
}

void add(const double factor, const StiffnessTensor &x, StiffnessTensor &y)
{
  for (int k = 0; k < HexTensors::n_entries; ++k)
    y[k] += factor * x[k];
}

Matrix6 cubic_stiffness(const ElasticModuli &moduli, const CubicAnisotropy &anisotropy)
{
  const double modulus    = moduli.bulk + 4. / 3. * moduli.shear;
  const double tetragonal = anisotropy.tetragonal * moduli.shear;
  Matrix6 C               = Matrix6::Zero();
  C.topLeftCorner<3, 3>().setConstant((moduli.bulk - 2. / 3. * tetragonal) / modulus);
  for (int i = 0; i < 6; ++i)
    C(i, i) +=
        (voigt::is_shear(i) ? anisotropy.diagonal * moduli.shear : 2. * tetragonal) / modulus;
  return C;
}

NodalForces::NodalForces(const std::size_t n) :
  std::vector<StrainForces>(
      n, StrainForces{StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()})
{
}

void add_cube_forces(const GaussPointTensors &tensors, const std::array<int, 8> &corner,
                     NodalForces &forces)
{
  StrainForces f[8];
  for (auto &at_corner : f)
    at_corner = {StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()};
  for (int g = 0; g < 8; ++g)
  {
    StrainLanes row[6];
    for (auto &lanes : row)
      lanes.setZero();
    for (int i = 0, k = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j, ++k)
        row[i][j] = row[j][i] = tensors[g][k];
    for (int a = 0; a < 8; ++a)
    {
      const double *n = gradients.n[g][a];
      for (int c = 0; c < 3; ++c)
        f[a][c] += row[voigt::number[c][0]] * n[0] + row[voigt::number[c][1]] * n[1] +
                   row[voigt::number[c][2]] * n[2];
    }
  }
  for (int a = 0; a < 8; ++a)
    for (int c = 0; c < 3; ++c)
      forces[corner[a]][c] -= gauss_weight * f[a][c];
}

GaussPointTensors descent(const NodalForces &forces, const std::array<int, 8> &corner)
{
  GaussPointTensors slope;
  for (int g = 0; g < 8; ++g)
  {
    StrainLanes s[6];
    for (auto &lanes : s)
      lanes.setZero();
    for (int a = 0; a < 8; ++a)
    {
      const auto &f   = forces[corner[a]];
      const double *n = gradients.n[g][a];
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          s[voigt::number[c][d]] += n[d] * f[c];
    }
    for (int m = 0, k = 0; m < 6; ++m)
      for (int n = m; n < 6; ++n, ++k)
        slope[g][k] = gauss_weight * (m == n ? s[m][n] : s[m][n] + s[n][m]);
  }
  return slope;
}
} // namespace ricochet
