// SPDX-License-Identifier: LGPL-2.1-or-later
// What the tests of the field writer do not see: elements, and the index after a failure.
#include "ricochet/output/vtu_writer.h"

#include "support/scratch_directory.h"

namespace ricochet
{
namespace
{
using namespace tests;

ElementFrame one_cube()
{
  ElementFrame frame;
  std::array<Vector3, 8> corners;
  for (int c = 0; c < 8; ++c)
    corners[c] = Vector3(c & 1, (c >> 1) & 1, c >> 2);
  frame.corners.push_back(corners);
  frame.displacement.emplace_back(1., 2., 3.);
  frame.velocity.emplace_back(4., 5., 6.);
  frame.state.add({});
  frame.body.push_back(1);
  return frame;
}

SurfaceFrame one_square()
{
  SurfaceFrame surface;
  surface.vertices = {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {0., 1., 0.}};
  surface.quads    = {{0, 1, 2, 3}};
  return surface;
}

TEST(VtuWriter, ElementsOfOneRankAreWrittenByAllAndNoneByNone)
{
  const ScratchDirectory scratch;
  VtuWriter writer(MPI_COMM_WORLD, scratch.path());
  const bool last = rank() == n_ranks() - 1;
  writer.write(0, 0., {}, one_square(), last ? one_cube() : ElementFrame());
  writer.write(1, 1e-6, {}, one_square());
  if (rank() != 0)
    return;
  const std::string index = read_text(scratch.path() / "results.pvd");
  EXPECT_TRUE(contains(index, "vtu/elements_0000.pvtu")) << index;
  EXPECT_FALSE(contains(index, "elements_0001")) << index;
  for (int r = 0; r < n_ranks(); ++r)
  {
    const std::string piece =
        read_text(scratch.path() / "vtu" / ("elements_0000.00" + std::to_string(r) + ".vtu"));
    EXPECT_EQ(contains(piece, "NumberOfCells=\"1\""), r == n_ranks() - 1) << piece;
  }
}

TEST(VtuWriter, IndexNamesAFrameOnceEvenIfTheFirstTryFailed)
{
  const ScratchDirectory scratch;
  VtuWriter writer(MPI_COMM_WORLD, scratch.path());
  writer.write(0, 0., {}, one_square());
  {
    const FileSizeLimit limit(200);
    message_of([&] { writer.write(1, 1e-6, {}, one_square()); });
  }
  writer.write(1, 2e-6, {}, one_square());
  if (rank() != 0)
    return;
  const std::string index = read_text(scratch.path() / "results.pvd");
  EXPECT_FALSE(contains(index, "timestep=\"1e-06\"")) << index;
  EXPECT_TRUE(contains(index, "timestep=\"2e-06\"")) << index;
}
} // namespace
} // namespace ricochet
