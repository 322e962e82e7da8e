// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/frame_fields.h"

namespace ricochet
{
namespace
{
using Points   = const PointFrame &;
using Elements = const ElementFrame &;
using Number   = std::size_t;
using Axis     = unsigned int;

const std::vector<FrameField> fields{
    {"displacement", "m", 3, [](Points p, Number i, Axis d) { return p.displacement[i][d]; },
     [](Elements e, Number i, Axis d) { return e.displacement[i][d]; },
     "from the reference configuration; of an element that of its middle"},
    {"velocity", "m/s", 3, [](Points p, Number i, Axis d) { return p.velocity[i][d]; },
     [](Elements e, Number i, Axis d) { return e.velocity[i][d]; },
     "half a time step before; of an element that of its middle"},
    {"damage", "-", 1, [](Points p, Number i, Axis) { return p.damage[i]; },
     [](Elements, Number, Axis) { return 0.; },
     "broken share of a point's bonds; elements do not break"},
    {"dilatation", "-", 1, [](Points p, Number i, Axis) { return p.state.dilatation[i]; },
     [](Elements e, Number i, Axis) { return e.state.dilatation[i]; },
     "relative change of the volume: theta of a point's intact bonds; det F - 1 of an element"},
    {"pressure", "Pa", 1, [](Points p, Number i, Axis) { return p.state.pressure[i]; },
     [](Elements e, Number i, Axis) { return e.state.pressure[i]; },
     "minus a third of the trace of the stress, positive when compressed"},
    {"von Mises stress", "Pa", 1, [](Points p, Number i, Axis) { return p.state.von_mises[i]; },
     [](Elements e, Number i, Axis) { return e.state.von_mises[i]; },
     "sqrt(3/2 s:s) of the stress deviator s. The stress, Kirchhoff's, is of a point what its "
     "intact bonds hold: less than in a continuum within a horizon of surfaces and cracks; of an "
     "element, and of points that follow elements, the material's at the deformation of the "
     "middle; with relaxation in both what is left of it"},
    {"strain energy density", "J/m3", 1,
     [](Points p, Number i, Axis) { return p.state.energy_density[i]; },
     [](Elements e, Number i, Axis) { return e.state.energy_density[i]; },
     "stored, per volume of the reference configuration, by the same bonds or at the same "
     "deformation; hourglass modes not included"},
    {"body", "-", 1, [](Points p, Number i, Axis) { return double(p.body[i]); },
     [](Elements e, Number i, Axis) { return double(e.body[i]); },
     "number of the plate, from 1; 0 is the projectile, -1, -2 and so on are further ones"}};
} // namespace

const std::vector<FrameField> &frame_fields()
{
  return fields;
}
} // namespace ricochet
