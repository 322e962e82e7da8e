// SPDX-License-Identifier: LGPL-2.1-or-later
// Random numbers that are the same on every machine.
#pragma once

#include "ricochet/base/vector.h"

#include <random>

namespace ricochet::tests
{
/// std::uniform_real_distribution may differ between standard libraries; the engine may not.
class Random
{
public:
  explicit Random(const unsigned int seed) : engine_(seed) {}
  double uniform() { return 2. * engine_() / double(std::mt19937::max()) - 1.; } // in [-1, 1]
  Vector3 vector()
  {
    const double x = uniform(), y = uniform(), z = uniform();
    return {x, y, z};
  }

private:
  std::mt19937 engine_;
};
} // namespace ricochet::tests
