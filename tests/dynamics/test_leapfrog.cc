// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/leapfrog.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
using Log = std::vector<std::string>;

/// Writes down who was asked for what.
class LoggingBody : public Body
{
public:
  LoggingBody(std::string name, Log &log) : name_(std::move(name)), log_(log) {}

  bool grows = false;

  double multiplicity() const override { return 1.; }
  void update_ghosts() override { write("ghosts"); }
  bool adapt(const Outlook &outlook) override
  {
    write("adapt " + std::to_string(outlook.front));
    return grows;
  }
  void break_bonds() override { write("break"); }
  void book_fracture(const double dt) override { write("book " + std::to_string(dt)); }
  void compute_internal_forces(const ForceRequest &request) override
  {
    write(request.energy ? "forces, energy" : "forces");
    EXPECT_TRUE(request.is_step);
  }
  void complete_forces() override { write("complete"); }
  void advance(const double kick, const double drift) override
  {
    write("advance " + std::to_string(kick) + " " + std::to_string(drift));
  }
  Energies energies(double) const override { return {}; }
  Momenta momenta() const override { return {}; }
  std::unique_ptr<Vibration> vibration() override { return nullptr; }
  void exchange_state(StateArchive &) override {}
  std::string first_not_finite() const override { return ""; }

private:
  void write(const std::string &what) { log_.push_back(name_ + ": " + what); }

  std::string name_;
  Log &log_;
};

class LoggingContact : public Interaction
{
public:
  explicit LoggingContact(Log &log) : log_(log) {}

  void bodies_changed() override { log_.push_back("contact: changed"); }
  void add_forces(const double dt) override
  {
    log_.push_back("contact: forces " + std::to_string(dt));
  }
  void record_work(const double dt) override
  {
    log_.push_back("contact: work " + std::to_string(dt));
  }
  void exchange_state(StateArchive &) override {}
  double energy() const override { return 0.; }
  double friction_work() const override { return 0.; }

private:
  Log &log_;
};

TEST(Leapfrog, AStepGoesInTheOrderOfItsHeader)
{
  Log log;
  LoggingBody a("a", log), b("b", log);
  LoggingContact contact(log);
  Leapfrog integrator({&a, &b}, {&contact});
  integrator.compute_forces({/*time=*/1., /*dt=*/2., /*front=*/3.}, /*energy=*/true);
  integrator.advance(4.);
  // Bonds of all break before forces of any; contact comes after all internal forces and before
  // what hands forces on; friction is booked when all have moved.
  EXPECT_EQ(log, (Log{"a: ghosts", "b: ghosts", "a: adapt 3.000000", "b: adapt 3.000000",
                      "a: break", "a: book 2.000000", "b: break", "b: book 2.000000",
                      "a: forces, energy", "b: forces, energy", "contact: forces 2.000000",
                      "a: complete", "b: complete", "a: advance 4.000000 4.000000",
                      "b: advance 4.000000 4.000000", "contact: work 4.000000"}));
  log.clear();
  integrator.compute_forces({}, /*energy=*/false);
  EXPECT_EQ(log[8], "a: forces");
}

TEST(Leapfrog, ContactHearsOnceThatAnyBodyHasGrown)
{
  for (const int growing : {0, 1, 2}) // the first, the second, both
  {
    Log log;
    LoggingBody a("a", log), b("b", log);
    LoggingContact contact(log);
    a.grows = growing != 1;
    b.grows = growing != 0;
    Leapfrog({&a, &b}, {&contact}).compute_forces({}, false);
    // Both are asked, whatever the other says, and contact is told before bonds break.
    EXPECT_EQ(Log(log.begin() + 2, log.begin() + 6),
              (Log{"a: adapt 0.000000", "b: adapt 0.000000", "contact: changed", "a: break"}));
  }
}

/// x'' = -omega^2 x of unit mass, from x = 1 at rest.
class Oscillator : public LoggingBody
{
public:
  static constexpr double omega = 3.;

  Oscillator(Log &log, const double dt) : LoggingBody("oscillator", log)
  {
    velocity_ = omega * std::sin(omega * 0.5 * dt); // half a step before the start
  }
  void compute_internal_forces(const ForceRequest &) override
  {
    force_ = -omega * omega * position_;
  }
  void advance(const double kick, const double drift) override
  {
    velocity_ += kick * force_;
    position_ += drift * velocity_;
  }
  Energies energies(const double dt) const override
  {
    Energies e;
    e.kinetic = 0.5 * velocity_ * (velocity_ + dt * force_);
    e.strain  = 0.5 * omega * omega * position_ * position_;
    return e;
  }
  double position() const { return position_; }

private:
  double position_ = 1., velocity_, force_ = 0.;
};

struct Flight
{
  double error;               // of the position at the end
  double drift;               // of the energy that the scheme keeps, relative
  double first_energy_is_off; // from that of the differential equation, relative
  double largest_displacement;
};

Flight fly(const double dt, const int n_steps)
{
  Log log;
  Oscillator oscillator(log, dt);
  Leapfrog integrator({&oscillator}, {});
  constexpr double exact = 0.5 * Oscillator::omega * Oscillator::omega;
  Flight flight{};
  double first = 0.;
  for (int step = 0; step < n_steps; ++step)
  {
    integrator.compute_forces({}, true);
    const double energy = oscillator.energies(dt).held();
    if (step == 0)
      first = energy;
    flight.drift = std::max(flight.drift, std::abs(energy - first) / exact);
    integrator.advance(dt);
    flight.largest_displacement =
        std::max(flight.largest_displacement, std::abs(oscillator.position()));
  }
  flight.error               = std::abs(oscillator.position() - std::cos(3. * n_steps * dt));
  flight.first_energy_is_off = std::abs(first - exact) / exact;
  return flight;
}

TEST(Leapfrog, OscillatorIsOfSecondOrderAndKeepsItsEnergy)
{
  const auto coarse = fly(0.02, 500), fine = fly(0.01, 1000); // both to t = 10, five periods
  EXPECT_GT(coarse.error, 1e-4);
  EXPECT_NEAR(coarse.error / fine.error, 4., 0.1);
  EXPECT_NEAR(coarse.first_energy_is_off / fine.first_energy_is_off, 4., 0.1);
  EXPECT_LT(coarse.drift, 1e-12);
  EXPECT_LT(fine.drift, 1e-12);
}

TEST(Leapfrog, IsStableUpToTwoOverOmega)
{
  const double limit = 2. / Oscillator::omega;
  EXPECT_LT(fly(0.99 * limit, 2000).largest_displacement, 10.);
  // Beyond, the amplitude grows by exp(2 acosh(1.01)) = 1.33 per step.
  EXPECT_GT(fly(1.01 * limit, 200).largest_displacement, 1e10);
}
} // namespace
} // namespace ricochet::tests
