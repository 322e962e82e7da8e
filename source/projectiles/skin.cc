// SPDX-License-Identifier: LGPL-2.1-or-later
#include "skin.h"

#include <algorithm>

namespace ricochet
{
std::vector<SurfaceQuad> outer_faces(const HexSolid &mesh, const bool mirrored)
{
  auto faces = surface_of(mesh);
  if (mirrored)
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                               [&](const SurfaceQuad &quad)
                               {
                                 return std::all_of(quad.begin(), quad.end(),
                                                    [&](const int node)
                                                    { return mesh.nodes[node].y() == 0.; });
                               }),
                faces.end());
  return faces;
}

Skin::Skin(const HexSolid &mesh, const bool mirrored) : faces(outer_faces(mesh, mirrored))
{
  std::vector<int> number(mesh.nodes.size(), -1);
  for (auto &quad : faces)
    for (int &node : quad)
    {
      if (number[node] < 0)
      {
        number[node] = static_cast<int>(nodes.size());
        nodes.push_back(mesh.nodes[node]);
        mesh_nodes.push_back(node);
      }
      node = number[node];
    }
}
} // namespace ricochet
