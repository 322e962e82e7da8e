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
  further_outlines.push_back(other.outline);
}
} // namespace ricochet
