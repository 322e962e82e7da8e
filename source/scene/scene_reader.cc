// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/scene_reader.h"

#include "coupling_reader.h"
#include "parameter_writer.h"
#include "parameters.h"
#include "ricochet/base/elastic_constants.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/units.h"
#include "ricochet/materials/bond_laws.h"
#include "ricochet/scene/mesh_file.h"
#include "ricochet/scene/stability_reader.h"
#include "text_tools.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace ricochet
{
namespace
{
/// Three digits, so that it can be typed, and not above the value.
std::string at_most(const double length)
{
  const double mm   = length / units::mm * (1. + 1e-12);
  const double step = std::pow(10., std::floor(std::log10(mm)) - 2.);
  return number_text(std::floor(mm / step) * step) + " mm";
}

std::string in_mm(const double length)
{
  return number_text(length / units::mm) + " mm";
}

/// 3 for "Plate 3", 0 for a name of another form.
unsigned int plate_number(const std::string &section)
{
  const std::string prefix = "Plate ";
  const std::string digits = section.substr(std::min(prefix.size(), section.size()));
  if (section.rfind(prefix, 0) != 0 || digits.empty() || digits.size() > 4 || digits[0] == '0' ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return 0;
  return static_cast<unsigned int>(std::stoul(digits));
}

unsigned int count_plates(const ParameterFile &file)
{
  std::vector<unsigned int> numbers;
  for (const auto &section : file.sections())
    if (section.in_file && plate_number(section.name) > 0)
      numbers.push_back(plate_number(section.name));
  std::sort(numbers.begin(), numbers.end());

  for (unsigned int i = 0; i < numbers.size(); ++i)
    if (numbers[i] != i + 1)
      for (const auto &section : file.sections())
        if (plate_number(section.name) == numbers[i])
          throw InputError(section.origin + ": There is a " + in_quotes(section.name) +
                           " but no 'Plate " + std::to_string(i + 1) +
                           "'.\n  Number the plates 1, 2, 3 and so on, from top to bottom.");
  return numbers.size();
}

/// The declared sections of this file: as many plates and materials as it has, at least one.
std::vector<SectionDeclaration> sections_of(const ParameterFile &file)
{
  const std::string prefix = "Material ";
  std::vector<std::string> materials;
  for (const auto &section : file.sections())
  {
    if (section.name == "Study")
      throw InputError(section.origin +
                       ": This file describes a study, not a scene.\n  Run it with 'ricochet "
                       "study'.");
    if (section.in_file && section.name == "Stability")
      throw InputError(section.origin +
                       ": This file describes a stability experiment, not a scene.\n  Run it with "
                       "'ricochet run'.");
    if (section.in_file && section.name.rfind(prefix, 0) == 0)
      materials.push_back(section.name.substr(prefix.size()));
  }
  // A file without materials gets those its plates ask for, or an example: the list of what is
  // missing then says what to write.
  if (materials.empty())
    for (const auto &entry : file.entries())
      if (plate_number(entry.section) > 0 && entry.name == "Material" && !entry.value.empty() &&
          std::find(materials.begin(), materials.end(), entry.value) == materials.end())
        materials.push_back(entry.value);
  if (materials.empty())
    materials.push_back("PMMA");
  return scene_declarations(std::filesystem::path(file.path()).stem().string(),
                            std::max(1U, count_plates(file)), materials);
}

NoseShape nose_shape(const std::string &name)
{
  // The pattern of the entry lets no other word through.
  static const std::map<std::string, NoseShape> shapes{{"ogive", NoseShape::ogive},
                                                       {"cone", NoseShape::cone},
                                                       {"hemisphere", NoseShape::hemisphere},
                                                       {"flat", NoseShape::flat},
                                                       {"sphere", NoseShape::sphere}};
  return shapes.at(name);
}

BodyOfRevolution::Shape read_shape(const Parameters &parameters)
{
  const std::string in   = "Projectile";
  const std::string name = parameters.text(in, "Nose shape");
  BodyOfRevolution::Shape shape{nose_shape(name), parameters.quantity(in, "Diameter"),
                                parameters.quantity(in, "Length"),
                                parameters.quantity(in, "Nose length")};

  const bool has_length = shape.nose == NoseShape::ogive || shape.nose == NoseShape::cone;
  for (const std::string entry : {"Length", "Nose length", "Caliber radius head"})
    if (parameters.is_given(in, entry) &&
        (entry == "Length"
             ? shape.nose == NoseShape::sphere
             : !has_length || (shape.nose == NoseShape::cone && entry == "Caliber radius head")))
      parameters.fail(in, entry, "The nose shape '" + name + "' does not have this entry.",
                      "Remove the line, or take an included one back with 'set " + entry + " ='.");

  if (parameters.is_given(in, "Caliber radius head"))
  {
    // A tangent ogive whose arc has the radius crh * d: (crh d)^2 = l^2 + (crh d - d/2)^2.
    const double crh = parameters.quantity(in, "Caliber radius head");
    if (crh < 0.5)
      parameters.fail(in, "Caliber radius head",
                      "The radius of a tangent ogive's arc is at least half the diameter.",
                      "Choose 0.5 (a hemisphere) or more.");
    shape.nose_length = shape.diameter * std::sqrt(crh - 0.25);
  }
  return shape;
}

/// The path of a file named by an entry: relative to the parameter file that names it.
std::filesystem::path path_in(const Parameters &parameters, const std::string &section,
                              const std::string &entry)
{
  const std::filesystem::path path = parameters.text(section, entry);
  const std::string origin         = parameters.origin(section, entry);
  const auto colon                 = origin.rfind(':');
  if (path.is_absolute() || colon == std::string::npos) // or of an override
    return path;
  return std::filesystem::path(origin.substr(0, colon)).parent_path() / path;
}

/// Of a peridynamic nose: at least the nose, for the elements behind it come in layers [m].
double read_peridynamic_length(const Parameters &parameters, const BodyOfRevolution::Shape &shape)
{
  const std::string in = "Projectile", entry = "Peridynamic length";
  std::ostringstream nose, whole;
  nose << 1e3 * shape.nose_length << " mm";
  whole << 1e3 * shape.length << " mm";
  if (shape.nose == NoseShape::sphere)
    parameters.fail(in, "Model", "A sphere is all nose: there is no shank of finite elements.",
                    "Choose 'finite elements' or 'peridynamic'.");
  if (!parameters.is_given(in, entry) && shape.nose == NoseShape::flat)
    parameters.fail(in, entry, "A flat nose has no length of its own.",
                    "Say how much of the " + whole.str() + " is peridynamic.");
  const double length =
      parameters.is_given(in, entry) ? parameters.quantity(in, entry) : shape.nose_length;
  if (length < shape.nose_length || length >= shape.length)
    parameters.fail(in, entry,
                    "The finite elements begin behind the nose of " + nose.str() +
                        " and before the base at " + whole.str() + ".",
                    "Choose a length between the two, or another 'Projectile/Model'.");
  return length;
}

/// What a deformable projectile needs besides its shape.
void read_deformable(const Parameters &parameters, ProjectileParameters &projectile)
{
  const std::string in = "Projectile", model = parameters.text(in, "Model");
  if (model != "peridynamic nose" && parameters.is_given(in, "Peridynamic length"))
    parameters.fail(in, "Peridynamic length",
                    "A projectile that is " + in_quotes(model) + " has none.",
                    "Remove the entry, or choose 'Model = peridynamic nose'.");
  if (model == "rigid")
    return;
  const std::map<std::string, ProjectileModel> models{
      {"finite elements", ProjectileModel::finite_elements},
      {"peridynamic nose", ProjectileModel::peridynamic_nose},
      {"peridynamic", ProjectileModel::peridynamic}};
  projectile.model = models.at(model);
  if (projectile.model == ProjectileModel::peridynamic_nose)
    projectile.peridynamic_length = read_peridynamic_length(parameters, projectile.shape);
  projectile.spacing        = parameters.quantity(in, "Grid spacing");
  projectile.youngs_modulus = parameters.quantity(in, "Young's modulus");
  projectile.poissons_ratio = parameters.quantity(in, "Poisson's ratio");
  if (!(projectile.poissons_ratio < 0.5))
    parameters.fail(in, "Poisson's ratio", "An elastic solid has a Poisson's ratio below 0.5.",
                    "Choose 0.3 for steel.");
  const double refinement = parameters.quantity(in, "Refinement");
  if (refinement != std::floor(refinement) || refinement > 4.)
    parameters.fail(in, "Refinement", "The mesh is refined a whole number of times.",
                    "Choose 1, 2, 3 or 4.");
  projectile.refinement = static_cast<int>(refinement);
  if (parameters.is_given(in, "Mesh"))
  {
    const std::map<std::string, double> units{
        {"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"in", 25.4e-3}};
    projectile.mesh =
        read_mesh(path_in(parameters, in, "Mesh"), units.at(parameters.text(in, "Mesh unit")));
  }
}

ProjectileParameters read_projectile(const Parameters &parameters)
{
  const BodyOfRevolution::Shape shape = read_shape(parameters);
  ProjectileParameters projectile;
  try
  {
    const BodyOfRevolution body(shape);
    const double mass = parameters.is_given("Projectile", "Mass")
                            ? parameters.quantity("Projectile", "Mass")
                            : parameters.quantity("Projectile", "Density") * body.volume();
    projectile.shape  = body.shape();
    projectile.mass   = mass;
  }
  catch (const InputError &error) // the body does not know which lines it comes from
  {
    const bool has_nose_length = parameters.is_given("Projectile", "Nose length");
    throw InputError(parameters.origin("Projectile", has_nose_length ? "Nose length" : "Length") +
                     ": " + error.what() +
                     "\n  Change the shape, the diameter or the lengths in the section "
                     "'Projectile'.");
  }
  read_deformable(parameters, projectile);
  return projectile;
}

PlateParameters read_plate(const Parameters &parameters, const std::string &in,
                           const bool symmetric)
{
  const auto size = parameters.quantities(in, "Size");
  PlateParameters plate{size[0],
                        size[1],
                        size[2],
                        parameters.quantity(in, "Gap"),
                        parameters.quantity(in, "Grid spacing"),
                        parameters.quantity(in, "Horizon ratio"),
                        InfluenceFunction::cone,
                        parameters.text(in, "Material")};
  for (const auto &choice : influence_functions)
    if (choice.name == parameters.text(in, "Influence function"))
      plate.influence_function = choice.function;

  for (const std::string entry : {"Zone box", "Zone box 2"})
    if (parameters.is_given(in, entry))
    {
      const auto box = parameters.quantities(in, entry);
      if (box[0] >= box[1] || box[2] >= box[3] || box[0] >= plate.length || box[1] <= 0. ||
          box[2] >= plate.width / 2. || box[3] <= -plate.width / 2.)
        parameters.fail(in, entry, "The box is empty or misses the plate.",
                        "x lies between 0 mm and " + in_mm(plate.length) + ", y between -" +
                            in_mm(plate.width / 2.) + " and " + in_mm(plate.width / 2.) +
                            ", from below to.");
      plate.zone_boxes.push_back({box[0], box[1], box[2], box[3]});
    }
  plate.absorbing_edges = parameters.flag(in, "Non-reflecting edges");
  if (plate.absorbing_edges && parameters.text("Coupling", "Zone") == "everything")
    parameters.fail(in, "Non-reflecting edges", "Only finite elements can let waves out.",
                    "Choose 'set Zone = automatic' or 'boxes' in the section 'Coupling', or leave "
                    "this entry out.");
  if (parameters.text("Coupling", "Zone") == "boxes" && plate.zone_boxes.empty())
    parameters.fail("Coupling", "Zone", "The section '" + in + "' has no 'Zone box'.",
                    "Give one for every plate, as 'set Zone box = 30 mm, 170 mm, -24 mm, 24 mm'.");

  if (plate.horizon_ratio < 2.)
    parameters.fail(in, "Horizon ratio",
                    "A horizon under 2 spacings does not hold a plate together.",
                    "Choose 2 or more; 3 is usual.");
  const double horizon = plate.horizon_ratio * plate.spacing;
  if (plate.thickness < horizon * (1. - 1e-9))
    parameters.fail(
        in, "Size",
        "The plate is thinner than its horizon, " + in_mm(horizon) + " (" +
            number_text(plate.horizon_ratio) + " grid spacings of " + in_mm(plate.spacing) + ").",
        "Choose a grid spacing of " + at_most(plate.thickness / plate.horizon_ratio) + " or less.");

  double n_points       = 1.;
  const double extent[] = {plate.length, symmetric ? plate.width / 2. : plate.width,
                           plate.thickness};
  const char *axis[]    = {"length", symmetric ? "half width" : "width", "thickness"};
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double n = std::round(extent[d] / plate.spacing);
    n_points *= n;
    if (n < 4.)
      parameters.fail(in, "Grid spacing",
                      "The " + std::string(axis[d]) + " of " + in_mm(extent[d]) + " holds " +
                          number_text(n) + " points; at least 4 are needed.",
                      "Choose a grid spacing of " + at_most(extent[d] / 4.) + " or less.");
  }
  constexpr double most = 2e9; // points are numbered with 32 bits
  if (n_points > most)
    parameters.fail(in, "Grid spacing",
                    "The plate would have " + number_text(n_points) + " points; the limit is " +
                        number_text(most) + ".",
                    "Choose a larger grid spacing.");
  return plate;
}

std::vector<PlateParameters> read_plates(const Parameters &parameters, const bool symmetric,
                                         const std::vector<MaterialParameters> &materials)
{
  std::vector<std::string> names;
  for (const auto &material : materials)
    names.push_back(material.name);

  std::vector<PlateParameters> plates;
  for (const auto &section : parameters.sections())
    if (plate_number(section.name) > 0)
    {
      const PlateParameters plate = read_plate(parameters, section.name, symmetric);
      if (plates.empty() && plate.gap != 0.)
        parameters.fail(section.name, "Gap", "There is no plate above the first one.",
                        "Remove the line; the gap belongs to the lower plate.");
      if (std::find(names.begin(), names.end(), plate.material) == names.end())
        parameters.fail(section.name, "Material",
                        "There is no section " + in_quotes("Material " + plate.material) +
                            guess(plate.material, names),
                        "The materials of this file are: " + joined(names) + ".");
      plates.push_back(plate);
    }
  return plates;
}

ImpactParameters read_impact(const Parameters &parameters, const bool symmetric,
                             const PlateParameters &plate)
{
  const std::string in = "Impact";
  const auto entry     = parameters.quantities(in, "Entry point");
  ImpactParameters impact{parameters.quantity(in, "Speed"),
                          parameters.quantity(in, "Incidence angle"),
                          parameters.quantity(in, "Attack angle"),
                          entry[0],
                          entry[1],
                          parameters.quantity(in, "Clearance")};

  constexpr double right_angle = 90. * units::deg * (1. + 1e-12);
  if (impact.incidence_angle > right_angle)
    parameters.fail(in, "Incidence angle", "The angle to the plate's surface is at most 90 deg.",
                    "90 deg is a shot straight down, 10 deg a grazing one.");
  if (std::abs(impact.attack_angle) >= 90. * units::deg)
    parameters.fail(in, "Attack angle", "The projectile would fly sideways or backwards.",
                    "Choose an angle between -90 deg and 90 deg.");
  if (impact.entry_x < 0. || impact.entry_x > plate.length ||
      std::abs(impact.entry_y) > plate.width / 2.)
    parameters.fail(in, "Entry point", "The point is not on the first plate.",
                    "x lies between 0 mm and " + in_mm(plate.length) + ", y between -" +
                        in_mm(plate.width / 2.) + " and " + in_mm(plate.width / 2.) + ".");
  if (symmetric && impact.entry_y != 0.)
    parameters.fail(in, "Entry point", "A symmetric model needs an entry point with y = 0 mm.",
                    "Set y to 0 mm, or compute the whole plate with 'set Symmetric = false'.");
  return impact;
}

RelaxationSeries read_relaxation(const Parameters &parameters, const std::string &in)
{
  const std::string shares = "Relaxation shares", times = "Relaxation times";
  for (const auto &[given, missing] : {std::pair{shares, times}, std::pair{times, shares}})
    if (parameters.is_given(in, given) && !parameters.is_given(in, missing))
      parameters.fail(in, given, "There are no '" + missing + "' that belong to them.",
                      "Add them, one for each, or remove the line.");
  if (!parameters.is_given(in, shares))
    return {};

  const auto share = parameters.quantities(in, shares), time = parameters.quantities(in, times);
  if (share.size() != time.size())
    parameters.fail(in, shares,
                    "There are " + std::to_string(share.size()) + " shares, but " +
                        std::to_string(time.size()) + " relaxation times.",
                    "Give as many of the one as of the other.");
  RelaxationSeries series;
  for (std::size_t k = 0; k < share.size(); ++k)
    series.push_back({share[k], time[k]});
  try
  {
    check_series(series);
  }
  catch (const InputError &error)
  {
    parameters.fail(in, shares, error.what(), "Change shares or times of the section.");
  }
  if (!bond_law(parameters.text(in, "Bond model")).has_dilatation)
    parameters.fail(in, shares,
                    "The bond model '" + parameters.text(in, "Bond model") +
                        "' has no shear modulus of its own that could relax.",
                    "Choose 'linear peridynamic solid', or remove the relaxation.");
  return series;
}

MaterialParameters read_material(const Parameters &parameters, const std::string &in)
{
  MaterialParameters material{in.substr(std::string("Material ").size()),
                              parameters.text(in, "Bond model"),
                              parameters.quantity(in, "Density"),
                              parameters.quantity(in, "Bulk modulus"),
                              parameters.quantity(in, "Shear modulus"),
                              parameters.quantity(in, "Critical stretch"),
                              parameters.quantity(in, "Energy release rate")};
  if (parameters.is_given(in, "Young's modulus"))
  {
    const double E  = parameters.quantity(in, "Young's modulus");
    const double nu = parameters.quantity(in, "Poisson's ratio");
    if (!(nu > -1. && nu < 0.5))
      parameters.fail(in, "Poisson's ratio", "No stable isotropic solid has this Poisson's ratio.",
                      "Choose a value between -1 and 0.5, both excluded.");
    material.bulk_modulus  = bulk_modulus(E, nu);
    material.shear_modulus = shear_modulus(E, nu);
  }

  material.relaxation = read_relaxation(parameters, in);
  if (parameters.text(in, "History precision") == "double")
    material.history_precision = HistoryPrecision::double_precision;

  const double nu = poissons_ratio(material.bulk_modulus, material.shear_modulus);
  if (bond_law(material.bond_model).fixes_poisson_ratio && std::abs(nu - 0.25) > 0.0025)
    parameters.fail(in, "Bond model",
                    "With this model Poisson's ratio is 0.25, but the moduli give " +
                        number_text(nu) + ".",
                    "Set the shear modulus to 0.6 times the bulk modulus, or Poisson's ratio to "
                    "0.25, or choose another model.");
  return material;
}

ZoneParameters read_zone(const Parameters &parameters)
{
  const std::string in = "Coupling";
  ZoneParameters zone;
  const std::map<std::string, ZoneKind> kinds{{"everything", ZoneKind::everything},
                                              {"automatic", ZoneKind::automatic},
                                              {"boxes", ZoneKind::boxes},
                                              {"none", ZoneKind::none}};
  zone.kind                  = kinds.at(parameters.text(in, "Zone"));
  zone.adaptive              = parameters.flag(in, "Adaptive");
  zone.grows_everywhere      = zone.adaptive && parameters.text(in, "Growth") == "plate";
  zone.conversion_stretch    = parameters.quantity(in, "Conversion stretch");
  zone.coupling              = read_coupling(parameters, in);
  const std::string levels   = parameters.text(in, "Coarsening levels");
  zone.coarsening_levels     = levels == "automatic" ? -1 : std::stoi(levels);
  zone.full_quadrature       = parameters.text(in, "Quadrature") == "full";
  zone.hourglass_coefficient = parameters.quantity(in, "Hourglass coefficient");

  if (zone.adaptive && (zone.kind == ZoneKind::everything || zone.kind == ZoneKind::none))
    parameters.fail(in, "Adaptive",
                    "There is no zone that could grow: the zone is '" +
                        parameters.text(in, "Zone") + "'.",
                    "Choose 'set Zone = automatic' or 'boxes', or 'set Adaptive = false'.");
  return zone;
}

ContactParameters read_contact(const Parameters &parameters)
{
  const std::string in = "Contact";
  const FrictionParameters friction{
      parameters.text(in, "Friction law"), parameters.quantity(in, "Static friction"),
      parameters.quantity(in, "Kinetic friction"), parameters.quantity(in, "Friction decay"),
      parameters.quantity(in, "Regularisation speed")};
  if (parameters.quantity(in, "Debris friction factor") > 0. &&
      parameters.quantity(in, "Debris stiffness factor") == 0.)
    parameters.fail(in, "Debris friction factor",
                    "Separated points that do not repel have nothing to rub against.",
                    "Set 'Debris stiffness factor' above 0 (15 is usual), or this one to 0.");
  return {parameters.quantity(in, "Stiffness factor"),
          friction,
          parameters.quantity(in, "Shank resistance"),
          parameters.quantity(in, "Shank contact fraction"),
          parameters.quantity(in, "Debris stiffness factor"),
          parameters.quantity(in, "Debris friction factor"),
          parameters.text(in, "Search method")};
}

TimeParameters read_time(const Parameters &parameters)
{
  const std::string in = "Time";
  if (parameters.quantity(in, "Safety factor") > 1.)
    parameters.fail(in, "Safety factor", "Steps above the stable one make the solution explode.",
                    "Choose a value above 0 and not above 1; 0.8 is usual.");
  return {parameters.quantity(in, "Final time"), parameters.quantity(in, "Safety factor"),
          parameters.flag(in, "Stop early"), parameters.quantity(in, "Free time")};
}

OutputParameters read_output(const Parameters &parameters)
{
  const std::string in = "Output";
  std::vector<double> times;
  if (parameters.is_given(in, "Picture times"))
    times = parameters.quantities(in, "Picture times");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] <= times[i - 1])
      parameters.fail(in, "Picture times",
                      "Time " + std::to_string(i + 1) + " does not come after time " +
                          std::to_string(i) + ".",
                      "Write the times in ascending order, each once.");
  return {parameters.text(in, "Directory"),
          parameters.quantity(in, "Frame interval"),
          parameters.quantity(in, "History interval"),
          parameters.flag(in, "ParaView files"),
          parameters.flag(in, "Pictures"),
          times};
}
} // namespace

Scene read_scene(const ParameterFile &file)
{
  const Parameters parameters(file, sections_of(file));

  Scene scene;
  scene.title      = parameters.text("", "Title");
  scene.symmetric  = parameters.flag("", "Symmetric");
  scene.projectile = read_projectile(parameters);
  for (const auto &section : parameters.sections())
    if (section.name.rfind("Material ", 0) == 0)
      scene.materials.push_back(read_material(parameters, section.name));
  scene.plates  = read_plates(parameters, scene.symmetric, scene.materials);
  scene.impact  = read_impact(parameters, scene.symmetric, scene.plates.front());
  scene.zone    = read_zone(parameters);
  scene.contact = read_contact(parameters);
  scene.time    = read_time(parameters);
  scene.output  = read_output(parameters);
  return scene;
}

void write_used_parameters(const ParameterFile &file, std::ostream &out)
{
  const auto stem = std::filesystem::path(file.path()).stem().string();
  write_parameters(
      Parameters(file, is_stability_file(file) ? stability_declarations(stem) : sections_of(file)),
      out);
}

void print_template(std::ostream &out)
{
  write_template(scene_declarations("template", 1, {"PMMA"}), out);
}
} // namespace ricochet
