// SPDX-License-Identifier: LGPL-2.1-or-later
// Something that is due every so often in simulated time.
#pragma once

#include "ricochet/base/state_archive.h"

#include <cmath>
#include <limits>

namespace ricochet
{
class Schedule
{
public:
  /// Due at once, unless the interval is zero: then never [s].
  explicit Schedule(const double interval) : interval_(interval) {}

  bool is_due(const double time) const { return interval_ > 0. && time >= next_; } // [s]
  /// At this time [s]. An interval shorter than a step is due at every step, however short it is.
  void done(const double time)
  {
    if (interval_ <= 0. || next_ > time)
      return;
    next_ += (std::floor((time - next_) / interval_) + 1.) * interval_;
    if (next_ <= time || !std::isfinite(next_)) // no number can tell it from the time
      next_ = std::nextafter(time, std::numeric_limits<double>::max());
  }
  /// Saves or restores when it is due next.
  void exchange_state(StateArchive &archive, const std::string &name)
  {
    archive.common(name, next_);
  }

private:
  double interval_, next_ = 0.; // [s]
};
} // namespace ricochet
