// SPDX-License-Identifier: LGPL-2.1-or-later
#include "start_watch.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <regex>
#include <sstream>

namespace ricochet
{
namespace
{
std::string text_of(const int file)
{
  std::string text;
  char part[4096];
  lseek(file, 0, SEEK_SET);
  for (ssize_t n = 0; (n = read(file, part, sizeof part)) > 0;)
    text.append(part, n);
  return text;
}

void write_all(const int file, const std::string &text)
{
  for (std::size_t done = 0; done < text.size();)
  {
    const ssize_t n = write(file, text.data() + done, text.size() - done);
    if (n <= 0)
      return; // nobody is there to be told
    done += n;
  }
}

std::string sentence(const std::string &reason)
{
  return "ricochet: MPI cannot start" + (reason.empty() ? "" : ": " + reason) +
         ".\n  Look at TMPDIR and at the variables OMPI_*; with 'mpirun -np 1' before the command "
         "Open MPI says more. --version, --help, template and columns do without MPI.\n";
}
} // namespace

std::string reason_in(const std::string &text)
{
  // Blocks between rules; the first gives the reason: a paragraph, and rows like "Directory: /tmp".
  const std::regex row(R"(\s*(\w+):\s+(\S.*))");
  std::istringstream lines(text);
  std::string paragraph, rows;
  bool paragraph_ends = false;
  std::smatch match;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind("--", 0) == 0 && !paragraph.empty())
      break;
    if (line.empty())
      paragraph_ends = !paragraph.empty();
    else if (line[0] == '-' || line[0] == '[' ||
             line[0] == '*') // "[host:number] place in a source"
      continue;
    else if (std::regex_match(line, match, row))
      rows += (rows.empty() ? "" : ", ") + match[1].str() + " " + match[2].str();
    else if (!paragraph_ends)
      paragraph += line + " ";
  }
  std::string reason;
  std::istringstream words(paragraph);
  for (std::string word; words >> word && (reason.empty() || reason.back() != '.');)
    reason += (reason.empty() ? "" : " ") + word;
  while (!reason.empty() && (reason.back() == '.' || reason.back() == ':'))
    reason.pop_back();
  return reason + (rows.empty() ? "" : " (" + rows + ")");
}

StartWatch::StartWatch()
{
  int ends[2];
  held_back_ = memfd_create("stderr", MFD_CLOEXEC);
  if (held_back_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return; // without a watch, as Open MPI does it
  stderr_  = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
  watcher_ = fork();
  if (watcher_ == 0)
  {
    // Nothing comes if the other process ends.
    close(ends[1]);
    char sign            = 0;
    const bool has_begun = read(ends[0], &sign, 1) == 1;
    if (!has_begun)
      write_all(stderr_, sentence(reason_in(text_of(held_back_))));
    _exit(0);
  }
  close(ends[0]);
  started_ = ends[1];
  if (watcher_ > 0)
    dup2(held_back_, STDERR_FILENO);
}

StartWatch::~StartWatch()
{
  if (watcher_ > 0)
  {
    dup2(stderr_, STDERR_FILENO);
    send(started_, "y", 1, MSG_NOSIGNAL); // whoever has ended the watcher shall not end us
    waitpid(watcher_, nullptr, 0);
    write_all(STDERR_FILENO, text_of(held_back_));
  }
  for (const int file : {stderr_, held_back_, started_})
    if (file >= 0)
      close(file);
}
} // namespace ricochet
