// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and elements relax together: a uniform strain stays in equilibrium, also where elements
// become points half way.
#include "support/coupled_plate.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
const RelaxationSeries series{{0.3, 20e-6}, {0.4, 3e-6}};
constexpr double dt = 0.3e-6;

Eigen::Matrix3d strain_in_step(const int i)
{
  Eigen::Matrix3d strain;
  strain << 1., 0.3, 0.2, 0.3, -0.4, 0.1, 0.2, 0.1, 0.5;
  return std::min(1., 0.1 * i) * 1e-6 * strain;
}

/// Largest force on a free point or a node inside the plate, in units of M h^2 and the strain.
double ghost_force(PlateModel &plate)
{
  const double unit = 1e9 * 1e-6 * 4e-6;
  double worst      = 0.;
  plate.for_each_free(
      [&](const std::ptrdiff_t p, const Vector3 &)
      {
        for (const double *f : plate.points->state().arrays.force)
          worst = std::max(worst, std::abs(f[p]) / unit);
      });
  const auto &elements = plate.far->elements();
  const auto &mesh     = elements.mesh();
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
  {
    const Vector3 X = mesh.reference_position(node) / 2e-3;
    if (elements.mass(node) > 0. && (X.array() > 0.5).all() && (X.array() < 13.5).all())
      for (int d = 0; d < 3; ++d)
        worst = std::max(worst, std::abs(elements.force()[3 * node + d]) / unit);
  }
  return worst;
}

TEST(RelaxingPlate, UniformStrainStaysInEquilibriumAndThroughAConversion)
{
  CoupledSample sample;
  sample.relaxation            = series;
  sample.coupling.correct_mass = false; // forces as they are
  PlateModel plate(sample), larger(sample), fresh(sample);
  for (auto *one : {&plate, &larger, &fresh})
    one->far->start_relaxation(dt);
  const auto strained = [](const int i)
  { return [i](const Vector3 &X) -> Vector3 { return X + strain_in_step(i) * X; }; };
  const Zone::Cells grown{{4, 4, 4}, {10, 10, 10}};
  double worst = 0., after = 0.;
  for (int i = 1; i <= 60; ++i)
  {
    if (i == 30)
    {
      larger.points->update_ghosts();
      ASSERT_TRUE(larger.far->convert({grown}));
    }
    plate.deform(strained(i));
    larger.deform(strained(i));
    worst = std::max(worst, ghost_force(plate));
    after = std::max(after, ghost_force(larger));
  }
  // The worse of the parts' residuals, in parts of the strain whose components are at most one.
  EXPECT_LT(worst, 0.006);
  EXPECT_LT(after, 0.006);
  // What relaxed away is seen: without history the converted points would pull their surroundings.
  const auto fresh_history = [&]
  {
    ASSERT_TRUE(fresh.far->convert({grown}));
    fresh.far->points().start_relaxation(dt); // forgets
    fresh.deform(strained(60));
  };
  for (int i = 1; i <= 59; ++i)
    fresh.deform(strained(i));
  fresh_history();
  EXPECT_GT(ghost_force(fresh), 5. * after);
}
} // namespace
} // namespace ricochet::tests
