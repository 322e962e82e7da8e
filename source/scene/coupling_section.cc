// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/coupling_method.h"
#include "ricochet/scene/text_tools.h"
#include "sections.h"

namespace ricochet
{
namespace
{
const Words<ZoneKind> zone_kinds{{ZoneKind::everything, "everything"},
                                 {ZoneKind::automatic, "automatic"},
                                 {ZoneKind::boxes, "boxes"},
                                 {ZoneKind::none, "none"}};

const Words<bool> growths{{false, "corridor"}, {true, "plate"}}; // in the whole plate

const Words<int> coarsening_levels{{-1, "automatic"}, {0, "0"}, {1, "1"}, {2, "2"}};

const Words<BlendFunction> blend_functions{{BlendFunction::linear, "linear"},
                                           {BlendFunction::cubic, "cubic"}};

const Words<int> element_sizes{{1, "1"}, {2, "2"}, {4, "4"}};

const Words<bool> quadratures{{false, "one point"}, {true, "full"}};

void check_growth(ZoneParameters &zone, const Entry &kind, const Entry &adaptive)
{
  zone.grows_everywhere = zone.adaptive && zone.grows_everywhere;
  if (zone.adaptive && (zone.kind == ZoneKind::everything || zone.kind == ZoneKind::none))
    adaptive.fail("There is no zone that could grow: the zone is '" + kind.text() + "'.",
                  "Choose 'set Zone = automatic' or 'boxes', or 'set Adaptive = false'.");
}

void check_boxes(const ZoneParameters &zone, const Scene &scene, const Entry &kind)
{
  for (std::size_t i = 0; i < scene.plates.size(); ++i)
    if (zone.kind == ZoneKind::boxes && scene.plates[i].zone_boxes.empty())
      kind.fail("The section 'Plate " + std::to_string(i + 1) + "' has no 'Zone box'.",
                "Give one for every plate, as 'set Zone box = 30 mm, 170 mm, -24 mm, 24 mm'.");
}
} // namespace

void add_interface_entries(Section &section, CouplingParameters &coupling, bool &full_quadrature,
                           double &hourglass_coefficient)
{
  section.with_default(
      "Method", choice(coupling.method, words_of(coupling_methods, &CouplingMethodName::method)),
      "calibrated energy blend", "What ties points and elements together");
  section.with_default("Blend function", choice(coupling.blend, blend_functions), "cubic",
                       "Fall of the weight over the blend; of the energy and force blends only");
  const Entry &width = section.with_default(
      "Blend width", quantity(coupling.blend_width, Dimension::number, Limit::positive), "2",
      "Width of the blend in horizons; of the energy and force blends only");
  section.with_default("Mass correction", flag(coupling.correct_mass), "true",
                       "Whether the elements next to the zone get their consistent mass, to first "
                       "order: waves pass the interface better");
  section.with_default("Element size", choice(coupling.points_per_edge, element_sizes), "2",
                       "Edge of the elements next to the zone, in grid spacings; 1 halves the time "
                       "step, 4 keeps out waves of four horizons and less");
  section.with_default("Quadrature", choice(full_quadrature, quadratures), "one point",
                       "Integration of the elements away from the zone: one point with hourglass "
                       "control, or 2 x 2 x 2 points");
  section.with_default("Hourglass coefficient",
                       quantity(hourglass_coefficient, Dimension::number, Limit::not_negative), "1",
                       "Stiffness of the hourglass modes; 1 gives pure bending its exact energy, 0 "
                       "switches the control off");
  section.check(
      [&coupling, &width]
      {
        if (coupling.blend_width > 10.)
          width.fail("The blend may be at most 10 horizons wide.",
                     "Choose a smaller number; 2 is usual.");
      });
}

Section coupling_section(ZoneParameters &zone, const Scene &scene)
{
  Section in("Coupling",
             "Peridynamics only where it breaks: which part of the plates is peridynamic (the "
             "zone), and how the finite elements around it are tied to it.");
  const Entry &kind = in.with_default(
      "Zone", choice(zone.kind, zone_kinds), "everything",
      "Part of the plates that is peridynamic: everything, the corridor that the impact will "
      "damage, the boxes given with the plates, or none (elastic finite elements alone)");
  const Entry &adaptive = in.with_default(
      "Adaptive", flag(zone.adaptive), "false",
      "Whether the zone grows ahead of damage; an automatic zone then starts small, around the "
      "entry point");
  in.with_default("Growth", choice(zone.grows_everywhere, growths), "corridor",
                  "How far an adaptive zone may grow: as wide as the corridor of the impact and no "
                  "further than a little ahead of the projectile, or in the whole plate after "
                  "every crack, which is dear");
  in.with_default("Conversion stretch",
                  quantity(zone.conversion_stretch, Dimension::number, Limit::fraction), "0.5",
                  "Stretch of a bond near the interface, in critical stretches, at which an "
                  "adaptive zone grows; a fixed one is reported as reached");
  in.with_default("Coarsening levels", choice(zone.coarsening_levels, coarsening_levels),
                  "automatic",
                  "How often the elements double their size away from the zone; automatic: as "
                  "often as the number of points allows, up to 8 grid spacings");
  add_interface_entries(in, zone.coupling, zone.full_quadrature, zone.hourglass_coefficient);

  in.check([&] { check_growth(zone, kind, adaptive); });
  in.check_with_others([&] { check_boxes(zone, scene, kind); });
  return in;
}
} // namespace ricochet
