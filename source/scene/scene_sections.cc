// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene_sections.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/units.h"
#include "ricochet/scene/text_tools.h"
#include "sections.h"

#include <algorithm>
#include <filesystem>

namespace ricochet
{
namespace
{
/// How many sections of a kind have numbers, which must follow each other from `first`.
std::size_t count_numbered(const ParameterFile &file, const std::string &kind,
                           const unsigned int first, const std::string &remedy)
{
  std::vector<unsigned int> numbers;
  for (const auto &section : file.sections())
    if (section.in_file && number_in(section.name, kind) > 0)
      numbers.push_back(number_in(section.name, kind));
  std::sort(numbers.begin(), numbers.end());

  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != i + first)
      for (const auto &section : file.sections())
        if (number_in(section.name, kind) == numbers[i])
        {
          std::string missing = kind;
          missing += " " + std::to_string(i + first);
          throw InputError(section.origin + ": There is a " + in_quotes(section.name) + " but no " +
                           in_quotes(missing) + ".\n  " + remedy);
        }
  return numbers.size();
}

std::size_t count_plates(const ParameterFile &file)
{
  return count_numbered(file, "Plate", 1,
                        "Number the plates 1, 2, 3 and so on, from top to bottom.");
}

/// Of those after the first: each has a section Projectile N and a section Impact N.
std::size_t count_further_shots(const ParameterFile &file)
{
  const std::string kinds[] = {"Projectile", "Impact"};
  std::size_t n[2];
  for (const int k : {0, 1})
  {
    for (const auto &section : file.sections())
      if (number_in(section.name, kinds[k]) == 1)
        throw InputError(section.origin + ": There is no section " + in_quotes(section.name) +
                         ".\n  The section of the first is called " + in_quotes(kinds[k]) + ".");
    n[k] = count_numbered(file, kinds[k], 2,
                          "The first section is called " + in_quotes(kinds[k]) + ", the others " +
                              in_quotes(kinds[k] + " 2") + ", " + in_quotes(kinds[k] + " 3") +
                              " and so on.");
  }
  if (n[0] == n[1])
    return n[0];
  const int more           = n[0] > n[1] ? 0 : 1; // of which there is one too many
  const std::string number = " " + std::to_string(n[1 - more] + 2);
  for (const auto &section : file.sections())
    if (section.name == kinds[more] + number)
      throw InputError(section.origin + ": There is a " + in_quotes(section.name) + " but no " +
                       in_quotes(kinds[1 - more] + number) +
                       ".\n  Every projectile has a section that says what it is and one that says "
                       "how it arrives.");
  return n[0];
}

void refuse_other_kinds(const ParameterFile &file)
{
  for (const auto &section : file.sections())
  {
    if (section.name == study_name)
      throw InputError(section.origin +
                       ": This file describes a study, not a scene.\n  Run it with 'ricochet "
                       "study'.");
    if (section.in_file && section.name == stability_name)
      throw InputError(section.origin +
                       ": This file describes a stability experiment, not a scene.\n  Run it with "
                       "'ricochet run'.");
  }
}

/// A file without materials gets those its plates ask for, or an example: the list of what is
/// missing then says what to write.
std::vector<std::string> material_names(const ParameterFile &file)
{
  const std::string prefix = material_prefix;
  std::vector<std::string> names;
  for (const auto &section : file.sections())
    if (section.in_file && section.name.rfind(prefix, 0) == 0)
      names.push_back(section.name.substr(prefix.size()));
  if (names.empty())
    for (const auto &entry : file.entries())
      if (plate_number(entry.section) > 0 && entry.name == "Material" && !entry.value.empty() &&
          std::find(names.begin(), names.end(), entry.value) == names.end())
        names.push_back(entry.value);
  if (names.empty())
    names.push_back("PMMA");
  return names;
}
} // namespace

std::string stem_of(const ParameterFile &file)
{
  return std::filesystem::path(file.path()).stem().string();
}

std::string in_mm(const double length)
{
  return number_text(length / units::mm) + " mm";
}

Words<InfluenceFunction> influence_function_words()
{
  return words_of(influence_functions, &InfluenceFunctionName::function);
}

Section top_section(Scene &scene, const std::string &stem)
{
  Section in("", "");
  in.named_after_file("Title", text(scene.title, "any text"), stem, "An oblique impact",
                      "What the run is called in its results, by default like the file");
  in.with_default("Symmetric", flag(scene.symmetric), "true",
                  "Whether only the half y > 0 is computed, mirrored at the plane y = 0");
  return in;
}

std::vector<Section> scene_sections(const std::string &stem, Scene &scene)
{
  std::vector<Section> sections;
  sections.push_back(top_section(scene, stem));
  sections.push_back(projectile_section(scene.projectile, 1));
  sections.push_back(impact_section(scene.impact, 1, scene));
  for (std::size_t i = 0; i < scene.further_shots.size(); ++i)
  {
    auto &shot        = scene.further_shots[i];
    const auto number = static_cast<unsigned int>(i + 2);
    sections.push_back(projectile_section(shot.projectile, number));
    sections.push_back(impact_section(shot.impact, number, scene));
  }
  for (std::size_t i = 0; i < scene.plates.size(); ++i)
    sections.push_back(plate_section(scene.plates[i], static_cast<unsigned int>(i + 1), scene));
  for (auto &material : scene.materials)
    sections.push_back(material_section(material));
  sections.push_back(coupling_section(scene.zone, scene));
  sections.push_back(contact_section(scene.contact));
  sections.push_back(time_section(scene.time));
  sections.push_back(output_section(scene.output, stem));
  return sections;
}

Scene empty_scene(const ParameterFile &file)
{
  refuse_other_kinds(file);
  Scene scene = empty_scene(std::max<std::size_t>(1, count_plates(file)), material_names(file));
  scene.further_shots.resize(count_further_shots(file));
  return scene;
}

Scene empty_scene(const std::size_t n_plates, const std::vector<std::string> &materials)
{
  Scene scene{};
  scene.plates.resize(n_plates);
  scene.materials.resize(materials.size());
  for (std::size_t i = 0; i < materials.size(); ++i)
    scene.materials[i].name = materials[i];
  return scene;
}
} // namespace ricochet
