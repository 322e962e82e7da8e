// SPDX-License-Identifier: LGPL-2.1-or-later
// A body's small motion about its reference configuration, as the search for its largest frequency
// sees it (dynamics/largest_frequency.h): displacements u in, accelerations a = M^-1 K u out. The
// vectors hold what this rank integrates, three numbers per point or node, zero where a component
// is held; they are made for this search alone, and forgotten after it.
#pragma once

#include <cstddef>
#include <vector>

namespace ricochet
{
class Vibration
{
public:
  virtual ~Vibration() = default;

  /// Of a vector on this rank.
  virtual std::size_t size() const                                                         = 0;
  /// Distance of the points, or smallest edge of an element [m].
  virtual double spacing() const                                                           = 0;
  /// A random direction in the norm of product(), the same for any number of ranks: M^-1/2 times
  /// numbers of which none knows another (base/noise.h). Of any size.
  virtual void excite(std::vector<double> &u) const                                        = 0;
  /// The body gets these displacements [m].
  virtual void displace(const std::vector<double> &u)                                      = 0;
  /// Forces of the present displacements, ghosts included.
  virtual void evaluate()                                                                  = 0;
  /// M^-1 K u of the last evaluate() [m/s^2].
  virtual void acceleration(std::vector<double> &a) const                                  = 0;
  /// x M y, summed over ranks; M^-1 K is symmetric in it, but for what a mass that is consistent to
  /// first order changes.
  virtual double product(const std::vector<double> &x, const std::vector<double> &y) const = 0;
  /// u = 0, f = 0.
  virtual void rest()                                                                      = 0;
};
} // namespace ricochet
