// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/history_record.h"

#include "ricochet/base/units.h"

namespace ricochet
{
namespace
{
using namespace units;

const RigidBody::Motion &motion(const Moment &m)
{
  return m.motion;
}

const ContactRecord &reaction(const Moment &m)
{
  return m.simulation.reaction();
}

/// Of the projectile's lowest point below the undeformed front face of the first plate [m].
double tip_depth(const Simulation &simulation)
{
  return simulation.target_box().second.z() - simulation.projectile().bounding_box().first.z();
}

using M = const Moment &;

const std::vector<HistoryColumn> motion_columns{
    {"time", "us", [](M m) { return m.simulation.time() / us; }, "since the start of the run"},
    {"x", "mm", [](M m) { return motion(m).position.x() / mm; },
     "centroid of the projectile; it flies along x"},
    {"y", "mm", [](M m) { return motion(m).position.y() / mm; }, "the same, to the side"},
    {"z", "mm", [](M m) { return motion(m).position.z() / mm; },
     "the same, above the front face of the first plate"},
    {"speed", "m/s", [](M m) { return motion(m).velocity.norm(); },
     "of the projectile's centroid, at this time"},
    {"velocity x", "m/s", [](M m) { return motion(m).velocity.x(); },
     "of the projectile's centroid"},
    {"velocity y", "m/s", [](M m) { return motion(m).velocity.y(); },
     "of the projectile's centroid"},
    {"velocity z", "m/s", [](M m) { return motion(m).velocity.z(); },
     "of the projectile's centroid"},
    {"pitch", "deg", [](M m) { return m.simulation.projectile().pitch() / deg; },
     "of the projectile's axis against the plates, seen from the side: nose up is positive, "
     "counted on beyond a quarter turn"},
    {"spin x", "rad/s", [](M m) { return motion(m).spin.x(); },
     "angular velocity of the projectile"},
    {"spin y", "rad/s", [](M m) { return motion(m).spin.y(); },
     "angular velocity of the projectile"},
    {"spin z", "rad/s", [](M m) { return motion(m).spin.z(); },
     "angular velocity of the projectile"},
    {"tip depth", "mm", [](M m) { return tip_depth(m.simulation) / mm; },
     "lowest point of the projectile below the undeformed front face of the first plate"},
    {"force normal", "kN", [](M m) { return reaction(m).normal.norm() / 1e3; },
     "contact with plates and debris: magnitude of the sum of the normal forces"},
    {"force friction", "kN", [](M m) { return reaction(m).friction.norm() / 1e3; },
     "the same of friction"},
    {"force shank", "kN", [](M m) { return reaction(m).shank.norm() / 1e3; },
     "the same of the resistance along the shank"},
    {"force x", "kN", [](M m) { return reaction(m).force().x() / 1e3; },
     "sum of all contact forces on the projectile"},
    {"force y", "kN", [](M m) { return reaction(m).force().y() / 1e3; },
     "sum of all contact forces on the projectile"},
    {"force z", "kN", [](M m) { return reaction(m).force().z() / 1e3; },
     "sum of all contact forces on the projectile"},
    {"support x", "kN", [](M m) { return m.support.x() / 1e3; },
     "force of the supports ('Clamped edges') on the plates"},
    {"support y", "kN", [](M m) { return m.support.y() / 1e3; },
     "force of the supports on the plates"},
    {"support z", "kN", [](M m) { return m.support.z() / 1e3; },
     "force of the supports on the plates"}};

const std::vector<HistoryColumn> balance_columns{
    {"energy residual", "J", [](M m) { return m.totals.energies.residual(); },
     "initial energy plus the work of the drive minus all else of the above: what the balance does "
     "not account for"},
    {"residual relative", "-", [](M m) { return m.totals.relative_residual(); },
     "the same as a share of the initial energy"},
    {"broken bonds", "-", [](M m) { return m.totals.broken_bonds; }, "so far, each counted once"}};

/// A column for every row of energies.
template <class Rows>
void append(std::vector<HistoryColumn> &columns, const Rows &rows)
{
  for (const auto &row : rows)
    columns.push_back({row.name, "J", [value = row.value](M m) { return m.totals.energies.*value; },
                       row.meaning});
}

std::vector<HistoryColumn> all_columns()
{
  auto columns = motion_columns;
  append(columns, balance_rows);
  append(columns, energy_rows);
  columns.insert(columns.end(), balance_columns.begin(), balance_columns.end());
  return columns;
}
} // namespace

Totals totals_of(const Simulation &simulation)
{
  return {simulation.energies(), simulation.broken_bonds()};
}

const std::vector<HistoryColumn> &history_columns()
{
  static const std::vector<HistoryColumn> columns = all_columns();
  return columns;
}

std::vector<double> history_record(const Moment &moment)
{
  std::vector<double> record;
  record.reserve(history_columns().size());
  for (const HistoryColumn &column : history_columns())
    record.push_back(column.value(moment));
  return record;
}
} // namespace ricochet
