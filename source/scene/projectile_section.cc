// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/base/units.h"
#include "ricochet/scene/mesh_file.h"
#include "ricochet/scene/text_tools.h"
#include "sections.h"

#include <cmath>
#include <filesystem>
#include <sstream>

namespace ricochet
{
namespace
{
const Words<NoseShape> nose_shapes{{NoseShape::ogive, "ogive"},
                                   {NoseShape::cone, "cone"},
                                   {NoseShape::hemisphere, "hemisphere"},
                                   {NoseShape::flat, "flat"},
                                   {NoseShape::sphere, "sphere"}};

const Words<ProjectileModel> models{{ProjectileModel::rigid, "rigid"},
                                    {ProjectileModel::modal, "modal"},
                                    {ProjectileModel::finite_elements, "finite elements"},
                                    {ProjectileModel::peridynamic_nose, "peridynamic nose"},
                                    {ProjectileModel::peridynamic, "peridynamic"}};

const Words<double> mesh_units{{1., "m"}, {1e-2, "cm"}, {1e-3, "mm"}, {25.4e-3, "in"}};

/// The rows that checks speak of, and what the file says of mass and mesh before it is known which
/// way it says it.
struct ProjectileEntries
{
  ProjectileParameters &projectile;
  double density = 0., caliber_radius = 0.; // [kg/m^3], [diameters]
  double refinement = 0., mesh_unit = 0.;   // [-], [m]
  std::string mesh_file = {}, modes = {};
  const Entry *nose = nullptr, *length = nullptr, *nose_length = nullptr, *crh = nullptr,
              *mass = nullptr, *model = nullptr, *driven = nullptr, *poissons_ratio = nullptr,
              *peridynamic_length = nullptr, *n_modes = nullptr, *yield_stress = nullptr,
              *refined = nullptr, *mesh = nullptr;

  void check_lengths() const;
  void read_shape_and_mass() const;
  void read_peridynamic_length() const;
  void read_modes() const;
  void read_mesh() const;
  void check_deformable() const;
};

/// What this nose shape does not have must not be given.
void ProjectileEntries::check_lengths() const
{
  const NoseShape shape   = projectile.shape.nose;
  const bool has_own_nose = shape == NoseShape::ogive || shape == NoseShape::cone;
  const auto refuse       = [this](const Entry &entry)
  {
    if (entry.is_given())
      entry.fail("The nose shape '" + nose->text() + "' does not have this entry.",
                 "Remove the line, or take an included one back with 'set " + entry.name + " ='.");
  };
  if (shape == NoseShape::sphere)
    refuse(*length);
  if (!has_own_nose)
    refuse(*nose_length);
  if (shape != NoseShape::ogive)
    refuse(*crh);
}

void ProjectileEntries::read_shape_and_mass() const
{
  auto &shape = projectile.shape;
  if (crh->is_given())
  {
    // A tangent ogive whose arc has the radius crh * d: (crh d)^2 = l^2 + (crh d - d/2)^2.
    if (caliber_radius < 0.5)
      crh->fail("The radius of a tangent ogive's arc is at least half the diameter.",
                "Choose 0.5 (a hemisphere) or more.");
    shape.nose_length = shape.diameter * std::sqrt(caliber_radius - 0.25);
  }
  try
  {
    const BodyOfRevolution body(shape);
    if (!mass->is_given())
      projectile.mass = density * body.volume();
    shape = body.shape();
  }
  catch (const InputError &error) // the body does not know which lines it comes from
  {
    throw InputError((nose_length->is_given() ? nose_length : length)->origin() + ": " +
                     error.what() +
                     "\n  Change the shape, the diameter or the lengths in the section " +
                     in_quotes(nose->section) + ".");
  }
}

/// Of a peridynamic nose: at least the nose, for the elements behind it come in layers.
void ProjectileEntries::read_peridynamic_length() const
{
  const auto &shape    = projectile.shape;
  const bool is_given  = peridynamic_length->is_given();
  const auto in_mm_all = [](const double x)
  {
    std::ostringstream out;
    out << 1e3 * x << " mm";
    return out.str();
  };
  if (shape.nose == NoseShape::sphere)
    model->fail("A sphere is all nose: there is no shank of finite elements.",
                "Choose 'finite elements' or 'peridynamic'.");
  if (!is_given && shape.nose == NoseShape::flat)
    peridynamic_length->fail("A flat nose has no length of its own.",
                             "Say how much of the " + in_mm_all(shape.length) + " is peridynamic.");
  if (!is_given)
    projectile.peridynamic_length = shape.nose_length;
  if (projectile.peridynamic_length < shape.nose_length ||
      projectile.peridynamic_length >= shape.length)
    peridynamic_length->fail(
        "The finite elements begin behind the nose of " + in_mm_all(shape.nose_length) +
            " and before the base at " + in_mm_all(shape.length) + ".",
        "Choose a length between the two, or another " + in_quotes(model->path()) + ".");
}

/// A whole number, or as many as cost no time step.
void ProjectileEntries::read_modes() const
{
  if (modes != "automatic" && projectile.model != ProjectileModel::modal)
    n_modes->fail("A projectile that is " + in_quotes(model->text()) + " is not made of modes.",
                  "Remove the entry, or choose 'Model = modal'.");
  if (yield_stress->is_given() && projectile.model != ProjectileModel::modal)
    yield_stress->fail("Stresses are known of a modal projectile alone.",
                       "Remove the entry, or choose 'Model = modal'.");
  if (modes == "automatic")
    return;
  const bool is_number = !modes.empty() && modes.size() <= 6 &&
                         modes.find_first_not_of("0123456789") == std::string::npos;
  projectile.modes = is_number ? std::stoi(modes) : 0;
  if (projectile.modes == 0)
    n_modes->fail("This is no number of modes.",
                  "Choose 'automatic' or a whole number from 1; 'Model = rigid' has none.");
}

/// Names of files are relative to the parameter file that gives them.
void ProjectileEntries::read_mesh() const
{
  if (!mesh->is_given())
    return;
  projectile.mesh = ricochet::read_mesh(path_of_file(*mesh, mesh_file), mesh_unit);
}

void ProjectileEntries::check_deformable() const
{
  if (projectile.model != ProjectileModel::peridynamic_nose && peridynamic_length->is_given())
    peridynamic_length->fail("A projectile that is " + in_quotes(model->text()) + " has none.",
                             "Remove the entry, or choose 'Model = peridynamic nose'.");
  read_modes();
  if (projectile.model == ProjectileModel::rigid)
    return;
  if (projectile.driven)
    driven->fail("A projectile that is " + in_quotes(model->text()) + " goes where its parts go.",
                 "Choose 'Model = rigid', or leave this entry out.");
  if (projectile.model == ProjectileModel::peridynamic_nose)
    read_peridynamic_length();
  if (!(projectile.poissons_ratio < 0.5))
    poissons_ratio->fail("An elastic solid has a Poisson's ratio below 0.5.",
                         "Choose 0.3 for steel.");
  if (refinement != std::floor(refinement) || refinement > 4.)
    refined->fail("The mesh is refined a whole number of times.", "Choose 1, 2, 3 or 4.");
  projectile.refinement = static_cast<int>(refinement);
  read_mesh();
}

void add_shape_entries(Section &in, ProjectileEntries &rows)
{
  auto &shape = rows.projectile.shape;
  rows.nose   = &in.required("Nose shape", choice(shape.nose, nose_shapes), "ogive",
                             "Shape of the nose in front of the cylindrical shank, or a whole "
                               "sphere");
  in.required("Diameter", quantity(shape.diameter, Dimension::length, Limit::positive), "6.17 mm",
              "Diameter of the shank");
  rows.length = &in.optional("Length", quantity(shape.length, Dimension::length, Limit::positive),
                             "27.6 mm", "Length from the base to the tip");
  rows.nose_length =
      &in.optional("Nose length", quantity(shape.nose_length, Dimension::length, Limit::positive),
                   "10.23 mm", "Length of an ogive or cone, a part of the length");
  rows.crh  = &in.optional("Caliber radius head",
                           quantity(rows.caliber_radius, Dimension::number, Limit::positive), "3",
                           "Instead of an ogive's nose length, the radius of its arc in diameters");
  rows.mass = &in.optional("Mass", quantity(rows.projectile.mass, Dimension::mass, Limit::positive),
                           "5.25 g", "Mass of the whole projectile");
  const Entry &density =
      in.optional("Density", quantity(rows.density, Dimension::density, Limit::positive),
                  "7850 kg/m3", "Instead of the mass, the density of the homogeneous projectile");

  using Shapes = std::vector<NoseShape>;
  const Shapes not_spheres{NoseShape::ogive, NoseShape::cone, NoseShape::hemisphere,
                           NoseShape::flat};
  in.all_of({rows.length}, when(*rows.nose, nose_shapes, not_spheres));
  in.one_of({{rows.nose_length}, {rows.crh}},
            when(*rows.nose, nose_shapes, Shapes{NoseShape::ogive}));
  in.all_of({rows.nose_length}, when(*rows.nose, nose_shapes, Shapes{NoseShape::cone}));
  in.one_of({{rows.mass}, {&density}});
}

void add_material_entries(Section &in, ProjectileEntries &rows)
{
  auto &projectile = rows.projectile;
  rows.model       = &in.with_default("Model", choice(projectile.model, models), "rigid",
                                      "Whether it deforms; all but the first are elastic, "
                                            "and all but the first two cost time steps");
  rows.driven      = &in.with_default(
           "Prescribed velocity", flag(projectile.driven), "false",
           "Whether it keeps its velocity whatever it meets, like a tool; for a rigid one");
  const Entry &stiffness = in.optional(
      "Young's modulus", quantity(projectile.youngs_modulus, Dimension::stress, Limit::positive),
      "202 GPa", "Of a deformable projectile, together with Poisson's ratio");
  rows.poissons_ratio =
      &in.optional("Poisson's ratio",
                   quantity(projectile.poissons_ratio, Dimension::number, Limit::not_negative),
                   "0.3", "Of a deformable projectile, below 0.5");
  const Entry &spacing = in.optional(
      "Grid spacing", quantity(projectile.spacing, Dimension::length, Limit::positive), "1 mm",
      "Distance between neighbouring points of a peridynamic projectile or "
      "nose");
  rows.peridynamic_length = &in.optional(
      "Peridynamic length",
      quantity(projectile.peridynamic_length, Dimension::length, Limit::positive), "12 mm",
      "How far a peridynamic nose reaches back from the tip, rounded to whole layers of elements; "
      "by default the nose length");

  rows.n_modes = &in.with_default(
      "Modes", text(rows.modes, "'automatic' or a whole number"), "automatic",
      "Of a modal projectile, how many of its lowest eigenmodes it has; automatic: those below "
      "half "
      "of the largest frequency that the plates' step allows, which cost no time step");

  rows.yield_stress = &in.optional(
      "Yield stress", quantity(projectile.yield_stress, Dimension::stress, Limit::positive),
      "1.5 GPa", "Of a modal projectile, which is elastic: a warning when it is exceeded");

  using Models = std::vector<ProjectileModel>;
  const Models with_points{ProjectileModel::peridynamic_nose, ProjectileModel::peridynamic};
  Models deformable{ProjectileModel::modal, ProjectileModel::finite_elements};
  deformable.insert(deformable.end(), with_points.begin(), with_points.end());
  in.all_of({&stiffness, rows.poissons_ratio}, when(*rows.model, models, deformable));
  in.all_of({&spacing}, when(*rows.model, models, with_points));
}

void add_mesh_entries(Section &in, ProjectileEntries &rows)
{
  rows.refined = &in.with_default(
      "Refinement", quantity(rows.refinement, Dimension::number, Limit::positive), "2",
      "Of the generated mesh, which is also the skin of a peridynamic projectile: 1 to 4, each "
      "halves the edges");
  rows.mesh = &in.optional(
      "Mesh", text(rows.mesh_file, "a gmsh file in ASCII, relative to this file"), "projectile.msh",
      "Instead of the generated mesh, hexahedra of the same shape, tip towards x");
  in.with_default("Mesh unit", choice(rows.mesh_unit, mesh_units), "mm",
                  "Unit of the coordinates in that file");
}
} // namespace

Section projectile_section(ProjectileParameters &projectile, const unsigned int number)
{
  Section in(number == 1 ? "Projectile" : "Projectile " + std::to_string(number),
             number == 1 ? "The projectile: a body of revolution. Further ones have sections "
                           "Projectile 2 and Impact 2, and so on, with the same entries."
                         : "Projectile " + std::to_string(number) + ": a body of revolution.");
  const auto rows = std::make_shared<ProjectileEntries>(ProjectileEntries{projectile});
  add_shape_entries(in, *rows);
  add_material_entries(in, *rows);
  add_mesh_entries(in, *rows);

  in.check(
      [rows]
      {
        rows->check_lengths();
        rows->read_shape_and_mass();
        rows->check_deformable();
      });
  return in;
}
} // namespace ricochet
