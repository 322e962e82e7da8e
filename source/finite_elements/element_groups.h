// SPDX-License-Identifier: LGPL-2.1-or-later
// The elements of a FiniteElementBody, sorted for the kernel: those with the material's moduli and
// those with tensors of their own; others are not active and carry no force. See
// kernels/hex_kernel.h for the equations.
#pragma once

#include "element_history.h"

#include "ricochet/base/exact_sum.h"
#include "ricochet/base/state_archive.h"
#include "ricochet/finite_elements/element_stiffness.h"
#include "ricochet/finite_elements/hex_mesh.h"
#include "ricochet/materials/finite_element_material.h"

#include <array>
#include <vector>

namespace ricochet
{
class ElementGroups
{
public:
  /// None is active yet. Mesh and kernel must outlive this object. `hourglass_coefficient`: see
  /// FiniteElementBody::Options.
  ElementGroups(const HexMesh &mesh, const FiniteElementMaterial &material, Quadrature quadrature,
                double hourglass_coefficient, const HexKernel &kernel);

  /// One entry per element of the mesh; all active ones have the material's moduli until
  /// set_stiffness(). Collective.
  void set_active(const std::vector<char> &active);
  /// These elements have their own tensors from now on, all others the material's moduli. Those
  /// that are not active are left out. Collective.
  void set_stiffness(const std::vector<ElementStiffness> &stiffness);
  /// From no history; dt is the step of add_forces() [s]. Throws InputError for an impossible
  /// series.
  void start_relaxation(double dt);
  bool relaxes() const { return !branches_.empty(); }

  /// Three numbers per local node; ghosts of the positions must be up to date [m], [N]. Forces go
  /// to the nodes' owners. With `energy`, also each element's energies. History moves on if it is a
  /// step. Collective.
  void add_forces(const std::vector<double> &position, std::vector<double> &force, bool energy,
                  bool is_step);

  /// Saves or restores the histories. Collective.
  void exchange_state(StateArchive &archive);

  bool is_active(const int element) const { return place_[element].group >= 0; }
  const std::vector<char> &active() const { return active_; }

  // Of one element at the last add_forces() with energy; zero if not active [J].
  double strain_energy(int element) const;
  double hourglass_energy(int element) const;
  struct Energies // of this rank's elements [J]
  {
    ExactSum strain, hourglass;
    ExactSum viscous; // turned into heat so far, also by elements that are not active any more
  };
  void add_energies(Energies &sums) const;

  // See FiniteElementBody; zero if not active or elastic [-].
  Eigen::Matrix3d back_strain(int element, int branch) const;
  Eigen::Matrix3d history(int element, int branch) const;
  /// Second Piola-Kirchhoff stress for this Green-Lagrange strain; zero if not active [Pa].
  Eigen::Matrix3d stress(int element, const Eigen::Matrix3d &E) const;

private:
  struct Group
  {
    std::vector<int> elements;
    std::vector<HexBlock> blocks;
    std::vector<HexTensors> tensors; // C and C_mu, per block; empty: the material's moduli
    std::vector<HexTensors> shear;
    std::vector<double> strain_energy, hourglass_energy; // per entry of elements
    ElementHistory history;
  };
  struct Place
  {
    int group, index; // group -1: not active
  };
  using Memories = std::vector<ElementHistory::Memory>; // per element of the mesh

  int n_gauss_points(int group) const;
  void sort(const std::vector<const ElementStiffness *> &own);
  void fill_blocks(Group &group) const;
  void fill_tensors(const std::vector<const ElementStiffness *> &own);
  void restore_histories();
  Memories memories() const;
  HexGroup view(const Group &group) const;
  HexKernel::ForceLoop loop(int group, bool energy) const;
  HexKernel::RelaxingForceLoop relaxing_loop(int group, bool energy) const;

  const HexMesh &mesh_;
  FiniteElementMaterial material_;
  Quadrature quadrature_;
  double hourglass_coefficient_;
  const HexKernel &kernel_;
  std::vector<char> active_;
  std::array<Group, 2> groups_;       // shared moduli, own tensors
  std::vector<Place> place_;          // of each element
  HexMesh::SummationOrder order_;     // one group after the other
  std::vector<MaxwellStep> branches_; // none: elastic
  /// As of the last step; empty: as the groups have it. Groups may be formed several times between
  /// two steps, each time from here: an element that passes through the other group keeps its Gauss
  /// points apart.
  Memories memories_;
  std::vector<double> dissipated_before_; // per element, when it was last switched off [J]
};
} // namespace ricochet
