// SPDX-License-Identifier: LGPL-2.1-or-later
// Waves leave a box of elements: dashpots at its faces pull back with rho c_P v_n and rho c_S v_t
// per area, which absorbs plane waves at normal incidence altogether (Lysmer and Kuhlemeyer 1969,
// Journal of the Engineering Mechanics Division 95, 859-877); at 60 degrees 6 % of the energy of P
// waves returns, 11 % of S waves. Constant loads push the body away: nothing holds it there.
#pragma once

#include "ricochet/base/exact_sum.h"
#include "ricochet/base/state_archive.h"
#include "ricochet/finite_elements/lumped_mass.h"
#include "ricochet/materials/finite_element_material.h"

#include <array>

namespace ricochet
{
class AbsorbingBoundary
{
public:
  /// The motion of the body's nodes, as in FiniteElementBody; forces without the dashpots'.
  struct Motion
  {
    const std::vector<double> &position, &velocity, &force, &inverse_mass; // [m] [m/s] [N] [1/kg]
  };

  /// `faces`: -x, +x, -y, +y, -z, +z of the mesh's box. Collective.
  AbsorbingBoundary(const HexMesh &mesh, const FiniteElementMaterial &material,
                    const std::array<bool, 6> &faces);

  /// What a kick of this length [s] does to the nodes: `force`, the same as in `motion`, takes over
  /// the dashpots' part. Books what they carry off.
  void damp(const Motion &motion, double kick, std::vector<double> &force);

  /// For a look in the middle of a step: adds what the dashpots change in the kinetic energy as the
  /// leapfrog scheme conserves it, and what they have taken until now [J].
  void add_energies(const Motion &motion, const std::vector<double> &mass, double dt,
                    ExactSum &kinetic, ExactSum &absorbed) const;
  /// Adds what they have carried off: momentum [kg m/s], then angular momentum [kg m^2/s].
  void add_momenta(std::array<ExactSum, 6> &sums) const;

  /// Saves or restores what has been carried off. Collective.
  void exchange_state(StateArchive &archive);

private:
  struct Dashpot
  {
    int entry;          // component of an owned node
    double coefficient; // [kg/s]
    // Each keeps its own books: a sum over many would depend on how ranks share them.
    double absorbed         = 0.;              // up to the step before [J]
    double carried_linear   = 0.;              // along the component's axis [kg m/s]
    Vector3 carried_angular = Vector3::Zero(); // [kg m^2/s]
  };
  static double damped_force(const Dashpot &dashpot, const Motion &motion, double dt);

  std::vector<Dashpot> dashpots_;    // three per node
  std::vector<std::int64_t> places_; // of the nodes, three dashpots each
};
} // namespace ricochet
