// SPDX-License-Identifier: LGPL-2.1-or-later
// V1: a peridynamic block with faces, edges and corners inside a box of elements under uniform strain.
#include "coupled_plate.h"

#include <gtest/gtest.h>

namespace
{
using namespace ricochet;
using namespace ricochet::tests;

TEST(V1Patch, CalibrationConverges)
{
  for (const int iterations : {0, 10, 20, 30, 40, 60, 80, 160, 320})
  {
    CoupledSample sample;
    sample.coupling.calibration.n_iterations = iterations;
    sample.coupling.correct_mass = false; sample.coupling.calibration.tolerance = 1e-4;
    CoupledPlate plate(sample);
    const auto &r = plate.far->calibration();
    std::printf("%d: %g -> %g, eig %g, it %d n %ld\n", iterations, r.ghost_before, r.ghost_after, r.smallest_eigenvalue, r.n_iterations, (long) r.n_elements);
    double worst = 0, worst_free = 0;
    for (int k = 0; k < 6; ++k)
    {
      Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
      const double eps = 1e-6;
      const int r[6] = {0,1,2,1,0,0}, c[6] = {0,1,2,2,2,1};
      if (k < 3) F(k,k) += eps; else { F(r[k],c[k]) += 0.5*eps; F(c[k],r[k]) += 0.5*eps; }
      plate.deform([&](const Vector3 &X) -> Vector3 { return F * X; });
      const auto &mesh = plate.far->elements().mesh();
      const double unit = 1e9 * eps * 4e-6;
      for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      {
        const Vector3 X = mesh.reference_position(node) / 2e-3;
        if ((X.array() < 0.5).any() || (X.array() > 13.5).any() || plate.far->elements().mass(node) == 0.) continue;
        for (int d = 0; d < 3; ++d)
          worst = std::max(worst, std::abs(plate.far->elements().force()[3*node+d]) / unit);
      }
      plate.for_each_free([&](const std::ptrdiff_t p, const Vector3 &) {
        for (int d = 0; d < 3; ++d) worst_free = std::max(worst_free, std::abs(plate.points->state().arrays.force[d][p]) / unit);
      });
    }
    std::printf("   measured %g, free points %g\n", worst, worst_free);
  }
}
} // namespace
