// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/mesh.h"

#include "ricochet/geometry/revolved_hexes.h"
#include "ricochet/scene/mesh_file.h"
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

/// The command on an ogive whose mesh is in this file.
void judge_ogive(const std::filesystem::path &mesh, const std::string &symmetric = "true")
{
  mesh_projectile(
      MPI_COMM_WORLD,
      two_plates_file("unused",
                      {"Projectile/Nose shape=ogive", "Projectile/Diameter=6.17 mm",
                       "Projectile/Length=27.6 mm", "Projectile/Nose length=10.23 mm",
                       "Projectile/Model=finite elements", "Projectile/Young's modulus=202 GPa",
                       "Projectile/Poisson's ratio=0.3", "Symmetric=" + symmetric,
                       "Projectile/Mesh=" + mesh.string()}),
      {});
}

TEST(Mesh, OfAHalfIsJudgedAsAHalfAndRefusedInAWholeScene)
{
  const ScratchDirectory scratch;
  const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});
  const auto whole = scratch.path() / "whole.msh", half = scratch.path() / "half.msh";
  if (rank() == 0)
  {
    const HexSolid solid = revolved_hexes(core, 2);
    std::ofstream whole_file(whole), half_file(half);
    write_mesh(solid, core, 1e-3, whole_file);
    write_mesh(upper_half(solid, 1e-9), core, 1e-3, half_file);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  std::string told[2];
  for (const bool is_half : {false, true})
  {
    ::testing::internal::CaptureStdout();
    judge_ogive(is_half ? half : whole);
    told[is_half ? 1 : 0] = ::testing::internal::GetCapturedStdout();
  }
  if (rank() == 0)
  {
    EXPECT_TRUE(contains(told[0], "-0.06 % against the shape")) << told[0];
    EXPECT_TRUE(contains(told[1], "-0.06 % against the half of the shape")) << told[1];
    EXPECT_EQ(split(told[0], '(').back(), split(told[1], '(').back()); // material, the same density
  }
  EXPECT_THROW(judge_ogive(half, "false"), InputError);
}

TEST(Mesh, ThatWouldFlyBaseFirstIsRefused)
{
  const ScratchDirectory scratch;
  const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});
  const auto path = scratch.path() / "reversed.msh";
  if (rank() == 0)
  {
    HexSolid solid = revolved_hexes(core, 1);
    for (auto &x : solid.nodes)
      x.head<2>() *= -1.;
    std::ofstream file(path);
    write_mesh(solid, core, 1e-3, file);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  std::string told;
  try
  {
    judge_ogive(path);
  }
  catch (const InputError &error)
  {
    told = error.what();
  }
  EXPECT_TRUE(contains(told, "tip at the lower end")) << told;
}
} // namespace
} // namespace ricochet
