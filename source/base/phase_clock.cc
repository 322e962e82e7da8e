// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/phase_clock.h"

#include <ctime>

namespace ricochet
{
namespace
{
double now()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

PhaseClock::Seconds booked{};
Phase present = Phase::rest;
double since  = 0.; // when it began; the processor time of a process starts at 0 [s]

/// Books what has passed.
void change_to(const Phase next)
{
  const double time = now();
  booked[static_cast<int>(present)] += time - since;
  present = next;
  since   = time;
}
} // namespace

PhaseClock::Work::Work(const Phase phase) : outer_(present)
{
  change_to(phase);
}

PhaseClock::Work::~Work()
{
  change_to(outer_);
}

PhaseClock::Seconds PhaseClock::seconds()
{
  change_to(present);
  return booked;
}
} // namespace ricochet
