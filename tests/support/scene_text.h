// SPDX-License-Identifier: LGPL-2.1-or-later
// A complete parameter text with round numbers, and checks of what an error says.
#pragma once

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace ricochet::tests
{
inline const std::string scene_text = R"(set Title = Test
subsection Projectile
  set Nose shape = ogive
  set Diameter = 6 mm
  set Length = 28 mm
  set Nose length = 10 mm
  set Mass = 5 g
end
subsection Impact
  set Speed = 0.72 mm/us
  set Incidence angle = 30 deg
  set Entry point = 50 mm, 0 mm
end
subsection Plate 1
  set Size = 20 cm, 100 mm, 30 mm
  set Grid spacing = 2 mm
  set Material = PMMA
end
subsection Material PMMA
  set Density = 1.19 g/cm3
  set Bulk modulus = 5.9 GPa
  set Shear modulus = 2258 MPa
  set Critical stretch = 0.01
end
subsection Contact
  set Friction law = exponential
  set Static friction = 0.5
  set Kinetic friction = 0.05
  set Friction decay = 10 us/mm
end
subsection Time
  set Final time = 0.45 ms
end
)";

/// The text above, "scene.prm", with overrides as on the command line.
inline ParameterFile scene_with(const std::vector<std::string> &overrides)
{
  return ParameterFile::from_text(scene_text, "scene.prm", parse_overrides(overrides));
}

/// The action throws Exception with a message that contains all the parts, and no trace of deal.II.
template <class Exception = InputError, class Action>
void expect_error(const Action &action, const std::vector<std::string> &parts)
{
  try
  {
    action();
    FAIL() << "nothing was thrown; expected an error about " << parts.front();
  }
  catch (const Exception &error)
  {
    const std::string message = error.what();
    for (const auto &part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in:\n" << message;
    EXPECT_EQ(message.find("dealii"), std::string::npos) << message;
  }
}

inline Scene read_with(const std::vector<std::string> &overrides)
{
  return read_scene(scene_with(overrides));
}

inline void expect_scene_error(const std::vector<std::string> &overrides,
                               const std::vector<std::string> &parts)
{
  expect_error([&] { read_with(overrides); }, parts);
}

inline void expect_text_error(const std::string &text, const std::vector<std::string> &parts)
{
  expect_error([&] { read_scene(ParameterFile::from_text(text, "scene.prm")); }, parts);
}

/// A folder of files that lasts as long as this object.
class Folder
{
public:
  Folder()
  {
    const auto *const test = testing::UnitTest::GetInstance()->current_test_info();
    path_                  = std::filesystem::temp_directory_path() /
            ("ricochet_" + std::string(test->test_suite_name()) + "_" + test->name());
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder &)            = delete;
  Folder &operator=(const Folder &) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  /// Writes a file and returns its path.
  std::string write(const std::string &name, const std::string &text) const
  {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }

private:
  std::filesystem::path path_;
};
} // namespace ricochet::tests
