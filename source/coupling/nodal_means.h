// SPDX-License-Identifier: LGPL-2.1-or-later
// From values of elements to values of nodes, which points between them can interpolate.
#pragma once

#include "ricochet/finite_elements/finite_element_body.h"

#include <functional>
#include <vector>

namespace ricochet
{
struct ElementValues
{
  int n_triples; // of numbers per element
  /// Writes the 3 * n_triples numbers of an active element.
  std::function<void(int element, double *values)> of_element;
  /// Whether number i changes its sign in a mirror plane y = 0: it is zero there.
  std::function<bool(int i)> is_odd;
};

/// One nodal field per triple, three numbers per local node as in HexMesh: the mean of the active
/// elements around the node, weighted with their volumes; zero where there are none. Ghosts and
/// hanging nodes are up to date. Collective.
std::vector<std::vector<double>> nodal_means(const FiniteElementBody &elements,
                                             const ElementValues &values);

/// Whether a component of a symmetric tensor, in Voigt's order, is odd: 23 and 12.
inline bool is_odd_in_mirror(const int component)
{
  return component == 3 || component == 5;
}
} // namespace ricochet
