// SPDX-License-Identifier: LGPL-2.1-or-later
// Small peridynamic bodies, and how to move them.
#pragma once

#include "ricochet/peridynamics/peridynamic_body.h"
#include "support/laws.h"
#include "support/random.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <memory>

namespace ricochet::tests
{
/// Of bodies in one list, for what only sees them.
inline std::vector<PeridynamicBody *>
pointers(const std::vector<std::unique_ptr<PeridynamicBody>> &bodies)
{
  std::vector<PeridynamicBody *> result;
  for (const auto &body : bodies)
    result.push_back(body.get());
  return result;
}

constexpr double unbreakable = std::numeric_limits<double>::infinity();

struct BodySample
{
  FamilySample family{bond_law_samples[0], InfluenceFunction::cone, 3.};
  std::array<int, 3> n{8, 8, 8};
  double spacing              = 1e-3; // [m]
  Vector3 corner              = Vector3::Zero();
  double critical_stretch     = unbreakable;
  bool mirror_y               = false;
  Lattice::Mask mask          = {};
  const char *instruction_set = nullptr;
  int number                  = 0;
  double density_factor       = 1.; // of the law's density
  MPI_Comm communicator       = MPI_COMM_SELF;
};

inline std::unique_ptr<PeridynamicBody> make_body(const BodySample &sample)
{
  const auto &law = sample.family.law;
  const PeridynamicMaterial material{&bond_law(law.law), sample.density_factor * law.density,
                                     law.bulk_modulus, law.shear_modulus, sample.critical_stretch};
  const Lattice::Box box{sample.corner, sample.spacing, sample.n, sample.mirror_y};
  return std::make_unique<PeridynamicBody>(
      sample.communicator, sample.number, box,
      make_stencil(sample.spacing, sample.family.horizon_ratio, sample.family.influence_function),
      material, sample.mask, sample.instruction_set);
}

template <class Visitor>
void for_each_point(const PeridynamicBody &body, Visitor &&visit)
{
  const Lattice &l = body.lattice();
  for (std::ptrdiff_t p = l.owned_begin(); p < l.owned_end(); ++p)
    if (l.owned(p))
      visit(p);
}

inline Vector3 at(double *const field[3], const std::ptrdiff_t p)
{
  return {field[0][p], field[1][p], field[2][p]};
}

inline void set(double *const field[3], const std::ptrdiff_t p, const Vector3 &value)
{
  for (int d = 0; d < 3; ++d)
    field[d][p] = value[d];
}

inline Vector3 reference(const PeridynamicBody &body, const std::ptrdiff_t p)
{
  return body.lattice().reference_position(body.lattice().coordinates(p));
}

inline Vector3 position(const PeridynamicBody &body, const std::ptrdiff_t p)
{
  return at(body.state().arrays.position, p);
}

inline Vector3 force(const PeridynamicBody &body, const std::ptrdiff_t p)
{
  return at(body.state().arrays.force, p);
}

/// Moves every point to map(reference position) and evaluates forces and energies.
template <class Map>
void deform(PeridynamicBody &body, Map &&map, const bool breaking = false)
{
  for_each_point(body, [&](const std::ptrdiff_t p)
                 { set(body.state().arrays.position, p, map(reference(body, p))); });
  body.update_ghosts();
  if (breaking)
    body.break_bonds();
  body.compute_internal_forces({/*energy=*/true});
}

inline double strain_energy(const PeridynamicBody &body)
{
  double sum = 0.;
  for_each_point(body, [&](const std::ptrdiff_t p) { sum += body.state().arrays.energy[p]; });
  return sum;
}

inline double largest_force(const PeridynamicBody &body)
{
  double largest = 0.;
  for_each_point(body, [&](const std::ptrdiff_t p)
                 { largest = std::max(largest, force(body, p).norm()); });
  return largest;
}

/// Number of bonds of an owned point that are intact, by the bits of both ends.
inline bool is_intact(const PeridynamicBody &body, const std::ptrdiff_t p, const std::size_t k)
{
  const auto n = body.lattice().stencil().offsets.size();
  return (body.state().arrays.bonds[(p / Lattice::block_size) * n + k] >>
          (p % Lattice::block_size)) &
         1;
}

/// K + 4 mu / 3 [Pa]
inline double p_wave_modulus(const PeridynamicMaterial &m)
{
  return m.bulk_modulus + 4. / 3. * m.shear_modulus;
}

/// E [Pa]
inline double youngs_modulus(const PeridynamicMaterial &m)
{
  return 9. * m.bulk_modulus * m.shear_modulus / (3. * m.bulk_modulus + m.shear_modulus);
}

/// The linear peridynamic solid with that Poisson's ratio; K = 1 GPa, rho = 1000 kg/m^3.
inline BondLawSample solid_with_poisson_ratio(const double nu)
{
  return {"linear peridynamic solid", 1000., 1e9, 1e9 * 1.5 * (1. - 2. * nu) / (1. + nu)};
}
} // namespace ricochet::tests
