// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run_warnings.h"

#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"
#include "warning.h"

#include <algorithm>

namespace ricochet
{
namespace
{
using namespace units;

/// Deeper than this the penalty spring no longer keeps bodies apart that half a spacing divides
/// [dx].
constexpr double deep = 0.5;

/// "at 12.30 us "
std::string at(const double time)
{
  return "at " + with_decimals(time / us, 2) + " us ";
}
} // namespace

void RunWarnings::say(const std::string &text)
{
  warn(communicator_, text);
  given_.push_back(text);
}

void RunWarnings::update(const Simulation &simulation)
{
  check_depth(simulation);
  for (std::size_t i = 0; i < simulation.n_projectiles(); ++i)
  {
    check_elements(simulation, i);
    check_yield(simulation, i);
  }
  check_projectiles(simulation);
}

void RunWarnings::check_depth(const Simulation &simulation)
{
  const double before = deepest_;
  for (std::size_t i = 0; i < simulation.n_projectiles(); ++i)
    deepest_ = std::max(deepest_, simulation.reaction(i).deepest_in_spacings);
  if (deepest_ > deep && before <= deep)
    say(at(simulation.time()) + "points lie " + with_decimals(deepest_, 2) +
        " spacings deep in the projectile, more than half a spacing: contact is too soft "
        "for this impact. Raise 'Contact/Stiffness factor' or lower 'Time/Safety factor'.");
}

void RunWarnings::check_elements(const Simulation &simulation, const std::size_t projectile)
{
  if (!simulation.reaction(projectile).on_elements || on_elements_since_ >= 0.)
    return;
  on_elements_since_ = simulation.time();
  if (simulation.scene().zone.kind == ZoneKind::none) // who wants elements alone knows
    return;
  say(at(on_elements_since_) + "the projectile, at x = " +
      with_decimals(simulation.projectile(projectile).motion().position.x() / mm, 0) +
      " mm, touches finite elements, which do not break: the peridynamic zone ends too early, "
      "and what follows is not to be trusted. Set 'Coupling/Adaptive = true', or enlarge the "
      "zone.");
}

/// Boxes along the axes: who lies beside another at a slant may be named although there is room.
void RunWarnings::check_projectiles(const Simulation &simulation)
{
  for (std::size_t i = 1; i < simulation.n_projectiles() && !projectiles_meet_; ++i)
    for (std::size_t j = 0; j < i && !projectiles_meet_; ++j)
    {
      const auto a = simulation.projectile(i).bounding_box(),
                 b = simulation.projectile(j).bounding_box();
      if ((a.first.array() > b.second.array()).any() || (b.first.array() > a.second.array()).any())
        continue;
      projectiles_meet_ = true;
      say(at(simulation.time()) + "the boxes around projectiles " + std::to_string(j + 1) +
          " and " + std::to_string(i + 1) +
          " overlap. Projectiles do not touch each other: if they meet, they "
          "pass through each other, and what follows is not to be trusted. "
          "Move 'Impact " +
          std::to_string(i + 1) + "/Entry point'.");
    }
}

void RunWarnings::check_yield(const Simulation &simulation, const std::size_t projectile)
{
  const double limit = simulation.scene().projectile_at(projectile).yield_stress;
  const double found = simulation.projectile(projectile).largest_von_mises();
  if (yields_ || limit <= 0. || found <= limit)
    return;
  yields_ = true;
  say(at(simulation.time()) + "the projectile's von Mises stress is " +
      with_digits(found / MPa, 4) + " MPa, above 'Projectile/Yield stress = " +
      with_digits(limit / MPa, 4) + " MPa': it would flow, and the model is elastic.");
}

void RunWarnings::update(const Moment &moment)
{
  const bool known = hourglass_.is_large();
  hourglass_.update(moment);
  if (known || !hourglass_.is_large())
    return;
  const auto &found = hourglass_.largest();
  say(at(found.time) + with_decimals(100. * found.share, 0) +
      " % of the energy in the elements of plate " + std::to_string(found.plate + 1) +
      " are in their hourglass modes, more than " + with_decimals(100. * HourglassWatch::most, 0) +
      " %: elements are too large for what they have to follow. Set 'Coupling/Quadrature = "
      "full', choose fewer 'Coupling/Coarsening levels', or enlarge the zone.");
}

void RunWarnings::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "warnings");
  archive.common("deepest", deepest_);
  archive.common("on elements since", on_elements_since_);
  archive.common("projectiles meet", projectiles_meet_);
  archive.common("yields", yields_);
  hourglass_.exchange_state(archive);
  std::string lines; // no warning has a line break
  for (const auto &text : given_)
    lines += text + '\n';
  archive.common("given", lines);
  given_.clear();
  for (std::size_t at = 0, end; (end = lines.find('\n', at)) != std::string::npos; at = end + 1)
    given_.push_back(lines.substr(at, end - at));
}
} // namespace ricochet
