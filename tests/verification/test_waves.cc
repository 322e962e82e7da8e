// SPDX-License-Identifier: LGPL-2.1-or-later
// Plane waves and a pulse in a bar against theory and against an independent prototype.
#include "support/body.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// Phase speed of a plane wave along [100] with that polarisation [m/s], from the force on one
/// point.
double phase_speed(PeridynamicBody &body, const double wavelength, const int polarisation)
{
  const auto &n          = body.lattice().box().n;
  const auto centre      = body.lattice().index(n[0] / 2, n[1] / 2, n[2] / 2);
  const Vector3 origin   = reference(body, centre);
  const double k         = 2. * M_PI / wavelength;
  const double amplitude = 1e-7 * body.lattice().box().spacing; // linear, and far above rounding
  deform(body,
         [&](const Vector3 &X) -> Vector3 {
           return X + amplitude * std::cos(k * (X.x() - origin.x())) * Vector3::Unit(polarisation);
         });
  // The centre is a crest: f = -m omega^2 a.
  const double omega =
      std::sqrt(-force(body, centre)[polarisation] / (body.point_mass() * amplitude));
  return omega / k;
}

TEST(PlaneWaves, DispersionOfTheConeLatticeIsThatOfThePrototype)
{
  BodySample sample;
  sample.family = {solid_with_poisson_ratio(0.35), InfluenceFunction::cone, 3.};
  sample.n      = {9, 9, 9}; // the force on a point reaches two families far, 4 points for the cone
  const auto body      = make_body(sample);
  const auto &material = body->material();
  const double c_p     = std::sqrt(p_wave_modulus(material) / material.density);
  const double c_s     = std::sqrt(material.shear_modulus / material.density);

  // An independent prototype, nu = 0.35: error of the phase speed in per cent, printed to one or
  // two digits.
  struct Row
  {
    double wavelengths_per_horizon, p, s;
  };
  for (const auto &row : {Row{2., -20.9, -8.9}, Row{3., -10.3, -4.1}, Row{4., -6.0, -2.4},
                          Row{6., -2.7, -1.1}, Row{8., -1.5, -0.7}, Row{16., -0.35, -0.25}})
  {
    const double wavelength = row.wavelengths_per_horizon * 3. * sample.spacing;
    verify_at_most("V9", "error of P waves by the force routine: difference from the prototype [%]",
                   std::abs(100. * (phase_speed(*body, wavelength, 0) / c_p - 1.) - row.p), 0.1);
    verify_at_most("V9", "error of S waves by the force routine: difference from the prototype [%]",
                   std::abs(100. * (phase_speed(*body, wavelength, 1) / c_s - 1.) - row.s), 0.1);
    EXPECT_NEAR(phase_speed(*body, wavelength, 1), phase_speed(*body, wavelength, 2), 1e-6 * c_s);
  }
}

TEST(PlaneWaves, LongWavesOfEveryLawTravelAtTheClassicalSpeeds)
{
  for (const auto &law : bond_law_samples)
  {
    BodySample sample;
    sample.family           = {law, InfluenceFunction::cone, 3.};
    sample.n                = {9, 24, 24};
    const auto body         = make_body(sample);
    const auto &material    = body->material();
    const double wavelength = 64. * 3. * sample.spacing;
    // 0.02 and 0.11 % for the solid in the same table; the bond-based law on the cone is within a
    // per cent of isotropic.
    const double tolerance  = law.law == std::string("linear peridynamic solid") ? 0.002 : 0.02;
    EXPECT_NEAR(phase_speed(*body, wavelength, 0) /
                    std::sqrt(p_wave_modulus(material) / material.density),
                1., tolerance);
    EXPECT_NEAR(phase_speed(*body, wavelength, 1) /
                    std::sqrt(material.shear_modulus / material.density),
                1., tolerance);
  }
}

TEST(Bar, PulseTravelsAtTheBarSpeed)
{
  BodySample sample;
  sample.family      = {solid_with_poisson_ratio(0.35), InfluenceFunction::cone, 3.};
  sample.n           = {300, 12, 12};
  const auto body    = make_body(sample);
  auto &a            = body->state().arrays;
  const auto &m      = body->material();
  const double dx    = sample.spacing;
  const double speed = std::sqrt(youngs_modulus(m) / m.density);
  const double dt    = 1.7 * dx / std::sqrt(p_wave_modulus(m) / m.density); // limit 2.02, table 2.2
  const double nu    = 0.35;

  // D'Alembert: u = f(x - ct), v = -c f', sigma_xx = E f', with the lateral contraction that
  // belongs to it.
  const double centre = 90. * dx, width = 24. * dx, amplitude = 1e-4 * dx;
  const auto u = [&](const double x)
  { return amplitude * std::exp(-0.5 * std::pow((x - centre) / width, 2)); };
  const auto gradient = [&](const double x) { return -(x - centre) / (width * width) * u(x); };
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   const Vector3 X = reference(*body, p);
                   const double y = X.y() - 6. * dx, z = X.z() - 6. * dx;
                   set(a.position, p,
                       X + Vector3(u(X.x()), -nu * gradient(X.x()) * y, -nu * gradient(X.x()) * z));
                   set(a.velocity, p,
                       Vector3(-speed * gradient(X.x() + 0.5 * speed * dt), 0.,
                               0.)); // at the half step before
                 });

  const auto crest = [&]
  {
    double weight = 0., first = 0.;
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     const double w = std::pow(a.velocity[0][p], 2);
                     weight += w;
                     first += w * reference(*body, p).x();
                   });
    return first / weight;
  };
  const auto advance = [&](const int n_steps)
  {
    for (int i = 0; i < n_steps; ++i)
    {
      body->update_ghosts();
      body->compute_internal_forces({false});
      body->advance(dt, dt);
    }
  };
  advance(10); // the small part that the surfaces send backwards leaves the pulse
  const double start = crest();
  advance(60);
  const double measured = (crest() - start) / (60 * dt);

  // Coupling note, table 2.5: a slab 4 horizons thick between two free faces has lost 4 % of its
  // axial stiffness; the bar has two such pairs of faces.
  const double stiffness = 0.96 * 0.96;
  // Rayleigh and Love: the inertia of the lateral contraction slows the group by 3/2 nu^2 k^2 (a^2
  // + b^2)/12; k^2 is 3/(2 w^2) in the mean over the kinetic energy of this pulse.
  const double lateral   = 1. - 1.5 * nu * nu * 1.5 * std::pow(12. * dx, 2) / 6. / (width * width);
  // The loss of the edges, where two faces meet, is in no table; the quadrature of the table is 1 %
  // wide.
  EXPECT_NEAR(measured / speed, std::sqrt(stiffness) * lateral, 0.015);
}
} // namespace
} // namespace ricochet::tests
