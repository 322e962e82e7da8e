// SPDX-License-Identifier: LGPL-2.1-or-later
// The template and the schema hold all that the reader knows, and nothing that it refuses.
#include "ricochet/scene/parameter_template.h"

#include "ricochet/scene/stability_reader.h"
#include "ricochet/scene/study_file.h"
#include "scene/scene_sections.h"
#include "scene/study_section.h"
#include "support/scene_text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <set>
#include <sstream>

namespace ricochet::tests
{
namespace
{
using Json = nlohmann::json;

std::string template_text()
{
  std::ostringstream text;
  print_template(text);
  return text.str();
}

/// From the line that begins so on, without the "# " before each line.
std::string uncommented_from(const std::string &begin)
{
  std::istringstream text(template_text());
  std::string result;
  bool found = false;
  for (std::string line; std::getline(text, line);)
  {
    found = found || line.rfind(begin, 0) == 0;
    if (found && line.rfind("# ", 0) == 0)
      result += line.substr(2) + "\n";
  }
  return result;
}

/// Calls f(file, section, entry) for all entries that the reader knows.
void for_each_entry(
    const std::function<void(const std::string &, const Section &, const Entry &)> &f)
{
  Scene scene = empty_scene(1, {"PMMA"});
  StudyParameters study{};
  StudySettings settings;
  StabilityParameters experiment;
  for (const auto &section : scene_sections("mine", scene))
    for (const auto &entry : section.entries())
      f("scene", section, entry);
  const Section in_study = study_section("mine", study, settings);
  for (const auto &entry : in_study.entries())
    f("study", in_study, entry);
  for (const auto &section : stability_sections("mine", experiment))
    for (const auto &entry : section.entries())
      f("stability", section, entry);
}

TEST(Template, DescribesACompleteScene)
{
  const Scene scene = read_scene(ParameterFile::from_text(template_text(), "mine.prm"));
  EXPECT_EQ(scene.plates.size(), 1U);
  EXPECT_DOUBLE_EQ(scene.impact.speed, 720.);
  EXPECT_EQ(scene.output.directory, "output/mine");
}

TEST(Template, EveryEntryHasACommentAboveIt)
{
  std::istringstream text(template_text());
  std::string line, last;
  std::size_t n_entries = 0, n_declared = 0;
  while (std::getline(text, line))
  {
    if (line.find("set ") != std::string::npos && line.find(" = ") != std::string::npos)
    {
      ++n_entries;
      EXPECT_NE(last.find('#'), std::string::npos) << line;
      EXPECT_EQ(last.back(), '.') << last;
    }
    EXPECT_LE(line.size(), 100U) << line;
    last = line;
  }
  for_each_entry([&](const auto &, const auto &, const auto &) { ++n_declared; });
  EXPECT_EQ(n_entries, n_declared);
}

TEST(Template, MarksWhatIsRequired)
{
  const std::string text = template_text();
  for (const char *line :
       {"set Speed           = 720 m/s # required\n", "set Attack angle    = 0 deg\n",
        "set Critical stretch          = 0.0105 # required\n",
        "# set Energy release rate       = 500 J/m2\n",
        "set Nose length         = 10.23 mm # required\n", "# set Young's modulus     = 202 GPa\n",
        "Required if 'Nose shape' is ogive or cone."})
    EXPECT_NE(text.find(line), std::string::npos) << "no '" << line << "' in\n" << text;
}

/// Whatever is commented out is accepted too, where its choice is made.
TEST(Template, EveryEntryIsAcceptedByTheReader)
{
  for_each_entry(
      [&](const std::string &, const Section &section, const Entry &entry)
      {
        EXPECT_EQ(entry.pattern->problem(entry.example), "") << section.name() << entry.name;
        if (!entry.default_value.empty())
        {
          EXPECT_EQ(entry.pattern->problem(entry.default_value), "") << entry.name;
        }
      });
  // All alternatives of the scene at once, one after the other.
  for (const std::vector<std::string> &change :
       {std::vector<std::string>{"Projectile/Nose length=", "Projectile/Caliber radius head=3"},
        {"Projectile/Mass=", "Projectile/Density=7850 kg/m3"},
        {"Projectile/Model=peridynamic nose", "Projectile/Young's modulus=202 GPa",
         "Projectile/Poisson's ratio=0.3", "Projectile/Grid spacing=1 mm",
         "Projectile/Peridynamic length=12 mm"},
        {"Material PMMA/Bulk modulus=", "Material PMMA/Shear modulus=",
         "Material PMMA/Young's modulus=6.01 GPa", "Material PMMA/Poisson's ratio=0.33"}})
    EXPECT_NO_THROW(
        read_scene(ParameterFile::from_text(template_text(), "mine.prm", parse_overrides(change))))
        << change.back();
}

TEST(Template, StudyAndExperimentAreFilesOfTheirOwn)
{
  const Folder folder;
  folder.write("base.prm", scene_text);
  const std::string study      = uncommented_from("# A study"),
                    experiment = study.substr(study.find("A stability"));
  const auto study_part        = study.substr(study.find("# Several runs"));
  const auto read =
      read_study(folder.write("study.prm", study_part.substr(0, study_part.find("A stability"))));
  EXPECT_EQ(read.cases.size(), 1U);
  const auto stability = ParameterFile::from_text(
      experiment.substr(experiment.find("# What the experiment")), "noise.prm");
  EXPECT_TRUE(is_stability_file(stability));
  EXPECT_EQ(read_stability(stability).n_steps, 2000);
}

TEST(Schema, HasEachEntryThatTheReaderKnows)
{
  std::ostringstream text;
  print_schema(text);
  const Json schema = Json::parse(text.str());
  std::set<std::string> described, known;
  for (const auto &entry : schema.at("entries"))
  {
    const std::string name = entry.at("file").get<std::string>() + ": " +
                             entry.at("section").get<std::string>() + "/" +
                             entry.at("name").get<std::string>();
    EXPECT_TRUE(described.insert(name).second) << name << " is described twice";
    for (const char *key : {"meaning", "type", "default", "example", "required", "rules"})
      EXPECT_TRUE(entry.contains(key)) << name << " without " << key;
  }
  for_each_entry([&](const std::string &file, const Section &section, const Entry &entry)
                 { known.insert(file + ": " + section.name() + "/" + entry.name); });
  EXPECT_EQ(described, known);

  std::set<std::string> sections;
  for (const auto &section : schema.at("sections"))
    if (section.at("repeats"))
      sections.insert(section.at("name"));
  EXPECT_EQ(sections, (std::set<std::string>{"Plate 1", "Material PMMA"}));
}

TEST(Schema, SaysWhatAnEditorNeeds)
{
  std::ostringstream text;
  print_schema(text);
  const Json schema  = Json::parse(text.str());
  const auto entries = [&](const std::string &section, const std::string &name)
  {
    for (const auto &entry : schema.at("entries"))
      if (entry.at("section") == section && entry.at("name") == name)
        return entry;
    return Json();
  };
  const Json spacing = entries("Plate 1", "Grid spacing");
  EXPECT_EQ(spacing.at("type"), "quantity");
  EXPECT_EQ(spacing.at("dimension"), "length");
  EXPECT_EQ(spacing.at("units"), Json({"um", "mm", "cm", "m", "in"}));
  EXPECT_EQ(spacing.at("limit"), "positive");
  EXPECT_EQ(spacing.at("required"), true);
  EXPECT_TRUE(spacing.at("default").is_null());

  const Json size = entries("Plate 1", "Size");
  EXPECT_EQ(size.at("type"), "quantities");
  EXPECT_EQ(size.at("components"), Json({"length", "width", "thickness"}));
  const Json influence = entries("Plate 1", "Influence function");
  EXPECT_EQ(influence.at("type"), "choice");
  EXPECT_EQ(influence.at("values"), Json({"cone", "constant", "gaussian", "inverse"}));
  EXPECT_EQ(influence.at("default"), "cone");
  EXPECT_EQ(entries("", "Symmetric").at("type"), "flag");
  EXPECT_EQ(entries("Output", "Directory").at("default"), "output/<file>");

  const Json nose = entries("Projectile", "Nose length").at("rules");
  ASSERT_EQ(nose.size(), 2U); // of an ogive and of a cone
  EXPECT_EQ(nose[0].at("one_of"), Json::parse(R"([["Nose length"], ["Caliber radius head"]])"));
  EXPECT_EQ(nose[0].at("if"), Json::parse(R"({"entry": "Nose shape", "values": ["ogive"]})"));
}
} // namespace
} // namespace ricochet::tests
