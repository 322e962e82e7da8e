// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sections.h"

namespace ricochet
{
Section time_section(TimeParameters &time)
{
  Section in("Time", "How long and in which steps.");
  in.required("Final time", quantity(time.end_time, Dimension::time, Limit::positive), "450 us",
              "The run ends here at the latest");
  const Entry &safety = in.with_default(
      "Safety factor", quantity(time.safety_factor, Dimension::number, Limit::positive), "0.7",
      "Time step in units of the largest stable one, at most 1");
  in.with_default("Stop early", flag(time.stop_early), "true",
                  "Whether the run ends as soon as the outcome is decided");
  in.with_default("Free time", quantity(time.free_time, Dimension::time, Limit::positive), "5 us",
                  "The outcome is decided when the projectile was free of contact this long");
  in.with_default("Wall-clock limit",
                  quantity(time.wall_limit, Dimension::time, Limit::not_negative), "0 s",
                  "The run stops in order after so long, with a checkpoint; 0 s for no limit");

  in.check(
      [&time, &safety]
      {
        if (time.safety_factor > 1.)
          safety.fail("Steps above the stable one make the solution explode.",
                      "Choose a value above 0 and not above 1; 0.8 is usual.");
      });
  return in;
}
} // namespace ricochet
