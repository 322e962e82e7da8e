// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/surface_frame.h"

namespace ricochet
{
void SurfaceFrame::add(const SurfaceFrame &other)
{
  const int first = static_cast<int>(vertices.size());
  const int last  = body.empty() ? 0 : body.back(); // numbers count downwards
  body.resize(quads.size(), 0);
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (auto quad : other.quads)
  {
    for (int &vertex : quad)
      vertex += first;
    quads.push_back(quad);
  }
  body.resize(quads.size(), last - 1);
  if (!von_mises.empty() || !other.von_mises.empty()) // 0 where it is not known
  {
    von_mises.resize(quads.size() - other.quads.size(), 0.);
    von_mises.insert(von_mises.end(), other.von_mises.begin(), other.von_mises.end());
    von_mises.resize(quads.size(), 0.);
  }
  further_outlines.push_back(other.outline);
}
} // namespace ricochet
