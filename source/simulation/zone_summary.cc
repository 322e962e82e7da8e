// SPDX-License-Identifier: LGPL-2.1-or-later
#include "zone_summary.h"

#include "summary_row.h"

namespace ricochet
{
namespace
{
using namespace units;
using Json = nlohmann::ordered_json;

/// One plate of a run with what its elements carried and how well they were tied to its points.
struct PlateView
{
  const Simulation &simulation;
  std::size_t plate;
  const AdaptivePlate *coupled;  // null if it is peridynamic throughout
  const InterfaceReport *report; // null if it has no interface, or that was not tested
};

template <class Value>
Json if_coupled(const PlateView &p, const Value value)
{
  return p.coupled != nullptr ? Json(value(p)) : left_out();
}

template <class Value>
Json if_tested(const PlateView &p, const Value value)
{
  return p.report != nullptr ? Json(value(*p.report)) : left_out();
}

using P = const PlateView &;
using R = const InterfaceReport &;

double share_of_volume(P p)
{
  return p.coupled != nullptr ? double(p.coupled->zone().n_free_cells()) /
                                    static_cast<double>(p.coupled->zone().n_cells_in_all())
                              : 1.;
}

/// A number or an energy of the plate as computed becomes that of the whole one.
template <class Value>
Json of_whole(P p, const Value value)
{
  return value * static_cast<Value>(p.coupled->multiplicity());
}

Json conversion_loss(P p)
{
  return of_whole(p, p.coupled->adaptive_zone().loss());
}

Json ghost_force(P p)
{
  return p.report != nullptr    ? Json(p.report->patch.ghost_force)
         : p.coupled != nullptr ? Json(p.coupled->calibration().ghost_after)
                                : left_out();
}

const std::vector<SummaryRow<PlateView>> zone_rows{
    {"zone", "", [](P p) -> Json { return p.simulation.plate(p.plate).zone_reason; },
     "which part is peridynamic, and why"},
    {"share_of_volume", "-", [](P p) -> Json { return share_of_volume(p); },
     "peridynamic at the end"},
    {"elements", "-",
     [](P p)
     {
       return if_coupled(p, [](P q)
                         { return of_whole(q, q.coupled->elements().mesh().n_global_elements()); });
     },
     "number of finite elements, those full of points included; this and all below only with "
     "elements"},
    {"slaved_cells", "-",
     [](P p)
     { return if_coupled(p, [](P q) { return of_whole(q, q.coupled->zone().n_slaved_cells()); }); },
     "cells of points that follow nodes"},
    {"ghost_force", "-", ghost_force,
     "largest force that a constant strain leaves at the interface, in units of strain (K + 4 "
     "mu/3) h^2"},
    {"conversions", "-",
     [](P p)
     { return if_coupled(p, [](P q) { return q.coupled->adaptive_zone().n_conversions(); }); },
     "times that elements became points"},
    {"redistributions", "-",
     [](P p)
     { return if_coupled(p, [](P q) { return q.coupled->adaptive_zone().n_redistributions(); }); },
     "times that points were shared anew over the ranks"},
    {"conversion_loss_J", "J", [](P p) { return if_coupled(p, conversion_loss); },
     "energy lost where elements became points"},
    {"interface_reached_us", "us",
     [](P p) {
       return if_coupled(p,
                         [](P q) { return in_us_or_null(q.coupled->adaptive_zone().reached()); });
     },
     "when damage first came near an interface that did not give way; null: never"},
    {"strain_error", "-",
     [](P p) { return if_tested(p, [](R r) { return r.patch.strain_error; }); },
     "largest error of a constant strain in the patch test of the interface, in units of it; this "
     "and all below only with an interface"},
    {"largest_frequency_rad_us", "rad/us",
     [](P p) { return if_tested(p, [](R r) { return 1e-6 * r.frequency; }); },
     "of the coupled plate, without contact; a bound from above"},
    {"step_limit_us", "us", [](P p) { return if_tested(p, [](R r) { return r.step_limit / us; }); },
     "largest stable time step that follows from it"},
    {"predicted_step_limit_us", "us",
     [](P p) { return if_tested(p, [](R r) { return r.predicted_limit / us; }); },
     "the same predicted by plane waves in lattice and elements"},
    {"share_of_cost", "-", [](P p) { return if_tested(p, [](R r) { return r.share_of_cost(); }); },
     "of the force evaluation that the points take, measured"},
    {"limits_kept", "", [](P p) { return if_tested(p, [](R r) { return r.good(); }); },
     "whether ghost force, strain error and time step keep their limits"}};
} // namespace

Json zone_summary(const Simulation &simulation, const std::vector<InterfaceReport> &interfaces)
{
  auto zones = Json::array();
  for (std::size_t i = 0; i < simulation.n_plates(); ++i)
  {
    PlateView view{simulation, i, simulation.coupled_plate(i), nullptr};
    for (const auto &report : interfaces)
      if (report.plate == i)
        view.report = &report;
    zones.push_back(object_of(zone_rows, view));
  }
  return zones;
}

void append_zone_fields(std::vector<SummaryField> &fields, const std::string &place)
{
  append(fields, place, zone_rows);
}
} // namespace ricochet
