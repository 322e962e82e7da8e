// SPDX-License-Identifier: LGPL-2.1-or-later
#include "element_frame.h"

#include "ricochet/coupling/plate_stress.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// How high the section's layer lies in an element whose lowest corner is `low`: 0 at the bottom, 1
/// at the top.
double section_height(const Vector3 &low, const double edge, const Lattice::Box &box)
{
  return (box.corner.y() + (section_layer(box) + 0.5) * box.spacing - low.y()) / edge;
}

/// The places of points in the section's layer, at the height eta, of the last element of the
/// frame: its corners blended.
void add_section(const double edge, const double eta, const Lattice::Box &box, ElementFrame &frame)
{
  const auto &corners = frame.corners.back();
  const int n         = static_cast<int>(std::lround(edge / box.spacing));
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
    {
      const double at[3] = {(i + 0.5) / n, eta, (k + 0.5) / n};
      Vector3 x          = Vector3::Zero();
      for (int corner = 0; corner < 8; ++corner)
      {
        double shape = 1.;
        for (int d = 0; d < 3; ++d)
          shape *= (corner >> d) & 1 ? at[d] : 1. - at[d];
        x += shape * corners[corner];
      }
      frame.section_position.push_back(x);
      frame.section_body.push_back(frame.body.back());
      frame.section_element.push_back(static_cast<int>(frame.corners.size()) - 1);
    }
}
} // namespace

int section_layer(const Lattice::Box &box)
{
  // The corner is a multiple of half a spacing but for rounding.
  return static_cast<int>(std::floor(1e-9 - box.corner.y() / box.spacing));
}

void add_elements(const CoupledPlate &coupled_plate, const int body, const FrameExtent extent,
                  ElementFrame &frame)
{
  const auto &elements = coupled_plate.elements();
  const auto &mesh     = elements.mesh();
  const auto &lattice  = coupled_plate.points().lattice();
  const auto &box      = lattice.box();
  const auto &zone     = coupled_plate.zone();
  const auto at        = [](const std::vector<double> &values, const int node)
  { return Vector3(values[3 * node], values[3 * node + 1], values[3 * node + 2]); };
  for (std::size_t number = 0; number < mesh.elements().size(); ++number)
  {
    const auto &element = mesh.elements()[number];
    const auto cell     = cell_at(lattice, mesh.centre(element));
    const bool cellwise = element.edge < 1.5 * zone.points_per_edge() * box.spacing;
    if (cellwise && (zone.layer(cell) < zone.far() || zone.has_contact(cell)))
      continue;
    const double eta = section_height(mesh.reference_position(element.nodes[0]), element.edge, box);
    const bool in_section = eta > 0. && eta < 1.;
    if (extent == FrameExtent::section && !in_section)
      continue;
    std::array<Vector3, 8> corners;
    Vector3 middle = Vector3::Zero(), velocity = Vector3::Zero();
    for (int c = 0; c < 8; ++c)
    {
      corners[c] = at(elements.position(), element.nodes[c]);
      middle += corners[c] / 8.;
      velocity += at(elements.velocity(), element.nodes[c]) / 8.;
    }
    frame.corners.push_back(corners);
    frame.displacement.push_back(middle - mesh.centre(element));
    frame.velocity.push_back(velocity);
    frame.state.add(element_stress(elements, static_cast<int>(number)));
    frame.body.push_back(body);
    if (in_section)
      add_section(element.edge, eta, box, frame);
  }
}
} // namespace ricochet
