// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/run_summary.h"

#include "ricochet/simulation/plate_size.h"
#include "summary_row.h"
#include "zone_summary.h"

#include <cmath>
#include <numeric>

namespace ricochet
{
namespace
{
using namespace units;
using Json = nlohmann::ordered_json;

/// One projectile at the end.
struct OneEnd
{
  const Simulation &simulation;
  std::size_t number; // from 0
  const OutcomeWatch &watch;
  const OutcomeVerdict &verdict;
};

/// Of the path against the plates, upwards is positive [deg].
double climb(const Vector3 &velocity)
{
  return std::atan2(velocity.z(), std::hypot(velocity.x(), velocity.y())) / deg;
}

/// The projectile at a stated time.
struct Sighting
{
  const Simulation &simulation;
  const OutcomeWatch &watch;
  double stated_time; // [s]
  std::size_t number; // of the projectile, from 0
};

/// Of the projectile that is meant.
template <class Seen>
RigidBody::Motion motion(const Seen &seen)
{
  return seen.simulation.present_motion(seen.number);
}

template <class Seen>
double pitch(const Seen &seen)
{
  return seen.simulation.projectile(seen.number).pitch();
}

const std::vector<SummaryRow<Sighting>> position_rows{
    {"stated_us", "us", [](const Sighting &s) -> Json { return s.stated_time / us; },
     "from Output/Picture times"},
    {"time_us", "us", [](const Sighting &s) -> Json { return s.simulation.time() / us; },
     "of the first step that is not before it, to which the others belong"},
    {"x_mm", "mm", [](const Sighting &s) -> Json { return motion(s).position.x() / mm; },
     "centroid of the projectile"},
    {"y_mm", "mm", [](const Sighting &s) -> Json { return motion(s).position.y() / mm; },
     "centroid of the projectile"},
    {"z_mm", "mm", [](const Sighting &s) -> Json { return motion(s).position.z() / mm; },
     "centroid of the projectile"},
    {"path_mm", "mm", [](const Sighting &s) -> Json { return s.watch.path() / mm; },
     "length of the centroid's path so far"},
    {"speed_m_s", "m/s", [](const Sighting &s) -> Json { return motion(s).velocity.norm(); },
     "of the centroid"},
    {"pitch_deg", "deg", [](const Sighting &s) -> Json { return pitch(s) / deg; },
     "of the axis against the plates, nose up is positive"},
    {"angle_deg", "deg", [](const Sighting &s) -> Json { return climb(motion(s).velocity); },
     "of the velocity against the plates, upwards is positive"}};

/// Per plate, x from and to, y from and to, z from and to.
Json damaged_boxes(const Simulation &simulation)
{
  auto boxes = Json::array();
  for (std::size_t i = 0; i < simulation.plates().size(); ++i)
  {
    // Without the rounding of sums of spacings.
    const double spacing   = simulation.plates()[i]->lattice().box().spacing;
    const auto [low, high] = simulation.damaged_box(i);
    auto box               = Json::array();
    for (int d = 0; d < 3 && low[d] <= high[d]; ++d)
      for (const double x : {low[d], high[d]})
        box.push_back(std::round(1e3 * x / spacing) * (spacing / mm) / 1e3);
    boxes.push_back(box);
  }
  return boxes;
}

Json phases_of(const RunNotes &notes)
{
  Json phases;
  for (int i = 0; i < n_phases; ++i)
    phases[phase_names[i]] = notes.phases[i];
  return phases;
}

double drift(const Vector3 &now, const Vector3 &start)
{
  return (now - start).norm() / start.norm();
}

Json max_depth(const OneEnd &end)
{
  if (end.verdict.exit_face == ExitFace::rear)
    return nullptr;
  return end.watch.max_depth() / mm;
}

using E = const RunEnd &;
using O = const OneEnd &;

const std::vector<SummaryRow<RunEnd>> names{
    {"title", "", [](E e) -> Json { return e.simulation.scene().title; }, "of the scene"},
    {"directory", "", [](E e) -> Json { return e.notes.directory; }, "of the results"}};

/// Of one projectile, those of the first stand at the top.
const std::vector<SummaryRow<OneEnd>> projectile_rows{
    {"outcome", "", [](O e) -> Json { return name_of(e.verdict.outcome); },
     "ricochet, perforate, edge, pushed, stuck or undecided"},
    {"reason", "", [](O e) -> Json { return e.verdict.reason; }, "why the run ended"},
    {"exit_face", "", [](O e) -> Json { return name_of(e.verdict.exit_face); },
     "front, rear, edge or none"},
    {"exit_plate", "-", [](O e) -> Json { return e.verdict.exit_plate; },
     "whose face or edge that is, from 1; 0 if the projectile has not left"},
    {"exit_speed_m_s", "m/s", [](O e) -> Json { return motion(e).velocity.norm(); },
     "of the projectile's centroid at the end"},
    {"exit_angle_deg", "deg", [](O e) -> Json { return climb(motion(e).velocity); },
     "of the velocity against the plates, upwards is positive"},
    {"pitch_deg", "deg", [](O e) -> Json { return pitch(e) / deg; },
     "of the projectile's axis against the plates, seen from the side: nose up is positive, "
     "counted "
     "on beyond a quarter turn"},
    {"max_depth_mm", "mm", [](O e) { return max_depth(e); },
     "largest depth of the projectile's lowest point below the undeformed front face while it "
     "touched "
     "something; null after a perforation, which has none"},
    {"path_mm", "mm", [](O e) -> Json { return e.watch.path() / mm; },
     "length of the centroid's path"},
    {"contact_duration_us", "us", [](O e) -> Json { return e.watch.contact_duration() / us; },
     "from the first to the last touch, debris included"}};

const std::vector<SummaryRow<RunEnd>> rows{
    {"time_us", "us", [](E e) -> Json { return e.simulation.time() / us; }, "at the end"},
    {"energy_residual", "-", [](E e) -> Json { return e.totals.relative_residual(); },
     "what the balance does not account for, as a share of the initial energy, at the last record"},
    {"energy_viscous", "-", [](E e) -> Json { return e.totals.share(e.totals.energies.viscous); },
     "turned into heat by relaxation, likewise"},
    {"energy_absorbed", "-", [](E e) -> Json { return e.totals.share(e.totals.energies.absorbed); },
     "has left through edges that do not reflect, likewise"},
    {"momentum_drift", "-",
     [](E e) -> Json { return drift(e.simulation.momenta().linear, e.notes.start_momenta.linear); },
     "change of the total momentum, in units of that at the start"},
    {"angular_momentum_drift", "-",
     [](E e) -> Json
     { return drift(e.simulation.momenta().angular, e.notes.start_momenta.angular); },
     "the same of the angular momentum about the origin"},
    {"deepest_penetration_dx", "-", [](E e) -> Json { return e.notes.deepest; },
     "of a point into a projectile, in grid spacings; contact is too soft above 0.5"},
    {"on_elements_us", "us", [](E e) -> Json { return in_us_or_null(e.notes.on_elements_since); },
     "when a projectile first touched finite elements, which do not break; null: never"},
    {"hourglass_share", "-",
     [](E e) -> Json
     { return e.notes.hourglass.time < 0. ? Json() : Json(e.notes.hourglass.share); },
     "largest share of the hourglass modes in the energy that the elements of a plate store, at "
     "all "
     "records at which that is a thousandth of the initial energy or more; too large above 0.1; "
     "null: "
     "at none"},
    {"hourglass_share_us", "us", [](E e) -> Json { return in_us_or_null(e.notes.hourglass.time); },
     "when that was"},
    {"projectile_von_mises_MPa", "MPa",
     [](E e) -> Json
     {
       const double largest = e.simulation.projectile().largest_von_mises();
       return largest > 0. ? Json(largest / MPa) : Json();
     },
     "largest von Mises stress below the surface of a modal projectile, at all steps; null: of no "
     "other"},
    {"broken_bonds", "-", [](E e) -> Json { return std::llround(e.totals.broken_bonds); },
     "each counted once, at the last record"},
    {"damaged_boxes_mm", "mm", [](E e) { return damaged_boxes(e.simulation); },
     "per plate the box around the damaged points in the reference configuration: x from and to, "
     "y, z; empty if there are none"},
    {"zones", "", [](E e) { return zone_summary(e.simulation, e.notes.interfaces); },
     "per plate, see below"},
    {"points", "-", [](E e) -> Json { return std::llround(e.notes.n_points); },
     "peridynamic points at the start, those that follow elements included"},
    {"bonds", "-", [](E e) -> Json { return std::llround(e.notes.n_bonds); },
     "of the sound plates at the start, each counted once"},
    {"steps", "-", [](E e) -> Json { return e.simulation.step(); }, "made"},
    {"time_step_us", "us", [](E e) -> Json { return e.simulation.dt() / us; }, "of the run"},
    {"ranks", "-", [](E e) -> Json { return e.notes.n_ranks; }, "MPI processes"},
    {"instruction_set", "",
     [](E e) -> Json { return e.simulation.plates()[0]->kernel().instruction_set; },
     "of the kernels"},
    {"core_seconds", "s",
     [](E e) -> Json { return std::accumulate(e.notes.phases.begin(), e.notes.phases.end(), 0.); },
     "processor time of all ranks"},
    {"phases", "s", [](E e) { return phases_of(e.notes); },
     "what of that was spent on what, by name"},
    {"bond_rate_per_core", "1/s", [](E e) -> Json { return e.notes.bond_rate / e.notes.n_ranks; },
     "directed bonds evaluated per second of wall time and rank, a measure of the work done: of a "
     "symmetric scene those of the half that is computed"},
    {"command", "", [](E e) -> Json { return e.notes.command; },
     "that made it, without what started it on several processes"},
    {"warnings", "", [](E e) -> Json { return e.notes.warnings; }, "a list, in words"},
    {"interrupted", "", [](E e) -> Json { return e.notes.interrupted; },
     "whether the user ended the run"},
    {"failed", "", [](E e) -> Json { return e.notes.failed; },
     "whether the run broke down; reason says why"},
    {"version", "", [](E e) -> Json { return e.notes.version; }, "of ricochet"}};

const std::vector<SummaryRow<PlateSize>> size_rows{
    {"length_mm", "mm", [](const PlateSize &s) -> Json { return s.computed.x() / mm; },
     "of plate N as it is computed, a multiple of the grid spacing or of the largest elements"},
    {"width_mm", "mm", [](const PlateSize &s) -> Json { return s.computed.y() / mm; }, "likewise"},
    {"thickness_mm", "mm", [](const PlateSize &s) -> Json { return s.computed.z() / mm; },
     "likewise"},
    {"asked_length_mm", "mm", [](const PlateSize &s) -> Json { return s.asked.x() / mm; },
     "as the parameter file has it"},
    {"asked_width_mm", "mm", [](const PlateSize &s) -> Json { return s.asked.y() / mm; },
     "likewise"},
    {"asked_thickness_mm", "mm", [](const PlateSize &s) -> Json { return s.asked.z() / mm; },
     "likewise"}};

const std::vector<SummaryRow<PlateDamage>> damage_rows{
    {"broken_share", "-", [](const PlateDamage &d) -> Json { return d.broken_share; },
     "of the bonds of plate N, had it no elements"},
    {"front_damaged_mm2", "mm2",
     [](const PlateDamage &d) -> Json { return d.front_area / (mm * mm); },
     "area of the points of its front face that have lost more than a quarter of their bonds"},
    {"rear_damaged_mm2", "mm2",
     [](const PlateDamage &d) -> Json { return d.rear_area / (mm * mm); },
     "the same of its rear face"},
    {"joint_broken_share", "-",
     [](const PlateDamage &d) -> Json
     { return d.joint_broken_share >= 0. ? Json(d.joint_broken_share) : left_out(); },
     "of its joint to the plate above, what has broken; there if the two have one"}};

/// All projectiles, if there are several.
Json projectiles_of(const RunEnd &end)
{
  auto list = Json::array();
  for (std::size_t i = 0; i <= end.further.size(); ++i)
  {
    const auto &watch     = i == 0 ? end.watch : end.further[i - 1].watch;
    const auto &verdict   = i == 0 ? end.verdict : end.further[i - 1].verdict;
    const auto &positions = i == 0 ? end.notes.positions : end.notes.further_positions[i - 1];
    list.push_back(object_of(projectile_rows, OneEnd{end.simulation, i, watch, verdict}));
    if (!positions.empty())
      list.back()["positions"] = positions;
  }
  return list;
}
} // namespace

std::vector<SummaryField> summary_fields()
{
  std::vector<SummaryField> fields;
  append(fields, "", names);
  append(fields, "", projectile_rows);
  append(fields, "", rows);
  append(fields, "plate_N_", size_rows);
  append(fields, "plate_N_", damage_rows);
  append_zone_fields(fields, "zones");
  append(fields, "positions", position_rows);
  append(fields, "projectiles", projectile_rows);
  append(fields, "projectiles[].positions", position_rows);
  fields.push_back({"reference_data", "columns", "",
                    "of Output/Reference data: name, unit, rmse, and points: time_us, kind, "
                    "wanted, error_bar, found, relative_error; null where it was not reached"});
  return fields;
}

Json run_summary(const RunEnd &end, const std::vector<PlateDamage> &damage)
{
  Json summary = object_of(names, end);
  summary.update(object_of(projectile_rows, OneEnd{end.simulation, 0, end.watch, end.verdict}));
  summary.update(object_of(rows, end));
  const auto prefix = [](const std::size_t i) { return "plate_" + std::to_string(i + 1) + "_"; };
  const auto sizes  = plate_sizes(end.simulation.scene());
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    summary.update(object_of(size_rows, sizes[i], prefix(i)));
    if (i < damage.size())
      summary.update(object_of(damage_rows, damage[i], prefix(i)));
  }
  if (!end.notes.positions.empty())
    summary["positions"] = end.notes.positions;
  if (!end.further.empty())
    summary["projectiles"] = projectiles_of(end);
  if (!end.notes.reference_data.is_null())
    summary["reference_data"] = end.notes.reference_data;
  return summary;
}

Json sighting(const Simulation &simulation, const OutcomeWatch &watch, const double stated_time,
              const std::size_t projectile)
{
  return object_of(position_rows, Sighting{simulation, watch, stated_time, projectile});
}
} // namespace ricochet
