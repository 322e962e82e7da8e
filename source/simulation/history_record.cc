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
  return m.simulation.reaction(m.projectile);
}

const Projectile &projectile(const Moment &m)
{
  return m.simulation.projectile(m.projectile);
}

/// Of the projectile's lowest point below the undeformed front face of the first plate [m].
double tip_depth(const Moment &m)
{
  return m.simulation.target_box().second.z() - projectile(m).bounding_box().first.z();
}

using M = const Moment &;

const HistoryColumn time_column{"time", "us", [](M m) { return m.simulation.time() / us; },
                                "since the start of the run"};

/// Of one projectile.
const std::vector<HistoryColumn> projectile_columns{
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
    {"pitch", "deg", [](M m) { return projectile(m).pitch() / deg; },
     "of the projectile's axis against the plates, seen from the side: nose up is positive, "
     "counted on beyond a quarter turn"},
    {"spin x", "rad/s", [](M m) { return motion(m).spin.x(); },
     "angular velocity of the projectile"},
    {"spin y", "rad/s", [](M m) { return motion(m).spin.y(); },
     "angular velocity of the projectile"},
    {"spin z", "rad/s", [](M m) { return motion(m).spin.z(); },
     "angular velocity of the projectile"},
    {"tip depth", "mm", [](M m) { return tip_depth(m) / mm; },
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
     "sum of all contact forces on the projectile"}};

const std::vector<HistoryColumn> support_columns{
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

Moment seen_by(const std::size_t projectile, const Moment &m)
{
  return {m.simulation, m.totals, projectile, m.simulation.present_motion(projectile), m.support};
}

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
  std::vector<HistoryColumn> columns{time_column};
  columns.insert(columns.end(), projectile_columns.begin(), projectile_columns.end());
  columns.insert(columns.end(), support_columns.begin(), support_columns.end());
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

std::vector<HistoryColumn> history_columns(const std::size_t n_projectiles)
{
  static const std::vector<HistoryColumn> of_one = all_columns();
  auto columns                                   = of_one;
  for (std::size_t i = 1; i < n_projectiles; ++i)
    for (const auto &column : projectile_columns)
      columns.push_back({column.name + " " + std::to_string(i + 1), column.unit,
                         [value = column.value, i](M m) { return value(seen_by(i, m)); },
                         column.meaning + ", of projectile " + std::to_string(i + 1)});
  return columns;
}

std::vector<double> history_record(const Moment &moment)
{
  std::vector<double> record;
  for (const HistoryColumn &column : history_columns())
    record.push_back(column.value(moment));
  for (std::size_t i = 1; i < moment.simulation.n_projectiles(); ++i)
  {
    const Moment of_another = seen_by(i, moment);
    for (const HistoryColumn &column : projectile_columns)
      record.push_back(column.value(of_another));
  }
  return record;
}
} // namespace ricochet
