// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_case.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/summary.h"
#include "ricochet/scene/scene_reader.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

std::string read_text(const std::filesystem::path &path)
{
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Whether the field is there, a truth value and false.
bool is_false(const Json &summary, const char *name)
{
  const auto field = summary.find(name);
  return field != summary.end() && field->is_boolean() && !field->get<bool>();
}

std::string reason_against(const Json &summary, const std::string &parameters,
                           const std::filesystem::path &directory)
{
  if (!summary.is_object())
    return "its summary.json cannot be read";
  if (summary.value("version", Json()) != version())
    return "it was made by another version, " + summary.value("version", Json("unknown")).dump();
  if (!is_untouched(summary))
    return "its summary.json has been changed";
  if (!is_false(summary, "failed"))
    return "it failed";
  if (!is_false(summary, "interrupted"))
    return "it was interrupted";
  if (read_text(directory / "used.prm") != parameters)
    return "its parameters are others now";
  return "";
}

std::filesystem::path status_file(const std::filesystem::path &study_directory,
                                  const std::string &name)
{
  return lock_of(study_directory, name).string() + ".status";
}
} // namespace

bool has_failed(const std::string &status)
{
  return status.rfind("failed", 0) == 0;
}

std::filesystem::path lock_of(const std::filesystem::path &study_directory, const std::string &name)
{
  return study_directory / ".locks" / name;
}

void leave_status(const std::filesystem::path &study_directory, const std::string &name,
                  const std::string &status)
{
  write_file(status_file(study_directory, name), status);
}

std::string left_status(const std::filesystem::path &study_directory, const std::string &name)
{
  return read_text(status_file(study_directory, name));
}

void forget_status(const std::filesystem::path &study_directory, const std::string &name)
{
  std::error_code ignored; // there may be none
  std::filesystem::remove(status_file(study_directory, name), ignored);
}

Json summary_in(const std::filesystem::path &directory)
{
  Json summary = Json::parse(read_text(directory / "summary.json"), nullptr,
                             /*allow_exceptions=*/false);
  return summary.is_object() ? summary : Json();
}

Earlier earlier_run(const MPI_Comm communicator, const ParameterFile &file,
                    const std::filesystem::path &directory)
{
  Earlier earlier;
  bool finished = false;
  if (rank_in(communicator) == 0 && std::filesystem::exists(directory / "summary.json"))
  {
    std::ostringstream used;
    write_used_parameters(file, used);
    earlier.summary = Json::parse(read_text(directory / "summary.json"), nullptr,
                                  /*allow_exceptions=*/false);
    earlier.why_not = reason_against(earlier.summary, used.str(), directory);
    finished        = earlier.why_not.empty();
  }
  if (!broadcast(communicator, finished, /*root=*/0))
    earlier.summary = Json();
  else if (earlier.summary.is_null())
    earlier.summary = Json::object();
  return earlier;
}

CaseLock::CaseLock(const MPI_Comm communicator, const std::filesystem::path &path)
{
  bool taken = false;
  on_first_rank(communicator,
                [&]
                {
                  make_directory(path.parent_path());
                  descriptor_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
                  // Where locks cannot be had the case runs without.
                  taken       = descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 &&
                          errno == EWOULDBLOCK;
                });
  is_held_ = !broadcast(communicator, taken, /*root=*/0);
}

CaseLock::~CaseLock()
{
  if (descriptor_ >= 0)
    close(descriptor_);
}
} // namespace ricochet
