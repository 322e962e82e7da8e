// SPDX-License-Identifier: LGPL-2.1-or-later
// A body's small motion about its reference configuration, as power iteration sees it
// (dynamics/largest_frequency.h): u is the displacement, f the force, |.| a norm of the body's
// choice in which M^-1 K is symmetric.
#pragma once

#include "ricochet/base/vector.h"

namespace ricochet
{
class Vibration
{
public:
  virtual ~Vibration() = default;

  /// Sets f to something in which all high modes take part, the same for any number of ranks.
  virtual void excite()                   = 0;
  /// |f|, summed over ranks.
  virtual double response() const         = 0;
  /// |f| of a mode with frequency 1 rad/s and the |u| that displace() makes.
  virtual double response_of_unit() const = 0;
  /// u = -|u| M^-1 f / norm, |u| small enough for a linear response, large enough for rounding.
  virtual void displace(double norm)      = 0;
  /// f of the present u, ghosts included.
  virtual void evaluate()                 = 0;
  /// u = 0, f = 0.
  virtual void rest()                     = 0;

protected:
  /// Root mean square displacement, in units of the distance between points: linear to that
  /// accuracy, and far above the rounding that is left of |xi + eta| - |xi|.
  static constexpr double amplitude = 1e-6;

  /// A disturbance without period, from -1 to 1: the mode that alternates from place to place
  /// alone would miss the other classes of symmetry. Any irrational-looking numbers do; these are
  /// the usual ones of shader noise.
  static double noise(const Vector3 &place, int component);
};
} // namespace ricochet
