// SPDX-License-Identifier: LGPL-2.1-or-later
// Small bodies of finite elements, how to move them, and the plain formulas to compare them with.
#pragma once

#include "ricochet/finite_elements/finite_element_body.h"
#include "support/random.h"

#include <Eigen/Dense>

#include <cmath>
#include <memory>

namespace ricochet::tests
{
/// E, nu, rho of quasi-static PMMA (verification list of the coupling, V11).
constexpr double pmma_youngs_modulus = 3.3e9, pmma_poisson_ratio = 0.35, pmma_density = 1190.;

inline FiniteElementMaterial elastic(const double E, const double nu, const double density)
{
  return {density, E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu))};
}

inline FiniteElementMaterial pmma()
{
  return elastic(pmma_youngs_modulus, pmma_poisson_ratio, pmma_density);
}

inline double lambda(const FiniteElementMaterial &m)
{
  return m.bulk_modulus - 2. / 3. * m.shear_modulus;
}

/// M = lambda + 2 mu [Pa]
inline double p_wave_modulus(const FiniteElementMaterial &m)
{
  return lambda(m) + 2. * m.shear_modulus;
}

inline double p_wave_speed(const FiniteElementMaterial &m)
{
  return std::sqrt(p_wave_modulus(m) / m.density);
}

/// Irregular but a function of the place alone, hence the same on any rank; components in [-1, 1].
inline Vector3 noise_at(const Vector3 &X, const double length)
{
  const Vector3 c = X / length;
  return {std::sin(12.9898 * c[0] + 78.233 * c[1] + 37.719 * c[2]),
          std::sin(39.3461 * c[0] + 11.135 * c[1] + 83.155 * c[2] + 1.),
          std::sin(73.1564 * c[0] + 52.235 * c[1] + 9.151 * c[2] + 2.)};
}

/// 5 x 4 x 3 cubes of 1 mm; in one corner halved twice, in the opposite one once: three sizes, and
/// hanging nodes on edges and faces, also on the surface.
inline HexMesh::Box refined_box()
{
  const double h = 1e-3;
  return {Vector3(-2e-3, 0., 1e-3),
          h,
          {5, 4, 3},
          false,
          {{Vector3(-2e-3, 0., 1e-3), Vector3(-0.5e-3, 1e-3, 2e-3), 2},
           {Vector3(2e-3, 3e-3, 3e-3), Vector3(3e-3, 4e-3, 4e-3), 1}}};
}

inline Vector3 at(const std::vector<double> &values, const int node)
{
  return {values[3 * node], values[3 * node + 1], values[3 * node + 2]};
}

inline void set(std::vector<double> &values, const int node, const Vector3 &value)
{
  for (int d = 0; d < 3; ++d)
    values[3 * node + d] = value[d];
}

/// Moves every owned node to map(reference position), hanging ones after their masters, and
/// evaluates forces and energies.
template <class Map>
void deform(FiniteElementBody &body, Map &&map)
{
  for (int node = 0; node < body.mesh().n_owned_nodes(); ++node)
    set(body.position(), node, map(body.mesh().reference_position(node)));
  body.update_ghosts();
  body.compute_internal_forces({/*energy=*/true});
}

inline double largest_force(const FiniteElementBody &body)
{
  double largest = 0.;
  for (int node = 0; node < body.mesh().n_owned_nodes(); ++node)
    largest = std::max(largest, at(body.force(), node).norm());
  return largest;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Isotropic C with e = (E11, E22, E33, 2 E23, 2 E13, 2 E12).
inline Matrix6 cubic_tensor(const double lambda, const double tetragonal, const double diagonal)
{
  Matrix6 C             = Matrix6::Zero();
  C.topLeftCorner(3, 3) = Eigen::Matrix3d::Constant(lambda);
  C.diagonal().head(3) += Vector3::Constant(2. * tetragonal);
  C.diagonal().tail(3) = Vector3::Constant(diagonal);
  return C;
}

inline Matrix6 isotropic_tensor(const double lambda, const double mu)
{
  return cubic_tensor(lambda, mu, mu);
}

/// Symmetric, eigenvalues between 0 and about 12 moduli, without any further symmetry.
inline Matrix6 random_tensor(Random &random, const double modulus)
{
  Matrix6 A;
  for (int i = 0; i < 36; ++i)
    A(i / 6, i % 6) = random.uniform();
  return modulus * A * A.transpose();
}

inline std::array<double, HexTensors::n_entries> upper_triangle(const Matrix6 &C)
{
  std::array<double, HexTensors::n_entries> c;
  for (int i = 0, k = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j, ++k)
      c[k] = C(i, j);
  return c;
}

/// One cube by the textbook: shape functions N_a = (1 + r_a r)(1 + s_a s)(1 + t_a t)/8, their
/// gradients at quadrature points, F = sum x_a dN_a/dX, S = C : E, f_a = -sum w F S dN_a/dX.
struct ReferenceElement
{
  Eigen::Matrix<double, 3, 8> force = Eigen::Matrix<double, 3, 8>::Zero(); // [N]
  double strain_energy              = 0.;                                  // [J]
  double hourglass_energy           = 0.;                                  // [J]

  static Vector3 corner(const int a)
  {
    return {a & 1 ? 1. : -1., a & 2 ? 1. : -1., a & 4 ? 1. : -1.};
  }

  void add_point(const Eigen::Matrix<double, 3, 8> &x, const double edge, const Vector3 &point,
                 const double weight, const Matrix6 &C)
  {
    Eigen::Matrix<double, 8, 3> gradient;
    for (int a = 0; a < 8; ++a)
    {
      const Vector3 factor = Vector3::Ones() + corner(a).cwiseProduct(point);
      for (int d = 0; d < 3; ++d)
        gradient(a, d) = corner(a)[d] * factor[(d + 1) % 3] * factor[(d + 2) % 3] / (4. * edge);
    }
    const Eigen::Matrix3d F = x * gradient;
    const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
    Eigen::Matrix<double, 6, 1> e;
    e << E(0, 0), E(1, 1), E(2, 2), 2. * E(1, 2), 2. * E(0, 2), 2. * E(0, 1);
    const Eigen::Matrix<double, 6, 1> s = C * e;
    Eigen::Matrix3d S;
    S << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
    force -= weight * F * S * gradient.transpose();
    strain_energy += 0.5 * weight * s.dot(e);
  }

  /// k/2 |q|^2 with q = sum_a Gamma_a x_a; bending and warping are k per edge.
  void add_hourglass(const Eigen::Matrix<double, 3, 8> &x, const double edge, const double bending,
                     const double warping)
  {
    for (int mode = 0; mode < 4; ++mode)
    {
      Eigen::Matrix<double, 8, 1> gamma;
      for (int a = 0; a < 8; ++a)
        gamma[a] = mode == 3 ? corner(a).prod() : corner(a).prod() / corner(a)[mode];
      const double k  = (mode == 3 ? warping : bending) * edge;
      const Vector3 q = x * gamma;
      force -= k * q * gamma.transpose();
      hourglass_energy += 0.5 * k * q.squaredNorm();
    }
  }
};
} // namespace ricochet::tests
