// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/parameter_file.h"

#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
void expect_file_error(const std::string &text, const std::vector<std::string> &parts)
{
  expect_error([&] { ParameterFile::from_text(text, "a.prm"); }, parts);
}

/// "section/name=value (origin)" of every entry.
std::vector<std::string> listed(const ParameterFile &file)
{
  std::vector<std::string> lines;
  for (const auto &entry : file.entries())
    lines.push_back(entry.section + "/" + entry.name + "=" + entry.value + " (" + entry.origin +
                    ")");
  return lines;
}

using Lines = std::vector<std::string>;

TEST(ParameterFile, EntriesKnowSectionValueAndLine)
{
  const auto file = ParameterFile::from_text("# comment\n"
                                             "set Title = one  two # comment\r\n"
                                             "\n"
                                             "subsection  Plate   1\n"
                                             "\tset Grid  spacing=1.5 mm\n"
                                             "END\n"
                                             "subsection Empty\nend",
                                             "dir/a.prm");
  EXPECT_EQ(listed(file),
            (Lines{"/Title=one two (dir/a.prm:2)", "Plate 1/Grid spacing=1.5 mm (dir/a.prm:5)"}));
  ASSERT_EQ(file.sections().size(), 2U);
  EXPECT_EQ(file.sections()[1].name, "Empty");
  EXPECT_EQ(file.sections()[1].origin, "dir/a.prm:7");
}

TEST(ParameterFile, BackslashContinuesALine)
{
  const auto file = ParameterFile::from_text("set A = 1, \\\n  2\nset B = 3\n", "a.prm");
  EXPECT_EQ(listed(file), (Lines{"/A=1, 2 (a.prm:1)", "/B=3 (a.prm:3)"}));
}

TEST(ParameterFile, RepeatedEntryNamesBothLines)
{
  expect_file_error("subsection Impact\nset Speed = 1 m/s\nend\n"
                    "subsection Impact\nset Speed = 2 m/s\nend\n",
                    {"a.prm:5", "'Impact/Speed'", "a.prm:2", "Remove one"});
}

TEST(ParameterFile, UnbalancedSectionsAreFoundWithTheirLine)
{
  expect_file_error("set A = 1\nsubsection Impact\nset B = 2\n",
                    {"a.prm:2", "'Impact'", "no 'end'"});
  expect_file_error("set A = 1\nend\n", {"a.prm:2", "no section for this 'end'"});
  expect_file_error("subsection Impact\nsubsection Time\nend\n",
                    {"a.prm:2", "'Time'", "inside the section 'Impact'", "line 1"});
}

TEST(ParameterFile, LinesOfAnotherFormAreExplained)
{
  expect_file_error("Title = 3\n", {"a.prm:1", "'set Title = 3'"});
  expect_file_error("end time = 3 us\n", {"a.prm:1", "begins with 'set'"});
  expect_file_error("end of it\n", {"a.prm:1", "Nothing may follow 'end'", "#"});
  expect_file_error("subsecton Impact\n", {"a.prm:1", "did you mean 'subsection'?"});
  expect_file_error("set Title\n", {"a.prm:1", "set NAME = VALUE"});
  expect_file_error("set = 3\n", {"a.prm:1", "set NAME = VALUE"});
  expect_file_error("subsection\n", {"a.prm:1", "has no name"});
  expect_file_error("include\n", {"a.prm:1", "include FILE"});
}

TEST(ParameterFile, IncludingFileOverridesTheIncludedOne)
{
  const Folder folder;
  const std::string base =
      folder.write("shared/base.prm", "set A = 1\nset B = 1\nsubsection S\nset C = 1\nend\n");
  // Also entries before the include win.
  const std::string path = folder.write("case/case.prm", "set A = 2\ninclude ../shared/base.prm\n"
                                                         "subsection S\nset C = 2\nend\n");
  const ParameterFile file(path);
  EXPECT_EQ(listed(file),
            (Lines{"/A=2 (" + path + ":1)", "/B=1 (" + base + ":2)", "S/C=2 (" + path + ":4)"}));
}

TEST(ParameterFile, LaterIncludeOverridesTheEarlierOne)
{
  const Folder folder;
  folder.write("one.prm", "set A = 1\n");
  const std::string two = folder.write("two.prm", "set A = 2\n");
  const std::string all = folder.write("all.prm", "include one.prm\ninclude two.prm\n");
  EXPECT_EQ(listed(ParameterFile(all)), (Lines{"/A=2 (" + two + ":1)"}));
}

TEST(ParameterFile, IncludeCycleIsNamed)
{
  const Folder folder;
  const std::string a = folder.write("a.prm", "include b.prm\n");
  folder.write("b.prm", "# nothing here\ninclude c.prm\n");
  folder.write("c.prm", "include b.prm\n");
  expect_error([&] { ParameterFile file(a); },
               {"c.prm:1", "circle", "b.prm -> c.prm -> b.prm", "Remove"});
}

TEST(ParameterFile, MissingFilesAreNamed)
{
  const Folder folder;
  expect_error<FileError>([] { ParameterFile file("no/such.prm"); }, {"'no/such.prm'"});
  const std::string a = folder.write("a.prm", "\ninclude b.prm\n");
  expect_error<FileError>([&] { ParameterFile file(a); },
                          {a + ":2", "b.prm'", "relative to the including file"});
}

TEST(ParameterFile, IncludeInsideASectionIsAnError)
{
  expect_file_error("subsection S\ninclude b.prm\nend\n", {"a.prm:2", "inside the section 'S'"});
}

TEST(ParameterFile, OverridesWinAndComeFromTheCommandLine)
{
  const auto file = ParameterFile::from_text(
      "subsection Plate 1\nset Grid spacing = 1.5 mm\nend\n", "a.prm",
      parse_overrides({"Plate 1/Grid spacing=1.0 mm", " Title = x=y ", "New/Entry=3 m/s"}));
  EXPECT_EQ(listed(file), (Lines{"Plate 1/Grid spacing=1.0 mm (command line)",
                                 "/Title=x=y (command line)", "New/Entry=3 m/s (command line)"}));
  ASSERT_EQ(file.sections().size(), 2U);
  EXPECT_TRUE(file.sections()[0].in_file);
  EXPECT_FALSE(file.sections()[1].in_file);
}

TEST(ParameterFile, OverridesOfAnotherFormAreExplained)
{
  expect_error([] { parse_override("Speed"); }, {"command line", "'Speed'", "Section/Entry=value"});
  expect_error([] { parse_override("=3"); }, {"command line", "Section/Entry=value"});
  expect_error([] { parse_override("Title=a # b"); }, {"command line", "#"});
  expect_error(
      [] {
        ParameterFile::from_text("", "a.prm", parse_overrides({"A=1", "A=2"}));
      },
      {"command line", "'A'", "twice", "'1'", "'2'"});
}
} // namespace
} // namespace ricochet::tests
