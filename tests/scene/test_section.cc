// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of sections on their own, with variables made up for it.
#include "scene/section.h"

#include "ricochet/scene/text_tools.h"
#include "scene/parameter_writer.h"
#include "scene/section_checks.h"
#include "support/scene_text.h"

#include <sstream>

namespace ricochet::tests
{
namespace
{
enum class Colour
{
  red,
  green
};

const Words<Colour> colours{{Colour::red, "red"}, {Colour::green, "green"}};

/// A section with one entry of each kind.
struct Paint
{
  Colour colour = Colour::red;
  double layer = 0., density = 0., mass = 0., width = 0., height = 0.;
  bool is_matt = false;
  std::string maker, brush;
  std::vector<double> drying;
  bool checked = false;

  std::vector<Section> sections()
  {
    Section in("Paint", "What it is painted with.");
    const Entry &chosen = in.required("Colour", choice(colour, colours), "green", "Its colour");
    const Entry &thickness =
        in.with_default("Layer", quantity(layer, Dimension::length, Limit::positive), "0.1 mm",
                        "Thickness of a layer");
    const Entry &per_volume =
        in.optional("Density", quantity(density, Dimension::density, Limit::positive), "1 g/cm3",
                    "Mass per volume");
    const Entry &whole =
        in.optional("Mass", quantity(mass, Dimension::mass, Limit::positive), "1 kg", "Its mass");
    in.one_of({{&per_volume}, {&whole}}, when(chosen, colours, {Colour::green}));
    in.optional("Size",
                quantities({&width, &height}, {"width", "height"}, Dimension::length, Limit::any),
                "1 m, 2 m", "Of the wall");
    in.with_default("Matt", flag(is_matt), "true", "Whether it does not shine");
    in.named_after_file("Maker", text(maker, "any text"), "file", "A maker", "Who made it");
    in.with_default("Brush", word(brush, {"broad", "thin"}), "thin", "Which brush");
    in.optional("Drying", quantity_list(drying, Dimension::time, Limit::positive), "1 s, 2 s",
                "Times between layers");
    in.check(
        [this, &thickness]
        {
          checked = true;
          if (layer > 1e-3)
            thickness.fail("It will run down.", "Choose a thinner one.");
        });
    std::vector<Section> sections;
    sections.push_back(std::move(in));
    return sections;
  }
};

ParameterFile paint_file(const std::string &entries)
{
  return ParameterFile::from_text("subsection Paint\n" + entries + "end\n", "paint.prm");
}

TEST(Section, BoundVariablesTakeValuesAndDefaults)
{
  Paint paint;
  auto sections = paint.sections();
  read_and_check_sections(paint_file("set Colour = green\nset Mass = 2 kg\nset Size = 1 m, 20 cm\n"
                                     "set Matt = false\nset Drying = 1 s, 2 ms, 3 us\n"
                                     "set Brush = broad\nset Maker = Someone\n"),
                          sections);
  EXPECT_EQ(paint.colour, Colour::green);
  EXPECT_EQ(paint.mass, 2.);
  EXPECT_EQ(paint.density, 0.); // not given: as it was
  EXPECT_DOUBLE_EQ(paint.layer, 1e-4);
  EXPECT_DOUBLE_EQ(paint.width, 1.);
  EXPECT_DOUBLE_EQ(paint.height, 0.2);
  EXPECT_FALSE(paint.is_matt);
  EXPECT_EQ(paint.drying, (std::vector<double>{1., 2e-3, 3e-6}));
  EXPECT_EQ(paint.brush, "broad");
  EXPECT_EQ(paint.maker, "Someone");
  EXPECT_TRUE(paint.checked);
}

TEST(Section, ChecksSpeakOfTheLine)
{
  Paint paint;
  auto sections = paint.sections();
  expect_error(
      [&]
      { read_and_check_sections(paint_file("set Colour = red\nset Layer = 2 mm\n"), sections); },
      {"paint.prm:3: Paint/Layer = '2 mm': It will run down.\n  Choose a thinner one."});
  Paint other;
  auto unchecked = other.sections();
  read_sections(paint_file("set Colour = red\nset Layer = 2 mm\n"), unchecked);
  EXPECT_FALSE(other.checked);
}

TEST(Section, ConditionsLookAtTheOtherEntry)
{
  Paint paint;
  auto sections = paint.sections();
  read_sections(paint_file("set Colour = red\n"), sections); // red needs neither
  expect_error([&] { read_sections(paint_file("set Colour = green\n"), sections); },
               {"An entry without a default is missing", "set Density = 1 g/cm3   # or: set Mass = "
                                                         "1 kg"});
  expect_error(
      [&]
      {
        read_sections(paint_file("set Colour = green\nset Mass = 1 kg\nset Density = 1 g/cm3\n"),
                      sections);
      },
      {"'Paint/Mass' is given, but so is 'Density' (paint.prm:4)", "'set Density ='"});
}

TEST(Section, SecondRowOfANameBindsAnotherVariable)
{
  double one = 0., two = 0.;
  std::vector<Section> sections;
  sections.emplace_back("Twin", "");
  Section &in        = sections.back();
  const Entry &first = in.optional("A", quantity(one, Dimension::number, Limit::any), "1", "An A");
  const Entry &again = in.optional("A", quantity(two, Dimension::number, Limit::any), "1", "An A");
  EXPECT_EQ(&first, &again);
  read_sections(ParameterFile::from_text("subsection Twin\nset A = 3\nend\n", "a.prm"), sections);
  EXPECT_EQ(one, 3.);
  EXPECT_EQ(two, 3.);
}

TEST(ParameterWriter, WritesWhatHasAValueAndMarksDefaults)
{
  Paint paint;
  auto sections = paint.sections();
  read_sections(paint_file("set Colour = green\nset Mass = 2000 g\n"), sections);
  std::ostringstream out;
  write_parameters(sections, out);
  EXPECT_EQ(out.str(), "\nsubsection Paint\n"
                       "  set Colour  = green\n"
                       "  set Layer   = 0.1 mm # default\n"
                       "  set Mass    = 2000 g\n"
                       "  set Matt    = true # default\n"
                       "  set Maker   = file # default\n"
                       "  set Brush   = thin # default\n"
                       "end\n");
}

TEST(ParameterWriter, BreaksCommentsBetweenWords)
{
  std::ostringstream out;
  write_comment("one two three four", "  ", 12, out);
  EXPECT_EQ(out.str(), "  # one two\n  # three\n  # four\n");
  EXPECT_EQ(padded("ab", 4), "ab  ");
  EXPECT_EQ(padded("abcd", 2), "abcd");
}
} // namespace
} // namespace ricochet::tests
