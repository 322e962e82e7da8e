// SPDX-License-Identifier: LGPL-2.1-or-later
// A parameter text whose run takes a second: a ball hits two plates.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <string>
#include <vector>

namespace ricochet::tests
{
inline const std::string two_plates_text = R"(
subsection Projectile
  set Nose shape = sphere
  set Diameter   = 6 mm
  set Density    = 7850 kg/m3
end
subsection Impact
  set Speed           = 300 m/s
  set Incidence angle = 30 deg
  set Entry point     = 10 mm, 0 mm
end
subsection Plate 1
  set Size         = 40 mm, 20 mm, 6 mm
  set Grid spacing = 1 mm
  set Material     = PMMA
end
subsection Plate 2
  set Size         = 40 mm, 20 mm, 6 mm
  set Grid spacing = 1 mm
  set Material     = PMMA
end
subsection Material PMMA
  set Density          = 1190 kg/m3
  set Bulk modulus     = 5.9 GPa
  set Shear modulus    = 2.258 GPa
  set Critical stretch = 0.01
end
subsection Contact
  set Friction law           = constant
  set Static friction        = 0.3
  set Debris friction factor = 0.5
end
subsection Time
  set Final time = 30 us
end
subsection Output
  set Frame interval = 0 us
  set Report         = false
  set ParaView files = false
  set Pictures       = false
  set Picture times  = 0 us, 12.3 us, 20 us, 40 us
end
)";

/// The text with overrides as on the command line, and results in this folder.
inline ParameterFile two_plates_file(const std::string &folder,
                                     std::vector<std::string> overrides = {})
{
  overrides.push_back("Output/Directory=" + folder);
  return ParameterFile::from_text(two_plates_text, "two_plates.prm", parse_overrides(overrides));
}
} // namespace ricochet::tests
