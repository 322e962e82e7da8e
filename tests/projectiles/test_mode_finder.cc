// SPDX-License-Identifier: LGPL-2.1-or-later
// The cache of a projectile's modes.
#include "projectiles/mode_finder.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/environment.h"
#include "support/hexahedra.h"
#include "support/scratch_directory.h"

#include <gtest/gtest.h>

#include <fstream>

namespace ricochet::tests
{
namespace
{
const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});

struct Finder
{
  HexahedralBody mesh{revolved_hexes(core, 1), steel(), false};
  ModeFinder finder;

  Finder() : finder(MPI_COMM_SELF, mesh, loads()) {}
  ModeFinder::Loads loads() const
  {
    ModeFinder::Loads loads;
    for (int i = 0; i < 2; ++i)
    {
      loads[i].assign(3 * mesh.n_nodes(), 0.);
      loads[i][2 * i] = 1.;
    }
    return loads;
  }
};

std::vector<std::filesystem::path> files_in(const std::filesystem::path &folder)
{
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(folder))
    for (const auto &entry : std::filesystem::directory_iterator(folder))
      files.push_back(entry.path());
  return files;
}

void expect_equal(const ProjectileModes &a, const ProjectileModes &b)
{
  EXPECT_EQ(a.modes.squared_frequency, b.modes.squared_frequency);
  EXPECT_EQ(a.modes.shape, b.modes.shape);
  EXPECT_EQ(a.compliance, b.compliance);
}

TEST(ModeFinder, KeepsModesAndComputesAnewWhatIsDamaged)
{
  const ScratchDirectory scratch;
  const Variable cache("XDG_CACHE_HOME", scratch.path().string());
  const auto first = Finder().finder.lowest(6);
  const auto files = files_in(scratch.path() / "ricochet");
  ASSERT_EQ(files.size(), 1U);
  const auto size = std::filesystem::file_size(files[0]);
  const auto time = std::filesystem::last_write_time(files[0]);
  expect_equal(Finder().finder.lowest(6), first);
  EXPECT_EQ(std::filesystem::last_write_time(files[0]), time) << "read, not written";

  for (const auto place : {std::uintmax_t(3), size / 2, size - 1})
  {
    {
      std::fstream file(files[0], std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(static_cast<std::streamoff>(place));
      file.put('\x5a');
    }
    expect_equal(Finder().finder.lowest(6), first);
  }
  std::filesystem::resize_file(files[0], size - 8);
  expect_equal(Finder().finder.lowest(6), first);
  std::filesystem::resize_file(files[0], 0);
  expect_equal(Finder().finder.lowest(6), first);
  EXPECT_EQ(std::filesystem::file_size(files[0]), size);
  EXPECT_EQ(files_in(scratch.path() / "ricochet").size(), 1U) << "nothing temporary is left";

  Finder().finder.lowest(7); // another question, another file
  EXPECT_EQ(files_in(scratch.path() / "ricochet").size(), 2U);
}

TEST(ModeFinder, DoesWithoutACacheThatCannotBe)
{
  const ScratchDirectory scratch;
  {
    const Variable cache("XDG_CACHE_HOME", ""), home("HOME", "");
    EXPECT_EQ(mode_cache(), "");
    EXPECT_EQ(Finder().finder.lowest(6).modes.shape.size(), 6U);
  }
  {
    const Variable cache("XDG_CACHE_HOME", ""), home("HOME", scratch.path().string());
    EXPECT_EQ(mode_cache(), scratch.path() / ".cache" / "ricochet");
  }
  std::ofstream(scratch.path() / "file") << "no folder";
  const Variable cache("XDG_CACHE_HOME", (scratch.path() / "file").string());
  EXPECT_EQ(Finder().finder.lowest(6).modes.shape.size(), 6U);
}

TEST(ModeFinder, SaysWhatItCannotFind)
{
  const Variable cache("XDG_CACHE_HOME", ""), home("HOME", "");
  EXPECT_THROW(Finder().finder.lowest(100000), InputError);
}
} // namespace
} // namespace ricochet::tests
