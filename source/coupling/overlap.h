// SPDX-License-Identifier: LGPL-2.1-or-later
// What ties the points of a projectile's nose to the elements behind it: which nodes a point
// follows, and which share of their strain energy the elements there keep. The equations are in
// coupled_projectile_body.h.
#pragma once

#include "ricochet/geometry/hex_solid.h"

#include <map>
#include <utility>
#include <vector>

namespace ricochet
{
/// The cells for which `chosen` is true, and the new number of each node or -1.
HexSolid part_of(const HexSolid &mesh, const std::vector<char> &chosen, std::vector<int> &number);

/// Finds the cells around places that lie in front of a plane across x.
class CellFinder
{
public:
  /// `solid` must outlive this object.
  CellFinder(const HexSolid &solid, double plane);

  const HexSolid &solid() const { return solid_; }
  /// The cell that the place lies in, or is nearest to; the shape functions there. -1: far from
  /// all.
  std::pair<int, std::array<double, 8>> find(const Vector3 &place) const;

private:
  struct Box
  {
    int cell;
    Vector3 low, high;
  };
  const HexSolid &solid_;
  std::vector<Box> boxes_;
};

/// The nodes that a point follows, with their weights: the mean over n^3 parts of its cube of this
/// edge [m]. At the body's surface the cube sticks out; there it is made smaller, about the same
/// centre. Marks the cells in `overlaps`. Throws InputError if even the centre lies far from all.
std::map<int, double> nodes_followed(const CellFinder &finder, const Vector3 &centre, double edge,
                                     int n, std::vector<char> &overlaps);

/// What a cell in uniform stress does to its nodes: - V stress B_a [N].
Eigen::Matrix<double, 3, 8> nodal_forces(const HexSolid &solid, int cell,
                                         const Eigen::Matrix3d &stress);

struct OverlapShares
{
  std::vector<double> shares; // per cell; 1 outside the overlap [-]
  int n_elements = 0;         // with a share
  double ghost   = 0.;        // largest force left at a node, in units of E e h^2 [-]
};

/// Of the solution by least squares.
struct LeastSquaresLimits
{
  double tolerance = 1e-13; // of the normal equations' residual, relative: as good as doubles are
  int most_iterations = 0;  // 0: twice the number of unknowns, Eigen's choice
};

/// The shares of the cells in the overlap, none negative, that come nearest to making up for the
/// forces `missing` at the nodes of all cells (three per node [N]) under an axial pull with Young's
/// modulus E [Pa] as the stress. Throws RunError if they are not found.
OverlapShares find_overlap_shares(const HexSolid &solid, const std::vector<char> &overlaps,
                                  bool mirrored, double E, Eigen::VectorXd missing,
                                  const LeastSquaresLimits &limits = {});
} // namespace ricochet
