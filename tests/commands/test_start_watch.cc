// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/start_watch.h"

#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

namespace ricochet::tests
{
namespace
{
const std::string about_a_directory =
    "--------------------------------------------------------------------------\n"
    "A call to mkdir was unable to create the desired directory:\n\n  Directory: /proc/none\n"
    "  Error:     No such file or directory\n\n"
    "--------------------------------------------------------------------------\n"
    "[host:32374] [[4744,0],0] ORTE_ERROR_LOG: Error in file session_dir.c at line 107\n"
    "--------------------------------------------------------------------------\n"
    "It looks like orte_init failed for some reason.\n"
    "--------------------------------------------------------------------------\n";

/// What stands on stderr when another process has done this and ended, and all that it has started.
std::string stderr_of(const std::function<void()> &action)
{
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const int child = fork();
  if (child == 0)
  {
    close(ends[0]);
    dup2(ends[1], STDERR_FILENO);
    close(ends[1]);
    action();
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  char part[4096];
  for (ssize_t n = 0; (n = read(ends[0], part, sizeof part)) > 0;)
    text.append(part, n);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return text;
}

void say(const std::string &text)
{
  EXPECT_EQ(write(STDERR_FILENO, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

TEST(StartWatch, SaysInOneSentenceWhyTheProcessHasEnded)
{
  const std::string text = stderr_of(
      []
      {
        const StartWatch watch;
        say(about_a_directory);
        _exit(1); // as Open MPI does
      });
  EXPECT_EQ(
      text.rfind("ricochet: MPI cannot start: A call to mkdir was unable to create the desired "
                 "directory (Directory /proc/none, Error No such file or directory).\n",
                 0),
      0u)
      << text;
  EXPECT_EQ(text.find("ORTE_ERROR_LOG"), std::string::npos) << text;
}

TEST(StartWatch, SpeaksAlsoIfTheProcessIsKilled)
{
  const std::string text = stderr_of(
      []
      {
        const StartWatch watch;
        raise(SIGKILL);
      });
  EXPECT_EQ(text.rfind("ricochet: MPI cannot start.\n", 0), 0u) << text;
}

TEST(StartWatch, HoldsBackWhatIsWrittenUntilMpiHasStarted)
{
  const std::string text = stderr_of(
      []
      {
        say("before ");
        {
          const StartWatch watch;
          say("a warning ");
        }
        say("after");
      });
  EXPECT_EQ(text, "before a warning after");
}

TEST(StartWatch, FindsTheReasonAmongTheDecoration)
{
  EXPECT_EQ(reason_in(""), "");
  EXPECT_EQ(reason_in("[host:1] [[1,0],0] ORTE_ERROR_LOG: Out of resource\n"), "");
  EXPECT_EQ(reason_in("---\nNot  found.\n---\nIt looks like MPI_INIT failed.\n---\n"), "Not found");
  EXPECT_EQ(reason_in("*** An error occurred\n\nWhy.\n"), "Why");
  EXPECT_EQ(reason_in("---\nA component was not found, or\nwas not opened. Note that much can be "
                      "said.\n\nHost:      here\nComponent: this\n---\n"),
            "A component was not found, or was not opened (Host here, Component this)");
}
} // namespace
} // namespace ricochet::tests
