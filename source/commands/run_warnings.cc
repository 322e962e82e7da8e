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
  check_elements(simulation);
}

void RunWarnings::check_depth(const Simulation &simulation)
{
  const double before = deepest_;
  deepest_            = std::max(deepest_, simulation.reaction().deepest_in_spacings);
  if (deepest_ > deep && before <= deep)
    say(at(simulation.time()) + "points lie " + with_decimals(deepest_, 2) +
        " spacings deep in the projectile, more than half a spacing: contact is too soft "
        "for this impact. Raise 'Contact/Stiffness factor' or lower 'Time/Safety factor'.");
}

void RunWarnings::check_elements(const Simulation &simulation)
{
  if (!simulation.reaction().on_elements || on_elements_since_ >= 0.)
    return;
  on_elements_since_ = simulation.time();
  if (simulation.scene().zone.kind == ZoneKind::none) // who wants elements alone knows
    return;
  say(at(on_elements_since_) + "the projectile, at x = " +
      with_decimals(simulation.projectile().motion().position.x() / mm, 0) +
      " mm, touches finite elements, which do not break: the peridynamic zone ends too early, "
      "and what follows is not to be trusted. Set 'Coupling/Adaptive = true', or enlarge the "
      "zone.");
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
} // namespace ricochet
