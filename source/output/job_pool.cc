// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/job_pool.h"

#include "scripts.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <list>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ricochet
{
namespace
{
// How long a signal that comes just before the wait may go unnoticed [ms].
constexpr int patience = 200;

volatile std::sig_atomic_t n_signals = 0;

void count_signal(int)
{
  n_signals = n_signals + 1;
}

/// While it lives, SIGINT and SIGTERM are counted.
class SignalCount
{
public:
  SignalCount()
  {
    n_signals               = 0;
    struct sigaction action = {};
    action.sa_handler       = count_signal; // without SA_RESTART: poll() shall return
    sigaction(SIGINT, &action, &before_[0]);
    sigaction(SIGTERM, &action, &before_[1]);
  }
  ~SignalCount()
  {
    sigaction(SIGINT, &before_[0], nullptr);
    sigaction(SIGTERM, &before_[1], nullptr);
  }
  SignalCount(const SignalCount &)            = delete;
  SignalCount &operator=(const SignalCount &) = delete;

private:
  std::array<struct sigaction, 2> before_ = {};
};

struct Running
{
  std::size_t number;
  pid_t process;
  int pipe_end;
  std::string rest = ""; // of its output: what has no line's end yet
};

/// Its exit status, or minus its signal.
int status_of(const pid_t process)
{
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR)
  {
  }
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

class Pool
{
public:
  Pool(const std::vector<Job> &jobs, const JobListener &listener) : jobs_(jobs), listener_(listener)
  {
  }

  bool has_more() const { return next_ < jobs_.size(); }
  std::size_t n_running() const { return running_.size(); }

  void start_next()
  {
    const std::size_t number = next_++;
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      return listener_.ended(number, not_started);
    listener_.started(number);
    pid_t process    = 0;
    const int reason = start_program(jobs_[number], ends[1], POSIX_SPAWN_SETPGROUP, process);
    close(ends[1]);
    if (reason == 0)
      running_.push_back({number, process, ends[0]});
    else
    {
      close(ends[0]);
      listener_.line(number, jobs_[number][0] + ": " + std::strerror(reason));
      listener_.ended(number, not_started);
    }
  }

  /// Until something comes from one of them, or a signal.
  void wait()
  {
    std::vector<pollfd> ends;
    for (const auto &one : running_)
      ends.push_back({one.pipe_end, POLLIN, 0});
    if (poll(ends.data(), ends.size(), patience) <= 0)
      return;
    auto end = ends.begin();
    for (auto one = running_.begin(); one != running_.end(); ++end)
      if (end->revents != 0 && !read_from(*one))
      {
        close(one->pipe_end);
        if (!one->rest.empty())
          listener_.line(one->number, one->rest);
        listener_.ended(one->number, status_of(one->process));
        one = running_.erase(one);
      }
      else
        ++one;
  }

  void interrupt() const
  {
    for (const auto &one : running_)
      kill(one.process, SIGINT);
  }

private:
  /// False at the end of its output.
  bool read_from(Running &one) const
  {
    std::array<char, 4096> buffer;
    const ssize_t n = read(one.pipe_end, buffer.data(), buffer.size());
    if (n <= 0)
      return n < 0 && errno == EINTR;
    one.rest.append(buffer.data(), static_cast<std::size_t>(n));
    for (std::size_t end; (end = one.rest.find('\n')) != std::string::npos;)
    {
      listener_.line(one.number, one.rest.substr(0, end));
      one.rest.erase(0, end + 1);
    }
    return true;
  }

  const std::vector<Job> &jobs_;
  const JobListener &listener_;
  std::list<Running> running_;
  std::size_t next_ = 0;
};
} // namespace

bool run_jobs(const std::vector<Job> &jobs, const int n_at_once, const JobListener &listener)
{
  const SignalCount signals;
  Pool pool(jobs, listener);
  std::sig_atomic_t n_told = 0;
  for (;;)
  {
    while (n_signals == 0 && pool.has_more() &&
           pool.n_running() < static_cast<std::size_t>(n_at_once))
      pool.start_next();
    if (pool.n_running() == 0)
      return n_signals > 0;
    pool.wait();
    for (; n_told < n_signals; ++n_told) // a second one ends them at once
      pool.interrupt();
  }
}
} // namespace ricochet
