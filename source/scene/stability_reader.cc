// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/stability_reader.h"

#include "scene_sections.h"
#include "section_checks.h"

#include <algorithm>

namespace ricochet
{
bool is_stability_file(const ParameterFile &file)
{
  const auto &sections = file.sections();
  return std::any_of(sections.begin(), sections.end(),
                     [](const auto &present)
                     { return present.in_file && present.name == stability_name; });
}

StabilityParameters read_stability(const ParameterFile &file)
{
  StabilityParameters experiment;
  auto sections = stability_sections(stem_of(file), experiment);
  read_and_check_sections(file, sections);
  return experiment;
}
} // namespace ricochet
