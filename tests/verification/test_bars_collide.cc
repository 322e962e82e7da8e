// SPDX-License-Identifier: LGPL-2.1-or-later
// V8: two equal elastic bars collide. By St Venant's wave theory they touch for 2 L/c and exchange
// their velocities.
#include "support/coupled_plate.h"
#include "support/verification.h"

#include "ricochet/contact/short_range_contact.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3, density = 1000., p_modulus = 1e9, nu = 0.35;

/// A bar along x of so many cells, points at one end and elements behind.
struct HalfOfTheCrash
{
  HalfOfTheCrash(const int number, const double x, const int n_cells, const int section,
                 const bool points_low)
  {
    const auto stencil = make_stencil(dx, 3., InfluenceFunction::cone);
    const double mu    = p_modulus * (1. - 2. * nu) / (2. * (1. - nu));
    auto zone          = std::make_unique<Zone>(
        make_zone({n_cells, section, section}, stencil, CouplingParameters()));
    constexpr int depth = 4;
    zone->grow({points_low ? Zone::Cells{{0, 0, 0}, {depth, section, section}}
                           : Zone::Cells{{n_cells - depth, 0, 0}, {n_cells, section, section}}});
    auto points = std::make_unique<PeridynamicBody>(
        MPI_COMM_SELF, number,
        Lattice::Box{{x, 0., 0.}, dx, {2 * n_cells, 2 * section, 2 * section}, false}, stencil,
        PeridynamicMaterial{&bond_law("linear peridynamic solid"), density,
                            p_modulus - 4. / 3. * mu, mu, std::numeric_limits<double>::infinity()},
        Lattice::Mask{}, nullptr, zone.get());
    CoupledPlateOptions options;
    options.coupling.correct_mass = false; // velocities are set below
    far =
        std::make_unique<CoupledPlate>(MPI_COMM_SELF, std::move(zone), std::move(points), options);
  }

  void start(const double v)
  {
    auto &body = far->points();
    body.lattice().for_each_owned([&](const std::ptrdiff_t p)
                                  { body.state().arrays.velocity[0][p] = v; });
    auto velocity = far->elements().velocity();
    for (std::size_t i = 0; i < velocity.size(); i += 3)
      velocity[i] = v;
    far->elements().set_velocity(velocity);
    far->interpolate_to_slaved_points();
  }

  std::unique_ptr<CoupledPlate> far;
};

TEST(V8Bars, OfFourHundredSpacingsTouchForTwoPassagesAndExchangeTheirVelocities)
{
  // Half as long, 200 spacings, they touch 2.5 % too long: more than the 2 % that are asked for.
  constexpr int n_cells = 200, section = 3;
  const double L = 2 * n_cells * dx, v = 0.2;
  const double E = p_modulus * (1. + nu) * (1. - 2. * nu) / (1. - nu), c = std::sqrt(E / density);
  HalfOfTheCrash left(0, -L - 0.21 * dx, n_cells, section, false),
      right(1, 0.21 * dx, n_cells, section, true);
  ShortRangeContact contact(MPI_COMM_SELF, {&left.far->points(), &right.far->points()}, 15., false);
  left.start(v);
  right.start(-v);
  const double dt   = 1.2 * dx / std::sqrt(p_modulus / density);
  const double mass = L * std::pow(2 * section * dx, 2) * density;
  double first = -1., last = -1.;
  for (int step = 0; step * dt < 3.5 * L / c; ++step)
  {
    for (auto *body : {left.far.get(), right.far.get()})
    {
      body->update_ghosts();
      body->compute_internal_forces({});
    }
    contact.add_forces(dt);
    if (contact.n_touching() > 0.)
    {
      first = first < 0. ? step * dt : first;
      last  = step * dt;
    }
    for (auto *half : {&left, &right})
      half->far->complete_forces();
    for (auto *half : {&left, &right})
      half->far->advance(dt, dt);
  }
  const double v_left  = left.far->momenta().linear.x() / mass,
               v_right = right.far->momenta().linear.x() / mass;
  std::printf("contact time %.4f of 2 L/c, velocities %.4f %.4f of v\n",
              (last - first) / (2. * L / c), v_left / v, v_right / v);
  verify_near("V8", "two equal coupled bars: contact time over 2L/c", (last - first) / (2. * L / c),
              1., 0.02);
  verify_near("V8", "two equal coupled bars: velocity of the left one afterwards over v",
              v_left / v, -1., 0.02);
  verify_near("V8", "two equal coupled bars: velocity of the right one afterwards over v",
              v_right / v, 1., 0.02);
}
} // namespace
} // namespace ricochet::tests
