// SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to the summary: what a run says about stated times, plates and friction.
#include "commands/run.h"

#include "ricochet/base/version.h"
#include "support/scratch_directory.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace ricochet
{
namespace
{
using namespace tests;

const char *const scene = R"(
subsection Projectile
  set Nose shape = sphere
  set Diameter   = 6 mm
  set Density    = 7850 kg/m3
end
subsection Impact
  set Speed           = 300 m/s
  set Incidence angle = 30 deg
  set Entry point     = 10 mm, 0 mm
end
subsection Plate 1
  set Size         = 40 mm, 20 mm, 6 mm
  set Grid spacing = 1 mm
  set Material     = PMMA
end
subsection Plate 2
  set Size         = 40 mm, 20 mm, 6 mm
  set Grid spacing = 1 mm
  set Material     = PMMA
end
subsection Material PMMA
  set Density          = 1190 kg/m3
  set Bulk modulus     = 5.9 GPa
  set Shear modulus    = 2.258 GPa
  set Critical stretch = 0.01
end
subsection Contact
  set Friction law           = constant
  set Static friction        = 0.3
  set Debris friction factor = 0.5
end
subsection Time
  set Final time = 30 us
end
subsection Output
  set Frame interval = 0 us
  set ParaView files = false
  set Pictures       = false
  set Picture times  = 0 us, 12.3 us, 20 us, 40 us
end
)";

TEST(Run, SummaryTellsPositionsAtStatedTimesAndDamagePerPlate)
{
  const ScratchDirectory scratch;
  const auto folder = scratch.path() / "results";
  RunOptions options;
  options.quiet    = true;
  const auto file  = ParameterFile::from_text(scene, "scene.prm",
                                              {{"Output", "Directory", folder.string(), "test"}});
  const auto s     = run(MPI_COMM_WORLD, file, options);
  const double dt  = s["time_step_us"];
  const auto &list = s["positions"];
  ASSERT_EQ(list.size(), 3u); // the fourth time lies behind the end
  const double stated[] = {0., 12.3, 20.};
  for (int i = 0; i < 3; ++i)
  {
    const auto &position = list[i];
    const double time    = position["time_us"];
    EXPECT_DOUBLE_EQ(position["stated_us"], stated[i]);
    EXPECT_GE(time, stated[i]); // the first step that is not before
    EXPECT_LT(time, stated[i] + dt);
    if (rank() == 0)
    {
      const std::string frame = "frame_000" + std::to_string(i);
      EXPECT_NEAR(read_attribute(folder / "section.h5", frame, "time_s"), 1e-6 * time, 1e-18);
    }
  }
  EXPECT_EQ(list[0]["path_mm"], 0.);
  EXPECT_DOUBLE_EQ(list[0]["speed_m_s"], 300.);
  EXPECT_NEAR(list[0]["angle_deg"], -30., 1e-9);
  // It only loses speed on the way.
  const double path = list[2]["path_mm"];
  EXPECT_GT(path, 0.5 * 0.3 * 20.);
  EXPECT_LT(path, 0.3 * 20.4);

  const double first = s["plate_1_broken_share"], second = s["plate_2_broken_share"];
  EXPECT_GT(first, second);
  EXPECT_GT(first, 0.005);
  EXPECT_GE(second, 0.);
  EXPECT_GT(s["plate_1_front_damaged_mm2"], 10.);
  EXPECT_GT(s["contact_duration_us"], 5.);
  if (rank() == 0)
  {
    EXPECT_EQ(read_dataset(folder / "damage.h5", "plate_2_rear").shape,
              (std::vector<hsize_t>{40, 10}));
    // Debris rubs.
    const auto lines = split(read_text(folder / "history.csv"), '\n');
    const auto names = split(lines.front(), ','), last = split(lines.back(), ',');
    for (std::size_t i = 0; i < names.size(); ++i)
      if (contains(names[i], "work debris friction"))
      {
        EXPECT_GT(std::stod(last.at(i)), 0.);
        return;
      }
    FAIL() << "no column of the work of debris friction";
  }
}

TEST(Run, EveryResultFileNamesTheVersion)
{
  const ScratchDirectory scratch;
  const auto folder = scratch.path() / "results";
  RunOptions options;
  options.quiet   = true;
  const auto file = ParameterFile::from_text(scene, "scene.prm",
                                             {{"Output", "Directory", folder.string(), "test"},
                                              {"Output", "ParaView files", "true", "test"},
                                              {"Time", "Final time", "2 us", "test"}});
  const auto s    = run(MPI_COMM_WORLD, file, options);
  EXPECT_EQ(s["version"], version());
  if (rank() != 0)
    return;
  // A table has no place for it and parameters are not results; summary.json lies next to both.
  std::map<std::string, int> files;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
  {
    const std::string kind = entry.path().extension();
    if (!entry.is_regular_file() || kind == ".csv" || kind == ".prm")
      continue;
    EXPECT_TRUE(contains(read_text(entry.path()), version())) << entry.path();
    ++files[kind];
  }
  for (const char *kind : {".json", ".h5", ".vtu", ".pvtu", ".pvd"})
    EXPECT_GT(files[kind], 0) << kind;
}
} // namespace
} // namespace ricochet
