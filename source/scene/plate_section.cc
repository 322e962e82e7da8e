// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plate_cutouts.h"
#include "ricochet/base/units.h"
#include "ricochet/scene/text_tools.h"
#include "sections.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet
{
namespace
{
/// The rows that checks speak of, and the zone boxes before it is known which are given.
struct PlateEntries
{
  PlateParameters &plate;
  const Scene &scene;
  CutoutRows cutouts;
  std::array<std::array<double, 4>, 2> boxes = {};
  std::array<const Entry *, 2> box           = {};
  const Entry *size = nullptr, *spacing = nullptr, *horizon = nullptr, *material = nullptr,
              *gap = nullptr, *absorbing = nullptr, *clamp_width = nullptr,
              *joint_tension = nullptr, *joint_shear = nullptr;

  void read_zone_boxes() const;
  void check_edges() const;
  void check_horizon() const;
  void check_number_of_points() const;
  void check_clamps() const;
  void check_gap() const;
  void check_joint() const;
  void check_material() const;
};

/// Three digits, so that it can be typed, and not above the value.
std::string at_most(const double length)
{
  const double mm   = length / units::mm * (1. + 1e-12);
  const double step = std::pow(10., std::floor(std::log10(mm)) - 2.);
  return number_text(std::floor(mm / step) * step) + " mm";
}

void PlateEntries::read_zone_boxes() const
{
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (box[i]->is_given())
    {
      const auto &[x_from, x_to, y_from, y_to] = boxes[i];
      if (x_from >= x_to || y_from >= y_to || x_from >= plate.length || x_to <= 0. ||
          y_from >= plate.width / 2. || y_to <= -plate.width / 2.)
        box[i]->fail("The box is empty or misses the plate.",
                     "x lies between 0 mm and " + in_mm(plate.length) + ", y between -" +
                         in_mm(plate.width / 2.) + " and " + in_mm(plate.width / 2.) +
                         ", from below to.");
      plate.zone_boxes.push_back(boxes[i]);
    }
}

void PlateEntries::check_edges() const
{
  if (plate.absorbing_edges && !scene.zone.has_elements())
    absorbing->fail("Only finite elements can let waves out.",
                    "Choose 'set Zone = automatic' or 'boxes' in the section 'Coupling', or leave "
                    "this entry out.");
}

void PlateEntries::check_horizon() const
{
  if (plate.horizon_ratio < 2.)
    horizon->fail("A horizon under 2 spacings does not hold a plate together.",
                  "Choose 2 or more; 3 is usual.");
  const double length = plate.horizon_ratio * plate.spacing;
  if (plate.thickness < length * (1. - 1e-9))
    size->fail(
        "The plate is thinner than its horizon, " + in_mm(length) + " (" +
            number_text(plate.horizon_ratio) + " grid spacings of " + in_mm(plate.spacing) + ").",
        "Choose a grid spacing of " + at_most(plate.thickness / plate.horizon_ratio) + " or less.");
}

void PlateEntries::check_number_of_points() const
{
  double n_points       = 1.;
  const double extent[] = {plate.length, scene.symmetric ? plate.width / 2. : plate.width,
                           plate.thickness};
  const char *axis[]    = {"length", scene.symmetric ? "half width" : "width", "thickness"};
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double n = std::round(extent[d] / plate.spacing);
    n_points *= n;
    if (n < 4.)
      spacing->fail("The " + std::string(axis[d]) + " of " + in_mm(extent[d]) + " holds " +
                        number_text(n) + " points; at least 4 are needed.",
                    "Choose a grid spacing of " + at_most(extent[d] / 4.) + " or less.");
  }
  constexpr double most = 2e9; // points are numbered with 32 bits
  if (n_points > most)
    spacing->fail("The plate would have " + number_text(n_points) + " points; the limit is " +
                      number_text(most) + ".",
                  "Choose a larger grid spacing.");
}

void PlateEntries::check_clamps() const
{
  const bool ends  = plate.clamped_sides == ClampedSides::ends,
             sides = plate.clamped_sides == ClampedSides::sides,
             all   = plate.clamped_sides == ClampedSides::all;
  if (clamp_width->is_given() && !ends && !sides && !all)
    clamp_width->fail("No edge of this plate is clamped.",
                      "Choose 'set Clamped edges = all', 'ends' or 'sides', or leave this out.");
  const double width = plate.held_width();
  if (((ends || all) && 2. * width >= plate.length) ||
      ((sides || all) && 2. * width >= plate.width))
    (clamp_width->is_given() ? clamp_width : size)
        ->fail("A frame of " + in_mm(width) + " leaves nothing of the plate free.",
               "The width is to be below half the plate's length and width.");
  if (plate.clamped_sides != ClampedSides::none && plate.absorbing_edges)
    absorbing->fail("Edges that are clamped send waves back.",
                    "Leave out one of 'Clamped edges' and 'Non-reflecting edges'.");
}

void PlateEntries::check_gap() const
{
  if (&plate == &scene.plates.front() && plate.gap != 0.)
    gap->fail("There is no plate above the first one.",
              "Remove the line; the gap belongs to the lower plate.");
}

void PlateEntries::check_joint() const
{
  if (joint_shear->is_given() && !plate.has_joint())
    joint_shear->fail("This plate is not joined to the one above.",
                      "Give an 'Joint strength', too, or leave this entry out.");
  if (!plate.has_joint())
    return;
  if (&plate == &scene.plates.front())
    joint_tension->fail("There is no plate above the first one.",
                        "Remove the line; the joint belongs to the lower plate.");
  if (plate.gap != 0.)
    joint_tension->fail("Plates that are joined lie on each other; there is a gap of " +
                            in_mm(plate.gap) + ".",
                        "Remove the gap, or this entry.");
  if (scene.zone.has_elements())
    joint_tension->fail("Only plates that are peridynamic throughout can be joined.",
                        "Choose 'set Zone = everything' in the section 'Coupling', or leave "
                        "this entry out.");
  const PlateParameters &above = *(&plate - 1); // plates are one list
  const auto differ = [](const double a, const double b) { return std::abs(a - b) > 1e-9 * a; };
  if (differ(plate.length, above.length) || differ(plate.width, above.width) ||
      differ(plate.spacing, above.spacing) || differ(plate.horizon_ratio, above.horizon_ratio))
    joint_tension->fail("Plates that are joined lie point on point; the one above is " +
                            in_mm(above.length) + " long, " + in_mm(above.width) +
                            " wide, with a grid spacing of " + in_mm(above.spacing) +
                            " and a horizon of " + number_text(above.horizon_ratio) + " spacings.",
                        "Give both the same length, width, 'Grid spacing' and 'Horizon ratio'.");
}

void PlateEntries::check_material() const
{
  std::vector<std::string> names;
  for (const auto &present : scene.materials)
    names.push_back(present.name);
  if (std::find(names.begin(), names.end(), plate.material) == names.end())
    material->fail("There is no section " + in_quotes(material_prefix + plate.material) +
                       guess(plate.material, names),
                   "The materials of this file are: " + joined(names) + ".");
}

/// Which part of the plate is peridynamic, and what happens at its edges.
void add_zone_entries(Section &in, PlateEntries &rows)
{
  const char *names[]    = {"Zone box", "Zone box 2"};
  const char *meanings[] = {"With 'Coupling/Zone = boxes', the column through the plate that is "
                            "peridynamic",
                            "Another such column"};
  for (int i = 0; i < 2; ++i)
  {
    auto &box   = rows.boxes[i];
    rows.box[i] = &in.optional(names[i],
                               quantities({&box[0], &box[1], &box[2], &box[3]},
                                          {"x from", "x to", "y from", "y to"}, Dimension::length,
                                          Limit::any),
                               "30 mm, 170 mm, -24 mm, 24 mm", meanings[i]);
  }
  rows.absorbing = &in.with_default(
      "Non-reflecting edges", flag(rows.plate.absorbing_edges), "false",
      "Whether waves leave through the plate's side faces instead of coming back, as in a larger "
      "plate; finite elements must carry these faces");
}

/// What ties it to the plate above.
void add_joint_entries(Section &in, PlateEntries &rows)
{
  rows.joint_tension = &in.optional(
      "Joint strength", quantity(rows.plate.joint_tension, Dimension::stress, Limit::positive),
      "20 MPa",
      "Tensile stress at which the joint to the plate above breaks; without it the two only touch");
  rows.joint_shear = &in.optional(
      "Joint shear strength", quantity(rows.plate.joint_shear, Dimension::stress, Limit::positive),
      "30 MPa", "Shear stress at which it breaks; without it the same as under tension");
}

/// What holds the plate.
void add_support_entries(Section &in, PlateEntries &rows)
{
  in.with_default(
      "Clamped edges",
      choice(rows.plate.clamped_sides, Words<ClampedSides>{{ClampedSides::none, "none"},
                                                           {ClampedSides::ends, "ends"},
                                                           {ClampedSides::sides, "sides"},
                                                           {ClampedSides::all, "all"}}),
      "none",
      "Which side faces are held: the ends of the flight, its sides, or all four; without "
      "any the plate is free");
  rows.clamp_width = &in.optional(
      "Clamp width", quantity(rows.plate.clamp_width, Dimension::length, Limit::positive), "10 mm",
      "Width of the frame that is held along the clamped edges; without it one horizon");
}
} // namespace

unsigned int number_in(const std::string &section, const std::string &kind)
{
  const std::string prefix = kind + " ";
  const std::string digits = section.substr(std::min(prefix.size(), section.size()));
  if (section.rfind(prefix, 0) != 0 || digits.empty() || digits.size() > 4 || digits[0] == '0' ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return 0;
  return static_cast<unsigned int>(std::stoul(digits));
}

Section plate_section(PlateParameters &plate, const unsigned int number, const Scene &scene)
{
  Section in("Plate " + std::to_string(number),
             "The plates are numbered from top to bottom: Plate 1, Plate 2 and so on.");
  const auto rows = std::make_shared<PlateEntries>(PlateEntries{plate, scene, {plate, scene}});
  rows->size      = &in.required(
           "Size",
           quantities({&plate.length, &plate.width, &plate.thickness}, {"length", "width", "thickness"},
                      Dimension::length, Limit::positive),
           "200 mm, 100 mm, 30 mm", "Extent along the flight, across it in full, and downwards");
  rows->spacing =
      &in.required("Grid spacing", quantity(plate.spacing, Dimension::length, Limit::positive),
                   "1.5 mm", "Distance between neighbouring points");
  rows->horizon = &in.with_default(
      "Horizon ratio", quantity(plate.horizon_ratio, Dimension::number, Limit::positive), "3",
      "Horizon in grid spacings, at least 2");
  in.with_default("Influence function",
                  choice(plate.influence_function, influence_function_words()), "cone",
                  "Weight of a bond over its length");
  rows->material =
      &in.required("Material", text(plate.material, "the NAME of a section 'Material NAME'"),
                   "PMMA", "Material of the plate");
  rows->gap = &in.with_default("Gap", quantity(plate.gap, Dimension::length, Limit::not_negative),
                               "0 mm", "Distance to the plate above; 0 for the first plate");
  add_zone_entries(in, *rows);
  add_joint_entries(in, *rows);
  add_support_entries(in, *rows);
  rows->cutouts.add_to(in);

  in.check([rows] { rows->read_zone_boxes(); });
  in.check([rows] { rows->check_horizon(); });
  in.check([rows] { rows->check_number_of_points(); });
  in.check([rows] { rows->cutouts.read(); });
  in.check_with_others([rows] { rows->check_edges(); });
  in.check_with_others([rows] { rows->check_clamps(); });
  in.check_with_others([rows] { rows->cutouts.check_with_others(); });
  in.check_with_others([rows] { rows->check_gap(); });
  in.check_with_others([rows] { rows->check_joint(); });
  in.check_with_others([rows] { rows->check_material(); });
  return in;
}
} // namespace ricochet
