// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/scene_reader.h"

#include "parameter_writer.h"
#include "ricochet/scene/stability_reader.h"
#include "scene_sections.h"
#include "section_checks.h"

namespace ricochet
{
namespace
{
/// Calls the action with the sections of a scene or experiment as the file fills them.
template <class Action>
void with_sections(const ParameterFile &file, const Action &action)
{
  const bool is_experiment = is_stability_file(file);
  StabilityParameters experiment;
  Scene scene   = is_experiment ? Scene() : empty_scene(file);
  auto sections = is_experiment ? stability_sections(stem_of(file), experiment)
                                : scene_sections(stem_of(file), scene);
  read_sections(file, sections);
  action(sections);
}
} // namespace

Scene read_scene(const ParameterFile &file)
{
  Scene scene   = empty_scene(file);
  auto sections = scene_sections(stem_of(file), scene);
  read_and_check_sections(file, sections);
  return scene;
}

void write_used_parameters(const ParameterFile &file, std::ostream &out)
{
  with_sections(file,
                [&](const std::vector<Section> &sections) { write_parameters(sections, out); });
}

std::string used_value(const ParameterFile &file, const std::string &section,
                       const std::string &name)
{
  std::string value;
  with_sections(file,
                [&](const std::vector<Section> &sections)
                {
                  for (const auto &one : sections)
                    if (const Entry *const entry = one.find(name); entry && one.name() == section)
                      value = entry->text();
                });
  return value;
}
} // namespace ricochet
