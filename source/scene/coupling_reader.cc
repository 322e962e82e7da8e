// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coupling_reader.h"

namespace ricochet
{
CouplingParameters read_coupling(const Parameters &parameters, const std::string &section)
{
  CouplingParameters coupling;
  for (const auto &method : coupling_methods)
    if (method.name == parameters.text(section, "Method"))
      coupling.method = method.method;
  coupling.blend = parameters.text(section, "Blend function") == "linear" ? BlendFunction::linear
                                                                          : BlendFunction::cubic;
  coupling.blend_width     = parameters.quantity(section, "Blend width");
  coupling.correct_mass    = parameters.flag(section, "Mass correction");
  coupling.points_per_edge = std::stoi(parameters.text(section, "Element size"));
  if (coupling.blend_width > 10.)
    parameters.fail(section, "Blend width", "The blend may be at most 10 horizons wide.",
                    "Choose a smaller number; 2 is usual.");
  return coupling;
}
} // namespace ricochet
