// SPDX-License-Identifier: LGPL-2.1-or-later
#include "declarations.h"

#include "ricochet/contact/contact_search.h"
#include "ricochet/contact/friction_laws.h"
#include "ricochet/coupling/coupling_method.h"
#include "ricochet/materials/bond_laws.h"
#include "ricochet/materials/influence_function.h"

namespace ricochet
{
namespace
{
using PatternPointer = std::shared_ptr<const EntryPattern>;

PatternPointer quantity(const Dimension dimension, const Limit limit,
                        const std::vector<std::string> &components = {})
{
  return std::make_shared<QuantityPattern>(dimension, limit, components);
}

PatternPointer quantity_list(const Dimension dimension, const Limit limit)
{
  return std::make_shared<QuantityPattern>(QuantityPattern::list(dimension, limit));
}

PatternPointer choice(const std::vector<std::string> &choices)
{
  return std::make_shared<ChoicePattern>(choices);
}

PatternPointer text(const std::string &expected)
{
  return std::make_shared<TextPattern>(expected);
}

PatternPointer flag()
{
  return choice({"true", "false"});
}

EntryDeclaration required(const std::string &name, const PatternPointer &pattern,
                          const std::string &example, const std::string &documentation)
{
  return {name, pattern, Presence::required, "", example, documentation};
}

EntryDeclaration with_default(const std::string &name, const PatternPointer &pattern,
                              const std::string &value, const std::string &documentation)
{
  return {name, pattern, Presence::optional, value, value, documentation};
}

EntryDeclaration named_after_file(const std::string &name, const PatternPointer &pattern,
                                  const std::string &value, const std::string &example,
                                  const std::string &documentation)
{
  return {name, pattern, Presence::optional, value, example, documentation};
}

EntryDeclaration optional(const std::string &name, const PatternPointer &pattern,
                          const std::string &example, const std::string &documentation)
{
  return {name, pattern, Presence::optional, "", example, documentation};
}

std::vector<std::string> friction_law_names()
{
  std::vector<std::string> names;
  for (const auto &law : friction_laws())
    names.push_back(law.name);
  return names;
}

std::vector<std::string> influence_function_names()
{
  std::vector<std::string> names;
  for (const auto &function : influence_functions)
    names.push_back(function.name);
  return names;
}

std::vector<std::string> coupling_method_names()
{
  std::vector<std::string> names;
  for (const auto &method : coupling_methods)
    names.push_back(method.name);
  return names;
}

SectionDeclaration top(const std::string &stem)
{
  return {"",
          "",
          {named_after_file("Title", text("any text"), stem, "An oblique impact",
                            "What the run is called in its results, by default like the file"),
           with_default("Symmetric", flag(), "true",
                        "Whether only the half y > 0 is computed, mirrored at the plane y = 0")},
          {}};
}

SectionDeclaration projectile()
{
  return {
      "Projectile",
      "The projectile: a body of revolution.",
      {required("Nose shape", choice({"ogive", "cone", "hemisphere", "flat", "sphere"}), "ogive",
                "Shape of the nose in front of the cylindrical shank, or a whole sphere"),
       required("Diameter", quantity(Dimension::length, Limit::positive), "6.17 mm",
                "Diameter of the shank"),
       optional("Length", quantity(Dimension::length, Limit::positive), "27.6 mm",
                "Length from the base to the tip"),
       optional("Nose length", quantity(Dimension::length, Limit::positive), "10.23 mm",
                "Length of an ogive or cone, a part of the length"),
       optional("Caliber radius head", quantity(Dimension::number, Limit::positive), "3",
                "Instead of an ogive's nose length, the radius of its arc in diameters"),
       optional("Mass", quantity(Dimension::mass, Limit::positive), "5.25 g",
                "Mass of the whole projectile"),
       optional("Density", quantity(Dimension::density, Limit::positive), "7850 kg/m3",
                "Instead of the mass, the density of the homogeneous projectile"),
       with_default(
           "Model", choice({"rigid", "finite elements", "peridynamic nose", "peridynamic"}),
           "rigid", "Whether it deforms; all but the first are elastic and cost time steps"),
       optional("Young's modulus", quantity(Dimension::stress, Limit::positive), "202 GPa",
                "Of a deformable projectile, together with Poisson's ratio"),
       optional("Poisson's ratio", quantity(Dimension::number, Limit::not_negative), "0.3",
                "Of a deformable projectile, below 0.5"),
       optional("Grid spacing", quantity(Dimension::length, Limit::positive), "1 mm",
                "Distance between neighbouring points of a peridynamic projectile or nose"),
       optional("Peridynamic length", quantity(Dimension::length, Limit::positive), "12 mm",
                "How far a peridynamic nose reaches back from the tip, rounded to whole layers of "
                "elements; by default the nose length"),
       with_default(
           "Refinement", quantity(Dimension::number, Limit::positive), "2",
           "Of the generated mesh, which is also the skin of a peridynamic projectile: 1 to 4, "
           "each halves the edges"),
       optional("Mesh", text("a gmsh file in ASCII, relative to this file"), "projectile.msh",
                "Instead of the generated mesh, hexahedra of the same shape, tip towards x"),
       with_default("Mesh unit", choice({"m", "cm", "mm", "in"}), "mm",
                    "Unit of the coordinates in that file")},
      {{{{"Young's modulus", "Poisson's ratio"}},
        "Model",
        {"finite elements", "peridynamic nose", "peridynamic"}},
       {{{"Grid spacing"}}, "Model", {"peridynamic nose", "peridynamic"}},
       {{{"Length"}}, "Nose shape", {"ogive", "cone", "hemisphere", "flat"}},
       {{{"Nose length"}, {"Caliber radius head"}}, "Nose shape", {"ogive"}},
       {{{"Nose length"}}, "Nose shape", {"cone"}},
       {{{"Mass"}, {"Density"}}}}};
}

SectionDeclaration impact()
{
  return {
      "Impact",
      "How the projectile arrives.",
      {required("Speed", quantity(Dimension::speed, Limit::positive), "720 m/s",
                "Speed of the projectile before the impact"),
       required("Incidence angle", quantity(Dimension::angle, Limit::positive), "30 deg",
                "Angle between the velocity and the plate's surface, at most 90 deg"),
       with_default("Attack angle", quantity(Dimension::angle, Limit::any), "0 deg",
                    "Angle between the projectile's axis and its velocity, nose up positive"),
       required("Entry point", quantity(Dimension::length, Limit::any, {"x", "y"}), "50 mm, 0 mm",
                "Where the projectile touches the plate first, from the near edge and from the "
                "mid-plane"),
       with_default("Clearance", quantity(Dimension::length, Limit::not_negative), "0.05 mm",
                    "Distance between the projectile's lowest point and the plate at the "
                    "start")},
      {}};
}

SectionDeclaration plate(const unsigned int number)
{
  return {"Plate " + std::to_string(number),
          "The plates are numbered from top to bottom: Plate 1, Plate 2 and so on.",
          {required("Size",
                    quantity(Dimension::length, Limit::positive, {"length", "width", "thickness"}),
                    "200 mm, 100 mm, 30 mm",
                    "Extent along the flight, across it in full, and downwards"),
           required("Grid spacing", quantity(Dimension::length, Limit::positive), "1.5 mm",
                    "Distance between neighbouring points"),
           with_default("Horizon ratio", quantity(Dimension::number, Limit::positive), "3",
                        "Horizon in grid spacings, at least 2"),
           with_default("Influence function", choice(influence_function_names()), "cone",
                        "Weight of a bond over its length"),
           required("Material", text("the NAME of a section 'Material NAME'"), "PMMA",
                    "Material of the plate"),
           with_default("Gap", quantity(Dimension::length, Limit::not_negative), "0 mm",
                        "Distance to the plate above; 0 for the first plate"),
           optional("Zone box",
                    quantity(Dimension::length, Limit::any, {"x from", "x to", "y from", "y to"}),
                    "30 mm, 170 mm, -24 mm, 24 mm",
                    "With 'Coupling/Zone = boxes', the column through the plate that is "
                    "peridynamic"),
           optional("Zone box 2",
                    quantity(Dimension::length, Limit::any, {"x from", "x to", "y from", "y to"}),
                    "30 mm, 170 mm, -24 mm, 24 mm", "Another such column"),
           with_default("Non-reflecting edges", flag(), "false",
                        "Whether waves leave through the plate's side faces instead of coming "
                        "back, as in a larger plate; finite elements must carry these faces")},
          {}};
}

SectionDeclaration material(const std::string &name)
{
  return {"Material " + name,
          "A material, used by the plates that name it.",
          {with_default("Bond model", choice(bond_law_names()), "linear peridynamic solid",
                        "Force law of the bonds"),
           required("Density", quantity(Dimension::density, Limit::positive), "1190 kg/m3",
                    "Mass per volume"),
           optional("Bulk modulus", quantity(Dimension::stress, Limit::positive), "5.9 GPa",
                    "Bulk modulus, together with the shear modulus"),
           optional("Shear modulus", quantity(Dimension::stress, Limit::positive), "2.258 GPa",
                    "Shear modulus"),
           optional("Young's modulus", quantity(Dimension::stress, Limit::positive), "6.01 GPa",
                    "Instead of these moduli, Young's modulus, together with Poisson's ratio"),
           optional("Poisson's ratio", quantity(Dimension::number, Limit::any), "0.33",
                    "Poisson's ratio between -1 and 0.5"),
           optional("Critical stretch", quantity(Dimension::number, Limit::positive), "0.0105",
                    "Relative elongation at which a bond breaks"),
           optional("Energy release rate", quantity(Dimension::surface_energy, Limit::positive),
                    "500 J/m2",
                    "Instead of the critical stretch, the energy that a unit of crack area takes"),
           optional("Relaxation shares", quantity_list(Dimension::number, Limit::positive),
                    "0.146, 0.541",
                    "Shares of the shear modulus, which is the one of a sudden load, that relax; "
                    "without them the material is elastic"),
           optional("Relaxation times", quantity_list(Dimension::time, Limit::positive),
                    "15.3 s, 95.4 us", "Relaxation times that belong to the shares"),
           with_default("History precision", choice({"single", "double"}), "single",
                        "Floating-point numbers that hold the strain history of the bonds")},
          {{{{"Bulk modulus", "Shear modulus"}, {"Young's modulus", "Poisson's ratio"}}},
           {{{"Critical stretch"}, {"Energy release rate"}}}}};
}

/// What sections Coupling and Stability share: the tie between points and elements, and the
/// elements.
std::vector<EntryDeclaration> interface_entries()
{
  return {with_default("Method", choice(coupling_method_names()), "calibrated energy blend",
                       "What ties points and elements together"),
          with_default("Blend function", choice({"linear", "cubic"}), "cubic",
                       "Fall of the weight over the blend; of the energy and force blends only"),
          with_default("Blend width", quantity(Dimension::number, Limit::positive), "2",
                       "Width of the blend in horizons; of the energy and force blends only"),
          with_default("Mass correction", flag(), "true",
                       "Whether the elements next to the zone get their consistent mass, to first "
                       "order: waves pass the interface better"),
          with_default("Element size", choice({"1", "2", "4"}), "2",
                       "Edge of the elements next to the zone, in grid spacings; 1 halves the time "
                       "step, 4 keeps out waves of four horizons and less"),
          with_default("Quadrature", choice({"one point", "full"}), "one point",
                       "Integration of the elements away from the zone: one point with hourglass "
                       "control, or 2 x 2 x 2 points"),
          with_default("Hourglass coefficient", quantity(Dimension::number, Limit::not_negative),
                       "1",
                       "Stiffness of the hourglass modes; 1 gives pure bending its exact energy, 0 "
                       "switches the control off")};
}

/// Both, in this order.
std::vector<EntryDeclaration> joined(std::vector<EntryDeclaration> first,
                                     const std::vector<EntryDeclaration> &second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

SectionDeclaration coupling()
{
  return {
      "Coupling",
      "Peridynamics only where it breaks: which part of the plates is peridynamic (the zone), and "
      "how the finite elements around it are tied to it.",
      joined(
          {with_default("Zone", choice({"everything", "automatic", "boxes", "none"}), "everything",
                        "Part of the plates that is peridynamic: everything, the corridor that the "
                        "impact will damage, the boxes given with the plates, or none (elastic "
                        "finite elements alone)"),
           with_default("Adaptive", flag(), "false",
                        "Whether the zone grows ahead of damage; an automatic zone then starts "
                        "small, around the entry point"),
           with_default("Growth", choice({"corridor", "plate"}), "corridor",
                        "How far an adaptive zone may grow: as wide as the corridor of the impact "
                        "and no further than a little ahead of the projectile, or in the whole "
                        "plate after every crack, which is dear"),
           with_default("Conversion stretch", quantity(Dimension::number, Limit::fraction), "0.5",
                        "Stretch of a bond near the interface, in critical stretches, at which an "
                        "adaptive zone grows; a fixed one is reported as reached"),
           with_default("Coarsening levels", choice({"automatic", "0", "1", "2"}), "automatic",
                        "How often the elements double their size away from the zone; automatic: "
                        "as often as the number of points allows, up to 8 grid spacings")},
          interface_entries()),
      {}};
}

SectionDeclaration stability()
{
  return {
      "Stability",
      "A stability experiment instead of an impact: a block of points in a box of elements, "
      "released from noise and left alone.",
      joined(
          interface_entries(),
          {with_default("Calibration tolerance", quantity(Dimension::number, Limit::positive),
                        "0.0002",
                        "Largest nodal force left under a unit strain, in units of M h^2"),
           with_default("Calibration iterations", quantity(Dimension::number, Limit::not_negative),
                        "300", "Steps of conjugate gradients, at most"),
           with_default("Clipping", flag(), "true",
                        "Whether negative eigenvalues of calibrated tensors are raised to zero"),
           with_default("Grid spacing", quantity(Dimension::length, Limit::positive), "1 mm",
                        "Distance between neighbouring points"),
           with_default("Horizon ratio", quantity(Dimension::number, Limit::positive), "3",
                        "Horizon in grid spacings, at least 2"),
           with_default("Influence function", choice(influence_function_names()), "cone",
                        "Weight of a bond over its length"),
           with_default("Density", quantity(Dimension::density, Limit::positive), "1190 kg/m3",
                        "Mass per volume"),
           with_default("Young's modulus", quantity(Dimension::stress, Limit::positive), "6 GPa",
                        "Young's modulus"),
           with_default("Poisson's ratio", quantity(Dimension::number, Limit::any), "0.35",
                        "Poisson's ratio between -1 and 0.5"),
           with_default("Zone half-width", quantity(Dimension::number, Limit::positive), "4",
                        "Half the edge of the block of free points, in spacings"),
           with_default("Margin", quantity(Dimension::number, Limit::positive), "4",
                        "Elements around all points, in spacings"),
           with_default(
               "Limit", choice({"measured", "predicted"}), "measured",
               "Largest stable step: measured by power iteration of the body, or predicted "
               "from plane waves in lattice and elements"),
           with_default("Time step", quantity(Dimension::number, Limit::positive), "0.9",
                        "Time step in units of the limit"),
           with_default("Steps", quantity(Dimension::number, Limit::positive), "2000",
                        "Number of time steps"),
           with_default("Jitter", quantity(Dimension::number, Limit::not_negative), "0",
                        "Random displacement of all points and nodes at the start, in spacings")}),
      {}};
}

SectionDeclaration contact()
{
  // Every law needs the static coefficient; Coulomb's constant law needs nothing else.
  std::vector<std::string> decaying_laws;
  for (const auto &name : friction_law_names())
    if (name != ConstantFriction::name)
      decaying_laws.push_back(name);

  return {
      "Contact",
      "Contact of the projectile with the plates, and of fragments with each other.",
      {with_default("Stiffness factor", quantity(Dimension::number, Limit::positive), "1",
                    "Penalty stiffness per point, in Young's moduli times grid spacing"),
       required("Friction law", choice(friction_law_names()), "exponential",
                "Friction coefficient over the sliding speed"),
       required("Static friction", quantity(Dimension::number, Limit::not_negative), "0.5",
                "Friction coefficient at rest"),
       optional("Kinetic friction", quantity(Dimension::number, Limit::not_negative), "0.05",
                "Friction coefficient at high speed; not used by the constant law"),
       optional("Friction decay", quantity(Dimension::slowness, Limit::not_negative), "0.01 s/m",
                "Decay of the coefficient with the speed; not used by the constant law"),
       with_default("Regularisation speed", quantity(Dimension::speed, Limit::positive), "5 m/s",
                    "Sliding speed below which the friction falls linearly to zero"),
       with_default("Shank resistance", quantity(Dimension::stress, Limit::not_negative), "500 MPa",
                    "Pressure of the plate on the shank, for its friction only"),
       with_default("Shank contact fraction", quantity(Dimension::number, Limit::fraction), "0.4",
                    "Share of the shank that touches the plate; 0 switches its friction off"),
       with_default("Debris stiffness factor", quantity(Dimension::number, Limit::not_negative),
                    "15",
                    "Repulsion of separated points, in units of the short-range stiffness; 0 "
                    "switches it off"),
       with_default("Debris friction factor", quantity(Dimension::number, Limit::not_negative), "0",
                    "Friction between plates and in debris, in units of the projectile's "
                    "coefficient; 0 switches it off"),
       with_default("Search method", choice(contact_search_names()), "linked cells",
                    "How separated points that touch are found; the result is the same")},
      {{{{"Kinetic friction", "Friction decay"}}, "Friction law", decaying_laws}}};
}

SectionDeclaration time()
{
  return {
      "Time",
      "How long and in which steps.",
      {required("Final time", quantity(Dimension::time, Limit::positive), "450 us",
                "The run ends here at the latest"),
       with_default("Safety factor", quantity(Dimension::number, Limit::positive), "0.7",
                    "Time step in units of the largest stable one, at most 1"),
       with_default("Stop early", flag(), "true",
                    "Whether the run ends as soon as the outcome is decided"),
       with_default("Free time", quantity(Dimension::time, Limit::positive), "5 us",
                    "The outcome is decided when the projectile was free of contact this long")},
      {}};
}

SectionDeclaration output(const std::string &stem)
{
  return {"Output",
          "What is written, and where.",
          {named_after_file("Directory", text("a folder, relative to where the program is started"),
                            "output/" + stem, "output/oblique_impact",
                            "Where the results go, by default output/ and the file's name"),
           with_default("Frame interval", quantity(Dimension::time, Limit::not_negative), "20 us",
                        "Time between two frames of all points; 0 us for none"),
           with_default("History interval", quantity(Dimension::time, Limit::positive), "2 us",
                        "Time between two rows of the history"),
           with_default("ParaView files", flag(), "true",
                        "Whether the frames are written for ParaView"),
           with_default("Pictures", flag(), "true", "Whether pictures are drawn at the end"),
           optional("Picture times", quantity_list(Dimension::time, Limit::not_negative),
                    "45 us, 94 us, 142 us",
                    "Times of the section's picture, ascending; the summary says where the "
                    "projectile is then. By default six from the first to the last frame")},
          {}};
}
} // namespace

std::vector<SectionDeclaration> scene_declarations(const std::string &stem,
                                                   const unsigned int n_plates,
                                                   const std::vector<std::string> &materials)
{
  std::vector<SectionDeclaration> sections{top(stem), projectile(), impact()};
  for (unsigned int number = 1; number <= n_plates; ++number)
    sections.push_back(plate(number));
  for (const auto &name : materials)
    sections.push_back(material(name));
  sections.push_back(coupling());
  sections.push_back(contact());
  sections.push_back(time());
  sections.push_back(output(stem));
  return sections;
}

std::vector<SectionDeclaration> stability_declarations(const std::string &stem)
{
  return {
      {"",
       "",
       {named_after_file("Title", text("any text"), stem, "A stability experiment",
                         "What the experiment is called in its results, by default like the "
                         "file")},
       {}},
      stability(),
      {"Output",
       "Where the results go.",
       {named_after_file("Directory", text("a folder, relative to where the program is started"),
                         "output/" + stem, "output/stability",
                         "Where the results go, by default output/ and the file's name")},
       {}}};
}

std::vector<SectionDeclaration> study_declarations(const std::string &stem)
{
  SectionDeclaration study{
      "Study",
      "Several runs: every scene with the axes' values.",
      {named_after_file("Title", text("any text"), stem, "A study",
                        "What the study is called in its results, by default like the file"),
       required("Scenes", text("parameter files separated by commas, relative to this file"),
                "base.prm", "The scenes to run"),
       named_after_file(
           "Output directory", text("a folder, relative to where the program is started"),
           "output/" + stem, "output/study",
           "Where the results go, one folder per case; by default output/ and the file's name"),
       optional("Columns", text("names of columns separated by commas"), "outcome, exit_speed_m_s",
                "Columns of the table of results: entries of summary.json"),
       with_default("Combine", choice({"all", "one at a time"}), "all",
                    "Whether the axes' values are combined, or each scene is run as it is and then "
                    "with one value of one axis at a time"),
       optional("Settings", text("Section/Entry: value; Section/Entry: value"),
                "Output/Pictures: false; Output/ParaView files: false",
                "Entries that all cases share"),
       optional("Reference", text("one of the scenes"), "base.prm",
                "The scene that the others are compared with, under the same values of the axes: "
                "outcome, path, exit speed, cost"),
       optional("Ensemble", text("axes separated by commas"), "Axis 2",
                "With a reference: axes that only repeat a run, for its scatter; runs that differ "
                "in them alone are taken together"),
       with_default("Pictures", flag(), "true",
                    "Whether a comparison of the first eight cases is drawn at the end; with a "
                    "reference also a chart of accuracy against cost")},
      {}};
  for (int number = 1; number <= most_axes; ++number)
    study.entries.push_back(optional(
        "Axis " + std::to_string(number), text("Section/Entry: value | value"),
        "Plate 1/Grid spacing: 1.5 mm | 1.0 mm",
        "An entry of the scenes and the values it takes; several entries, with commas between "
        "them, take the same value or one each: 'value; value | value; value'"));
  return {study};
}
} // namespace ricochet
