// SPDX-License-Identifier: LGPL-2.1-or-later
// The sections of a scene, each bound to its part of it; one file per section. What is bound must
// outlive the section.
#pragma once

#include "ricochet/scene/scene.h"
#include "section.h"

#include <string>

namespace ricochet
{
/// The entries outside the sections; stem: name of the parameter file without folder and ending.
Section top_section(Scene &scene, const std::string &stem);

/// number: from 1, which the section of the first does not name.
Section projectile_section(ProjectileParameters &projectile, unsigned int number);

/// number: likewise; the scene tells where the first plate is, and whether it is mirrored.
Section impact_section(ImpactParameters &impact, unsigned int number, const Scene &scene);

/// number: from 1; the scene tells which materials there are and what the zone is.
Section plate_section(PlateParameters &plate, unsigned int number, const Scene &scene);

/// 3 for "Plate 3" and the kind "Plate", 0 for a name of another form.
unsigned int number_in(const std::string &section, const std::string &kind);
inline unsigned int plate_number(const std::string &section)
{
  return number_in(section, "Plate");
}

/// "Material PMMA" is the section of the material that has this name already.
Section material_section(MaterialParameters &material);
constexpr const char *material_prefix = "Material ";

/// The scene tells which plates have zone boxes.
Section coupling_section(ZoneParameters &zone, const Scene &scene);

/// Entries that sections Coupling and Stability share: the tie between points and elements, and the
/// elements.
void add_interface_entries(Section &section, CouplingParameters &coupling, bool &full_quadrature,
                           double &hourglass_coefficient);

/// The word for each influence function.
Words<InfluenceFunction> influence_function_words();

Section contact_section(ContactParameters &contact);
Section time_section(TimeParameters &time);

/// stem: as above.
Section output_section(OutputParameters &output, const std::string &stem);

/// "12.5 mm"
std::string in_mm(double length);

// What several checks say.

/// Fails unless nu belongs to a stable isotropic solid, -1 < nu < 0.5.
void check_poissons_ratio(const Entry &entry, double nu);
} // namespace ricochet
