// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/lumped_mass.h"

namespace ricochet
{
LumpedMass lumped_mass(const HexMesh &mesh, const double density, const std::vector<char> &active,
                       const std::vector<int> &fixed)
{
  std::vector<double> mass(mesh.reference().size(), 0.);
  for (std::size_t e = 0; e < active.size(); ++e)
    if (active[e])
    {
      const auto &element = mesh.elements()[e];
      const double share  = density * element.edge * element.edge * element.edge / 8.;
      for (const int node : element.nodes)
        for (int d = 0; d < 3; ++d)
          mass[3 * node + d] += share;
    }
  mesh.add_to_owners(mass.data());
  LumpedMass result;
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
  {
    result.mass.push_back(mass[3 * node]);
    for (int d = 0; d < 3; ++d)
      result.inverse.push_back(mass[3 * node] > 0. ? 1. / mass[3 * node] : 0.);
    if (mesh.on_mirror_plane(node))
      result.inverse[3 * node + 1] = 0.;
  }
  for (const int entry : fixed)
    result.inverse[entry] = 0.;
  return result;
}
} // namespace ricochet
