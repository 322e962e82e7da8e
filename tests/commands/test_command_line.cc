// SPDX-License-Identifier: LGPL-2.1-or-later
// What the command line turns into, without running it.
#include "commands/cli/command.h"
#include "commands/several_processes.h"

#include "support/environment.h"
#include "support/scratch_directory.h"

#include <nlohmann/json.hpp>

namespace ricochet
{
namespace
{
using namespace tests;

struct Parsed
{
  explicit Parsed(const std::string &line) : commands(declare_commands(app)) { app.parse(line); }

  CLI::App app;
  std::vector<Command> commands;
};

TEST(CommandLine, NamesOneCommand)
{
  for (const char *line :
       {"run a.prm --quiet", "check a.prm --coupling", "mesh a.prm --write a.msh",
        "study a.prm --resume", "run --resume folder", "template", "columns --json",
        "bench kernel --edge 20", "bench elements --element full", "bench history --decades 2",
        "bench search --repeats 1"})
  {
    const Parsed parsed(line);
    const std::string name = chosen(parsed.commands).app->get_name();
    EXPECT_TRUE(contains(line, name)) << line << " is " << name;
  }
}

TEST(CommandLine, RefusesWhatNoCommandKnows)
{
  for (const char *line : {"", "fly", "run a.prm --fast", "bench", "bench sun",
                           "bench search --processes 0", "bench search --processes many"})
    EXPECT_THROW(Parsed parsed(line), CLI::ParseError) << line;
}

TEST(CommandLine, ProcessesAreAskedForByTheSearchAlone)
{
  EXPECT_EQ(chosen(Parsed("bench search --processes 4").commands).n_processes(), 4);
  EXPECT_EQ(chosen(Parsed("bench search").commands).n_processes(), 1);
  EXPECT_EQ(chosen(Parsed("run a.prm").commands).n_processes(), 1);
}

TEST(CommandLine, TextsAreWrittenWithoutACommunicator)
{
  const auto text_of = [](const char *line)
  {
    const Parsed parsed(line);
    EXPECT_FALSE(chosen(parsed.commands).execute) << line;
    std::ostringstream text;
    chosen(parsed.commands).write(text);
    return text.str();
  };
  EXPECT_EQ(nlohmann::json::parse(text_of("columns --json"))["history"][0]["name"], "time");
  EXPECT_TRUE(contains(text_of("columns"), "time"));
  EXPECT_TRUE(contains(text_of("template"), "subsection Projectile"));
  EXPECT_FALSE(nlohmann::json::parse(text_of("template --json")).empty());
  for (const char *line : {"run a.prm", "check a.prm", "mesh a.prm", "study a.prm", "bench kernel"})
  {
    const Parsed parsed(line);
    EXPECT_TRUE(chosen(parsed.commands).execute && !chosen(parsed.commands).write) << line;
  }
}

TEST(CommandLine, RunWantsAFileOrAFolderToGoOnIn)
{
  const auto problem = [](const char *line)
  {
    const Parsed parsed(line);
    try
    {
      chosen(parsed.commands).execute(MPI_COMM_SELF);
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_TRUE(contains(problem("run"), "what is to be run?"));
  for (const char *line : {"run a.prm --resume folder", "run --resume folder --output other",
                           "run --resume folder --force"})
    EXPECT_TRUE(contains(problem(line), "Leave out the parameter file, --output and --force"))
        << line;
}

TEST(CommandLine, MissingFileIsAFileError)
{
  for (const char *line : {"run no/such.prm", "check no/such.prm", "study no/such.prm"})
  {
    const Parsed parsed(line);
    EXPECT_TRUE(contains(message_of([&] { chosen(parsed.commands).execute(MPI_COMM_SELF); }),
                         "no/such.prm"));
  }
}

TEST(SeveralProcesses, AreNotStartedTwiceNorForOne)
{
  char name[] = "ricochet";
  char *argv[]{name, nullptr};
  EXPECT_EQ(start_processes(1, 1, argv), 0);
  const Variable one_of_several("OMPI_COMM_WORLD_SIZE", "4");
  EXPECT_EQ(start_processes(4, 1, argv), 0);
}

TEST(SeveralProcesses, KnowTheirRankBeforeMpiStarts)
{
  if (launched_rank())
    GTEST_SKIP() << "is one of several already";
  for (const char *name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
  {
    const Variable rank(name, "3");
    EXPECT_EQ(launched_rank(), 3) << name;
  }
  EXPECT_FALSE(launched_rank());
}

TEST(SeveralProcesses, WithoutMpirunSayWhatIsMissing)
{
  if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr)
    GTEST_SKIP() << "is one of several already";
  char name[] = "ricochet";
  char *argv[]{name, nullptr};
  const Variable nowhere("PATH", "/no/where");
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(start_processes(2, 1, argv), 3);
  EXPECT_TRUE(contains(::testing::internal::GetCapturedStderr(), "openmpi-bin"));
}
} // namespace
} // namespace ricochet
