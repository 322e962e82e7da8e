// SPDX-License-Identifier: LGPL-2.1-or-later
// V28: the same event told in another way has the same course, and another event has not. Similar
// scenes are in simulation/test_similarity.cc, ranks in simulation/test_rank_independence.cc,
// frames in commands/test_run.cc.
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/history_record.h"
#include "support/verification.h"

#include <algorithm>
#include <cmath>

namespace ricochet::tests
{
namespace
{
/// A file as its sections, each with the lines between its first and its last.
using Sections = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// Nothing in it is its own mirror image.
const Sections oblique_ball{
    {"", {"Symmetric = false"}},
    {"Projectile", {"Nose shape = sphere", "Diameter = 6 mm", "Density = 7850 kg/m3"}},
    {"Impact",
     {"Speed = 300 m/s", "Incidence angle = 60 deg", "Entry point = 10 mm, 2 mm",
      "Clearance = 0.1 mm"}},
    {"Plate 1",
     {"Size = 24 mm, 16 mm, 5 mm", "Grid spacing = 1 mm", "Material = PMMA",
      "Hole = 17 mm, -4 mm, 3 mm"}},
    {"Plate 2", {"Size = 24 mm, 16 mm, 4 mm", "Grid spacing = 1 mm", "Material = weak PMMA"}},
    {"Material PMMA",
     {"Density = 1190 kg/m3", "Bulk modulus = 5.9 GPa", "Shear modulus = 2.258 GPa",
      "Critical stretch = 0.01"}},
    {"Material weak PMMA",
     {"Density = 1190 kg/m3", "Bulk modulus = 5.9 GPa", "Shear modulus = 2.258 GPa",
      "Critical stretch = 0.007"}},
    {"Contact",
     {"Friction law = constant", "Static friction = 0.3", "Debris friction factor = 0.5"}},
    {"Time", {"Final time = 1 ms"}}};

Scene scene_of(const Sections &sections)
{
  std::string text;
  for (const auto &[name, entries] : sections)
  {
    text += name.empty() ? "" : "subsection " + name + "\n";
    for (const auto &entry : entries)
      text += "set " + entry + "\n";
    text += name.empty() ? "" : "end\n";
  }
  return read_scene(ParameterFile::from_text(text, "metamorphic.prm"));
}

/// The same file with one entry changed.
Sections with(Sections sections, const std::string &section, const std::string &entry)
{
  const auto name_of = [](const std::string &line) { return line.substr(0, line.find(" =")); };
  for (auto &[name, entries] : sections)
    if (name == section)
    {
      entries.erase(std::remove_if(entries.begin(), entries.end(),
                                   [&](const std::string &line)
                                   { return name_of(line) == name_of(entry); }),
                    entries.end());
      entries.push_back(entry);
    }
  return sections;
}

constexpr int n_steps = 100, interval = 10;

/// Records of the history; with `look`, energies are asked for in every step.
std::vector<std::vector<double>> course_of(const Scene &scene, const bool look = false)
{
  Simulation simulation(MPI_COMM_WORLD, scene);
  std::vector<std::vector<double>> records;
  for (int step = 0; step <= n_steps; ++step)
  {
    const bool due = step % interval == 0;
    simulation.compute_forces(due || look);
    if (look)
      totals_of(simulation);
    if (due)
    {
      const Totals totals = totals_of(simulation);
      records.push_back(history_record({simulation, totals}));
    }
    simulation.advance();
  }
  EXPECT_GT(simulation.broken_bonds(), 1000.) << "too few for a hard test";
  return records;
}

/// Of all numbers of two courses.
double n_different(const std::vector<std::vector<double>> &one,
                   const std::vector<std::vector<double>> &other)
{
  double n = 0.;
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t c = 0; c < one[i].size(); ++c)
      n += one[i][c] != other[i][c];
  return n;
}

TEST(V28Metamorphic, OtherUnitsOfTheSameQuantitiesChangeNoBit)
{
  const auto course = course_of(scene_of(oblique_ball));
  Sections sections = oblique_ball;
  for (const auto &[section, entry] : std::vector<std::pair<std::string, std::string>>{
           {"Projectile", "Diameter = 0.6 cm"},
           {"Projectile", "Density = 7.85 g/cm3"},
           {"Impact", "Speed = 0.3 km/s"},
           {"Impact", "Entry point = 10000 um, 0.002 m"},
           {"Impact", "Clearance = 100 um"},
           {"Plate 1", "Size = 2.4 cm, 16 mm, 5000 um"},
           {"Plate 1", "Grid spacing = 1000 um"},
           {"Plate 2", "Size = 24 mm, 0.016 m, 0.4 cm"},
           {"Material PMMA", "Density = 1.19 g/cm3"},
           {"Material PMMA", "Bulk modulus = 5900 MPa"},
           {"Material PMMA", "Shear modulus = 2258000 kPa"},
           {"Time", "Final time = 1000 us"}})
    sections = with(sections, section, entry);
  verify_at_most("V28", "units: numbers of the history that differ if the file has other units",
                 n_different(course, course_of(scene_of(sections))), 0.);
  // One digit of one of them.
  verify_at_least(
      "V28", "units: the same if one quantity is not the same",
      n_different(course, course_of(scene_of(with(sections, "Impact", "Speed = 0.3001 km/s")))),
      100.);
}

TEST(V28Metamorphic, TheOrderOfSectionsAndEntriesChangesNoBit)
{
  const auto course = course_of(scene_of(oblique_ball));
  Sections sections(oblique_ball.begin() + 1, oblique_ball.end());
  std::reverse(sections.begin(), sections.end());
  for (auto &[name, entries] : sections)
    std::rotate(entries.begin(), entries.begin() + 1, entries.end());
  sections.insert(sections.begin(), oblique_ball.front()); // what is outside sections comes first
  verify_at_most("V28", "order: numbers of the history that differ if the file is turned round",
                 n_different(course, course_of(scene_of(sections))), 0.);
  // The numbers of plates are no order of the file.
  Sections swapped = oblique_ball;
  std::swap(swapped[3].first, swapped[4].first);
  verify_at_least("V28", "order: the same if the plates are",
                  n_different(course, course_of(scene_of(swapped))), 100.);
}

TEST(V28Metamorphic, LookingAtEnergiesChangesNoBit)
{
  const Scene scene = scene_of(oblique_ball);
  verify_at_most("V28", "output: numbers of the history that differ if every step is recorded",
                 n_different(course_of(scene), course_of(scene, /*look=*/true)), 0.);
}

/// Largest difference between the flights of a projectile and its mirror image, in units of the
/// impact's speed; axial vectors turn over in x and z.
double flight_difference(const std::vector<std::vector<double>> &one,
                         const std::vector<std::vector<double>> &other, const std::size_t n_records)
{
  const auto columns = history_columns();
  double largest     = 0.;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].name.rfind("velocity ", 0) == 0)
      for (std::size_t i = 0; i < n_records; ++i)
      {
        const double sign = columns[c].name == "velocity y" ? -1. : 1.;
        largest           = std::max(largest, std::abs(one[i][c] - sign * other[i][c]) / 300.);
      }
  return largest;
}

double time_step_of(const Scene &scene)
{
  return Simulation(MPI_COMM_WORLD, scene).dt();
}

TEST(V28Metamorphic, TheMirrorImageOfASceneHasTheMirrorImageOfItsCourse)
{
  // The plate is its own image: the time step, which is searched with a vector that is not, is the
  // same.
  const Sections here   = with(oblique_ball, "Plate 1", "Hole ="),
                 there  = with(here, "Impact", "Entry point = 10 mm, -2 mm"),
                 beside = with(here, "Impact", "Entry point = 10 mm, -2.001 mm");
  const auto course = course_of(scene_of(here)), mirrored = course_of(scene_of(there));
  // Sums over bonds run the other way: rounding, which fracture lets grow.
  verify_at_most("V28", "mirror: difference of the velocities after 10 steps",
                 flight_difference(course, mirrored, 2), 1e-14);
  verify_at_most("V28", "mirror: the same after 100 steps",
                 flight_difference(course, mirrored, course.size()), 1e-12);
  verify_at_least("V28", "mirror: the same if the entry point is a micrometre beside",
                  flight_difference(course, course_of(scene_of(beside)), course.size()), 1e-7);
  // A hole is on the other side then, and the search for the time step sees it from there.
  const double with_hole    = time_step_of(scene_of(oblique_ball));
  const Sections hole_there = with(oblique_ball, "Plate 1", "Hole = 17 mm, 4 mm, 3 mm");
  verify_at_most("V28", "mirror: difference of the time steps of a plate with a hole",
                 std::abs(time_step_of(scene_of(hole_there)) / with_hole - 1.), 1e-4);
}
} // namespace
} // namespace ricochet::tests
