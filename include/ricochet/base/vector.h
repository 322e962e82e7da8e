// SPDX-License-Identifier: LGPL-2.1-or-later
// The one vector type of everything that is not a hot loop. Kernels see plain arrays only: Eigen
// types must not cross translation units compiled for different instruction sets.
#pragma once

#include <Eigen/Core>

namespace ricochet
{
using Vector3 = Eigen::Vector3d; // position, velocity, force: three numbers, SI
} // namespace ricochet
