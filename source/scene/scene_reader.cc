// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/scene_reader.h"

#include "parameter_writer.h"
#include "ricochet/scene/stability_reader.h"
#include "scene_sections.h"
#include "section_checks.h"

namespace ricochet
{
Scene read_scene(const ParameterFile &file)
{
  Scene scene   = empty_scene(file);
  auto sections = scene_sections(stem_of(file), scene);
  read_and_check_sections(file, sections);
  return scene;
}

void write_used_parameters(const ParameterFile &file, std::ostream &out)
{
  if (is_stability_file(file))
  {
    StabilityParameters experiment;
    auto sections = stability_sections(stem_of(file), experiment);
    read_sections(file, sections);
    write_parameters(sections, out);
    return;
  }
  Scene scene   = empty_scene(file);
  auto sections = scene_sections(stem_of(file), scene);
  read_sections(file, sections);
  write_parameters(sections, out);
}
} // namespace ricochet
