// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/check.h"

#include "support/scratch_directory.h"
#include "support/two_plates_text.h"

namespace ricochet
{
namespace
{
using namespace tests;

std::string printed(const ParameterFile &file, const CheckOptions &options, bool &good)
{
  ::testing::internal::CaptureStdout();
  good = check_scene(MPI_COMM_WORLD, file, options);
  return ::testing::internal::GetCapturedStdout();
}

TEST(Check, TellsSizeStepAndCostOnRankZero)
{
  bool good              = false;
  const std::string text = printed(two_plates_file("unused"), {}, good);
  EXPECT_TRUE(good);
  if (rank() != 0)
  {
    EXPECT_EQ(text, "");
    return;
  }
  // 2 plates of 40 x 20 x 6 points, half of which are computed.
  for (const char *part : {"diameter 6 mm", "300 m/s", "plate 1 ", "plate 2 ", "40 x 20 x 6 points",
                           "9600 points", "M bonds, half of them computed",
                           "critical stretch 0.01 (given)", "steps          at most ", " to 30 us"})
    EXPECT_TRUE(contains(text, part)) << part << " in\n" << text;
  EXPECT_EQ(contains(text, "1 rank\n"), n_ranks() == 1) << text;
  EXPECT_FALSE(contains(text, "interface")) << text;
}

TEST(Check, CouplingOfASceneWithoutElementsHasNothingToTest)
{
  bool good = false;
  CheckOptions options;
  options.coupling       = true;
  const std::string text = printed(two_plates_file("unused"), options, good);
  EXPECT_TRUE(good);
  EXPECT_EQ(contains(text, "interface      none"), rank() == 0) << text;
}
} // namespace
} // namespace ricochet
