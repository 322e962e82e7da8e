// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nodal_means.h"

namespace ricochet
{
std::vector<std::vector<double>> nodal_means(const FiniteElementBody &elements,
                                             const ElementValues &values)
{
  const auto &mesh = elements.mesh();
  std::vector<double> weight(elements.force().size(), 0.);
  std::vector<std::vector<double>> fields(values.n_triples, weight);
  std::vector<double> here(3 * static_cast<std::size_t>(values.n_triples));
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
  {
    if (!elements.is_active(static_cast<int>(e)))
      continue;
    const auto &element = mesh.elements()[e];
    const double volume = element.edge * element.edge * element.edge;
    values.of_element(static_cast<int>(e), here.data());
    for (const int node : element.nodes)
    {
      for (int d = 0; d < 3; ++d)
        weight[3 * node + d] += volume;
      for (std::size_t i = 0; i < here.size(); ++i)
        fields[i / 3][3 * node + i % 3] += volume * here[i];
    }
  }
  mesh.add_to_owners(weight.data());
  for (int f = 0; f < values.n_triples; ++f)
  {
    auto &field = fields[f];
    mesh.add_to_owners(field.data());
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i    = 3 * node + d;
        const bool odd = values.is_odd(3 * f + d) && mesh.on_mirror_plane(node);
        field[i]       = weight[i] > 0. && !odd ? field[i] / weight[i] : 0.;
      }
    mesh.update_ghosts(field.data());
    mesh.follow_masters(field.data());
  }
  return fields;
}
} // namespace ricochet
