// SPDX-License-Identifier: LGPL-2.1-or-later
// Bad input of every kind, a row each: what is wrong with an otherwise good file, the exit status,
// and words of the message. Whatever a row says, the message is one, begins with where, and none of
// its words come from a library.
#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
struct Row
{
  const char *override_text; // as on the command line
  int status;                // of the program
  std::vector<const char *> words;
};

/// What main() makes of an exception, and its message.
struct Ending
{
  int status = 0;
  std::string message;
};

template <class Action>
Ending ending_of(const Action &action)
{
  try
  {
    action();
  }
  catch (const InputError &error)
  {
    return {2, error.what()};
  }
  catch (const FileError &error)
  {
    return {3, error.what()};
  }
  catch (const std::exception &error)
  {
    return {5, error.what()};
  }
  return {};
}

void expect_ending(const Ending &ending, const std::string &what, const int status,
                   const std::vector<const char *> &words)
{
  EXPECT_EQ(ending.status, status) << what << "\n" << ending.message;
  for (const char *const word : words)
    EXPECT_NE(ending.message.find(word), std::string::npos) << what << ": no '" << word << "' in\n"
                                                            << ending.message;
  for (const char *const foreign : {"dealii", "std::", "basic_string", "bad_alloc", "json", "CLI"})
    EXPECT_EQ(ending.message.find(foreign), std::string::npos) << what << "\n" << ending.message;
  EXPECT_NE(ending.message.find(": "), std::string::npos) << what << ": does not say where";
}

const std::vector<Row> overrides{
#include "scene/bad_overrides.inc"
};

TEST(BadInput, EveryRowEndsWithItsStatusAndItsWords)
{
  for (const auto &row : overrides)
    expect_ending(ending_of([&] { read_with({row.override_text}); }), row.override_text, row.status,
                  row.words);
  EXPECT_GE(overrides.size(), 120u);
}
struct TextRow
{
  const char *text; // of the file
  int status;
  std::vector<const char *> words;
};

// Lines that cannot be read, whatever they are about.
const std::vector<TextRow> texts{
    {"", 2, {"scene.prm: ", "entries without a default are missing", "ricochet template"}},
    {"Speed = 5 m/s\n", 2, {"scene.prm:1: ", "is not an entry", "begins with 'set'"}},
    {"set Title\n", 2, {"scene.prm:1: ", "does not have the form of an entry"}},
    {"set = 5\n", 2, {"scene.prm:1: ", "does not have the form of an entry"}},
    {"sett Title = x\n", 2, {"scene.prm:1: ", "is not an entry"}},
    {"Title x\n", 2, {"scene.prm:1: ", "cannot be understood"}},
    {"subsectoin Impact\n", 2, {"scene.prm:1: ", "did you mean 'subsection'?"}},
    {"subsection\nend\n", 2, {"scene.prm:1: ", "The section has no name"}},
    {"subsection Impact\n", 2, {"scene.prm:1: ", "has no 'end'"}},
    {"subsection Impact\nsubsection Time\nend\n", 2, {"scene.prm:2: ", "open since line 1"}},
    {"end\n", 2, {"scene.prm:1: ", "no section for this 'end'"}},
    {"subsection Impact\nend Impact\n", 2, {"scene.prm:2: ", "Nothing may follow 'end'"}},
    {"include\n", 2, {"scene.prm:1: ", "names no file"}},
    {"include nowhere.prm\n", 3, {"scene.prm:1: ", "There is no file 'nowhere.prm'"}},
    {"subsection Impact\ninclude a.prm\nend\n", 2, {"scene.prm:2: ", "stands inside the section"}},
    {"set Title = a\nset Title = b\n", 2, {"scene.prm:2: ", "already set in scene.prm:1"}},
    {"subsection Plate 2\nend\n", 2, {"scene.prm:1: ", "but no 'Plate 1'"}},
    {"subsection Projectile 1\nend\n", 2, {"scene.prm:1: ", "called 'Projectile'"}},
    {"subsection Projectile 2\nend\n", 2, {"scene.prm:1: ", "but no 'Impact 2'"}},
    {"subsection Projectile 3\nend\n", 2, {"scene.prm:1: ", "but no 'Projectile 2'"}},
};

TEST(BadInput, LinesThatCannotBeReadAreNamed)
{
  for (const auto &row : texts)
    expect_ending(ending_of([&] { read_scene(ParameterFile::from_text(row.text, "scene.prm")); }),
                  row.text, row.status, row.words);
}

TEST(BadInput, AllErrorsOfAFileAreToldAtOnce)
{
  const auto lines = ending_of(
      [&] { ParameterFile::from_text("Speed = 5\nset Title\nend\nset A = 1\nset A = 2\n", "a"); });
  expect_ending(lines, "lines", 2, {"4 errors:", "a:1: ", "a:2: ", "a:3: ", "a:5: "});
  const auto values = ending_of(
      [&]
      {
        read_with({"Impact/Speed=5", "Plate 1/Grid spacing=x", "Impact/Sped=5 m/s",
                   "Tme/Final time=1 s", "Projectile/Density=1 g/cm3"});
      });
  expect_ending(values, "values", 2,
                {"5 errors:", "Impact/Speed = '5'", "Plate 1/Grid spacing = 'x'",
                 "did you mean 'Speed'?", "did you mean 'Time'?",
                 "'Projectile/Density' is given, but so is 'Mass'"});
  const auto checks = ending_of(
      [&]
      {
        read_with(
            {"Time/Safety factor=2", "Impact/Incidence angle=100 deg", "Plate 1/Horizon ratio=1"});
      });
  expect_ending(checks, "checks", 2,
                {"3 errors:", "Time/Safety factor = '2'", "Impact/Incidence angle = '100 deg'",
                 "Plate 1/Horizon ratio = '1'"});
  const auto between = ending_of(
      [&] {
        read_with({"Impact/Yaw angle=5 deg", "Plate 1/Gap=1 mm", "Plate 1/Material=lead"});
      });
  expect_ending(between, "between sections", 2,
                {"3 errors:", "Impact/Yaw angle", "Plate 1/Gap", "Plate 1/Material"});
}

TEST(BadInput, WhatFollowsFromAMisspeltNameIsNotToldApart)
{
  std::string text = scene_text;
  text.replace(text.find("set Speed"), 9, "set Sped"); // so 'Speed' is missing as well
  const auto ending = ending_of([&] { read_scene(ParameterFile::from_text(text, "scene.prm")); });
  expect_ending(ending, "misspelt", 2, {"scene.prm:", "There is no entry 'Sped'"});
  EXPECT_EQ(ending.message.find("missing"), std::string::npos) << ending.message;
  EXPECT_EQ(ending.message.find("errors:"), std::string::npos) << ending.message;
}

TEST(BadInput, OfTheCommandLineIsToldAtOnce)
{
  expect_ending(ending_of(
                    [&] {
                      parse_overrides({"Impact", "=5", "Impact/Speed=5 m/s"});
                    }),
                "command line", 2, {"2 errors:", "'Impact' does not name", "'=5' does not name"});
  expect_ending(
      ending_of(
          [&] {
            scene_with({"Impact/Speed=5 m/s", "Impact/Speed=6 m/s", "Title=a", "Title=b"});
          }),
      "twice", 2, {"2 errors:", "'Impact/Speed' is set twice", "'Title' is set twice"});
}
} // namespace
} // namespace ricochet::tests
