// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/progress.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace ricochet
{
namespace
{
/// Whether standard output ends at a terminal. Open MPI gives its processes a pseudo-terminal even
/// if its own output goes to a file, so under mpirun the parent's output is looked at.
bool on_terminal()
{
  if (!isatty(STDOUT_FILENO))
    return false;
  if (!std::getenv("OMPI_COMM_WORLD_SIZE"))
    return true;
  std::error_code error;
  const std::string target =
      std::filesystem::read_symlink("/proc/" + std::to_string(getppid()) + "/fd/1", error).string();
  return !error && (target.rfind("/dev/pts/", 0) == 0 || target.rfind("/dev/tty", 0) == 0);
}

unsigned int terminal_width()
{
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// A count with four digits at most and a letter for the power of 1000.
std::string short_count(double value)
{
  const char letters[] = {' ', 'k', 'M', 'G', 'T'};
  std::size_t i        = 0;
  for (; value >= 9999.5 && i + 1 < sizeof letters; ++i)
    value /= 1000.;
  return with_decimals(value, 0) + (i == 0 ? "" : std::string(" ") + letters[i]);
}

std::string duration(const double seconds)
{
  if (!std::isfinite(seconds))
    return "?";
  const long s = std::lround(seconds);
  if (s < 60)
    return std::to_string(s) + " s";
  if (s < 3600)
    return std::to_string(s / 60) + ":" + with_zeros(s % 60, 2);
  return std::to_string(s / 3600) + ":" + with_zeros(s / 60 % 60, 2) + " h";
}
} // namespace

Progress::Progress(const MPI_Comm comm, const double end_time, const bool quiet) :
  Progress(std::cout, end_time,
           quiet || rank_in(comm) != 0 ? Style::silent
           : on_terminal()             ? Style::terminal
                                       : Style::log)
{
}

Progress::Progress(std::ostream &out, const double end_time, const Style style) :
  out_(out), end_time_(end_time), style_(style)
{
}

void Progress::update(const ProgressState &state)
{
  if (style_ == Style::silent)
    return;
  last_         = state;
  any_          = true;
  last_printed_ = false;
  if (style_ == Style::terminal)
  {
    if (printed_ == Clock::time_point() ||
        Clock::now() - printed_ >= std::chrono::milliseconds(200))
      print(state);
    return;
  }
  // A small surplus, so that the record meant for 10 % is not missed by rounding.
  const int tenth = static_cast<int>(std::floor(10. * state.time / end_time_ + 1e-9));
  if (tenth >= next_tenth_)
  {
    print(state);
    next_tenth_ = tenth + 1;
  }
}

void Progress::finish()
{
  if (style_ == Style::silent || finished_)
    return;
  finished_ = true;
  if (any_ && !last_printed_)
    print(last_);
  if (any_ && style_ == Style::terminal)
    out_ << std::endl;
}

void Progress::print(const ProgressState &state)
{
  const std::string text = line(state);
  if (style_ == Style::terminal) // a longer line would wrap and could not be rewritten
    out_ << '\r' << text.substr(0, terminal_width() - 1) << "\033[K" << std::flush;
  else
    out_ << text << std::endl;
  printed_      = Clock::now();
  last_printed_ = true;
}

std::string Progress::line(const ProgressState &state) const
{
  const double done    = std::clamp(state.time / end_time_, 0., 1.);
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();

  // Within 80 columns, time left included.
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << std::setw(3) << 100. * done << " % "
       << std::setprecision(1) << std::setw(6) << state.time * 1e6 << " us " << std::setw(6)
       << state.speed << " m/s " << std::showpos << std::setw(5) << state.pitch << " deg  broken "
       << std::setw(6) << short_count(state.broken_bonds) << "  res. " << std::setprecision(2)
       << 100. * state.energy_residual << " %";
  if (done > 0. && done < 1. - 1e-9)
    text << "  " << duration(elapsed * (1. - done) / done) << " left";
  return text.str();
}
} // namespace ricochet
