// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/mesh.h"

#include "support/scratch_directory.h"
#include "support/two_plates_text.h"

namespace ricochet
{
namespace
{
using namespace tests;

TEST(Mesh, IsJudgedAndWrittenAsAFileThatCanBeReadBack)
{
  const ScratchDirectory scratch;
  const auto written = scratch.path() / "ball.msh";
  ::testing::internal::CaptureStdout();
  mesh_projectile(MPI_COMM_WORLD, two_plates_file("unused"), {written.string()});
  const std::string first = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(contains(first, "hexahedra"), rank() == 0) << first;
  EXPECT_EQ(contains(first, "written        " + written.string()), rank() == 0) << first;
  ::testing::internal::CaptureStdout();
  mesh_projectile(
      MPI_COMM_WORLD,
      two_plates_file("unused",
                      {"Projectile/Model=finite elements", "Projectile/Young's modulus=202 GPa",
                       "Projectile/Poisson's ratio=0.3", "Projectile/Mesh=" + written.string()}),
      {});
  const std::string second = ::testing::internal::GetCapturedStdout();
  if (rank() == 0)
  {
    EXPECT_EQ(split(first, '\n').at(0), split(second, '\n').at(0)); // as many cells and nodes
    EXPECT_EQ(split(first, '\n').at(2), split(second, '\n').at(2)); // of the same volume
  }
}
} // namespace
} // namespace ricochet
