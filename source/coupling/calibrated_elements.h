// SPDX-License-Identifier: LGPL-2.1-or-later
// The elements in the pad and halo of a zone, whose tensors are sought, and their nodes, on all
// ranks.
#pragma once

#include "hex_tensors.h"

#include "ricochet/finite_elements/hex_mesh.h"
#include "ricochet/peridynamics/lattice.h"

namespace ricochet
{
class CalibratedElements
{
public:
  struct Element // of this rank
  {
    int number; // in the mesh
    Zone::Cell cell;
    CellPattern pattern;
    std::array<int, 8> corner; // in nodes()
  };

  /// `tolerance`: see CalibrationOptions. Both must outlive this object. Collective.
  CalibratedElements(MPI_Comm communicator, const Lattice &lattice, const HexMesh &mesh,
                     double tolerance);

  const Lattice &lattice() const { return lattice_; }
  const Zone &zone() const { return *lattice_.zone(); }
  const HexMesh &mesh() const { return mesh_; }
  double edge() const { return zone().points_per_edge() * lattice_.box().spacing; } // [m]
  const std::vector<Element> &elements() const { return elements_; }
  const std::vector<int> &nodes() const { return nodes_; } // local numbers in the mesh
  /// What a force at an entry of nodes() may be in the end [-].
  double allowed(const std::size_t i) const { return allowed_[i]; }

  /// Contributions of all ranks, the same at owners and ghosts. On the symmetry plane only what the
  /// other half does not cancel; nothing in the surface layer. Collective.
  void complete(NodalForces &forces) const;
  /// Entries of nodes() that one rank has marked are marked on all that know the node. Collective.
  void share(std::vector<char> &marked) const;

  // Of all nodes. Collective.
  double squared_norm(const NodalForces &forces) const;
  double largest(const NodalForces &forces) const;
  double largest_excess(const NodalForces &forces) const; // in units of what is allowed there

private:
  enum class NodeRole : char
  {
    inside,
    mirror,
    /// In the surface layer points are softer than any element: what the bonds do there cannot be
    /// mended, and trying would spoil the elements around.
    surface
  };

  void find_elements();
  void number_nodes();

  MPI_Comm communicator_;
  int n_ranks_;
  const Lattice &lattice_;
  const HexMesh &mesh_;
  std::vector<Element> elements_;
  std::vector<int> nodes_;
  std::vector<NodeRole> role_;  // of nodes_
  std::vector<double> allowed_; // at nodes_ [-]
};
} // namespace ricochet
