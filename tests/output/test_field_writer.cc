// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/field_writer.h"

#include "support/scratch_directory.h"

#include <algorithm>
#include <numeric>
#include <regex>
#include <set>

namespace ricochet
{
namespace
{
using namespace tests;

/// Rank r owns n + r points; each coordinate and value tells rank, point and time. Every second one
/// is in the section.
PointFrame points_at(const double time, const int n)
{
  PointFrame frame;
  for (int i = 0; i < n + rank(); ++i)
  {
    frame.position.emplace_back(100. * rank() + i, 1., time);
    frame.displacement.emplace_back(0., 0., time);
    frame.velocity.emplace_back(1., 2., 3.);
    frame.damage.push_back(i / 1000.);
    StressState state;
    state.stress(0, 0)   = 3. * i; // i of pressure in tension, 3 i of von Mises stress
    state.dilatation     = -i / 1000.;
    state.energy_density = 7. * i;
    frame.state.add(state);
    frame.body.push_back(rank() + 1);
    frame.in_section.push_back(i % 2 == 0);
  }
  return frame;
}

SurfaceFrame tetragon_at(const double time)
{
  SurfaceFrame surface;
  surface.vertices = {{0., 0., time}, {1., 0., time}, {1., 1., time}, {0., 1., time}};
  surface.quads    = {{0, 1, 2, 3}, {0, 3, 2, 1}};
  surface.outline  = {{0., 0., time}, {1., 0., time}, {0., 0., time + 1.}};
  return surface;
}

const std::vector<double> times = {0., 1.5e-6, 3e-6};

void write_all(FieldWriter &writer)
{
  for (const double time : times)
    writer.write(time, points_at(time, 5), tetragon_at(time));
}

/// Checks that all elements are closed in their order and returns the text; enough for files
/// without CDATA.
std::string check_xml(const std::filesystem::path &path)
{
  const std::string text = read_text(path);
  std::vector<std::string> open;
  const std::regex tag("<(/?)([A-Za-z]+)((?:[^<>\"]|\"[^\"]*\")*?)(/?)>");
  std::size_t n_tags = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it, ++n_tags)
    if ((*it)[1].length() > 0)
    {
      EXPECT_TRUE(!open.empty() && open.back() == (*it)[2]) << path << ": </" << (*it)[2] << ">";
      if (!open.empty())
        open.pop_back();
    }
    else if ((*it)[4].length() == 0)
      open.push_back((*it)[2]);
  EXPECT_TRUE(open.empty()) << path;
  EXPECT_GT(n_tags, 4u) << path;
  return text;
}

std::vector<std::string> attributes(const std::string &xml, const std::string &element,
                                    const std::string &name)
{
  std::vector<std::string> found;
  const std::regex pattern("<" + element + "\\b[^>]*\\b" + name + "=\"([^\"]*)\"");
  for (std::sregex_iterator it(xml.begin(), xml.end(), pattern), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

TEST(FieldWriter, SectionHoldsThePointsOfAllRanks)
{
  const ScratchDirectory scratch;
  FieldWriter writer(MPI_COMM_WORLD, scratch.path(), /*vtu=*/false);
  write_all(writer);
  EXPECT_EQ(writer.n_frames(), 3u);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "vtu"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "results.pvd"));
  EXPECT_EQ(writer.extent(), FrameExtent::section);
  if (rank() != 0)
    return;

  std::vector<double> x, damage, body, pressure, von_mises, energy_density;
  for (int r = 0; r < n_ranks(); ++r)
    for (int i = 0; i < 5 + r; i += 2)
    {
      x.push_back(100. * r + i);
      damage.push_back(static_cast<float>(i / 1000.));
      body.push_back(r + 1);
      pressure.push_back(-i);
      von_mises.push_back(3. * i);
      energy_density.push_back(7. * i);
    }
  const std::filesystem::path file = scratch.path() / "section.h5";
  for (std::size_t f = 0; f < times.size(); ++f)
  {
    const std::string group = "frame_000" + std::to_string(f);
    EXPECT_EQ(read_attribute(file, group, "time_s"), times[f]);
    const Dataset position = read_dataset(file, group + "/position");
    EXPECT_EQ(position.unit, "m");
    ASSERT_EQ(position.shape, (std::vector<hsize_t>{x.size(), 3}));
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      EXPECT_EQ(position.values[3 * i], x[i]);
      EXPECT_EQ(position.values[3 * i + 1], 1.);
      EXPECT_EQ(position.values[3 * i + 2], static_cast<float>(times[f]));
    }
    EXPECT_EQ(read_dataset(file, group + "/damage").values, damage);
    EXPECT_EQ(read_dataset(file, group + "/body").values, body);
    EXPECT_EQ(read_dataset(file, group + "/pressure").values, pressure);
    EXPECT_EQ(read_dataset(file, group + "/pressure").unit, "Pa");
    EXPECT_EQ(read_dataset(file, group + "/von_mises").values, von_mises);
    EXPECT_EQ(read_dataset(file, group + "/energy_density").values, energy_density);
    EXPECT_EQ(read_dataset(file, group + "/outline").shape, (std::vector<hsize_t>{3, 3}));
  }
}

TEST(FieldWriter, PvdListsAllFramesAndTheirFilesAreWellFormed)
{
  const ScratchDirectory scratch;
  FieldWriter writer(MPI_COMM_WORLD, scratch.path(), /*vtu=*/true);
  EXPECT_EQ(writer.extent(), FrameExtent::everything);
  for (std::size_t f = 0; f < times.size(); ++f)
  {
    writer.write(times[f], points_at(times[f], 5), tetragon_at(times[f]));
    if (rank() == 0) // also in the middle of a run
    {
      EXPECT_EQ(attributes(check_xml(scratch.path() / "results.pvd"), "DataSet", "file").size(),
                2 * (f + 1));
    }
  }
  if (rank() != 0)
    return;

  const std::string pvd                = check_xml(scratch.path() / "results.pvd");
  const std::vector<std::string> steps = attributes(pvd, "DataSet", "timestep");
  const std::vector<std::string> parts = attributes(pvd, "DataSet", "part");
  const std::vector<std::string> files = attributes(pvd, "DataSet", "file");
  ASSERT_EQ(files.size(), 6u);
  EXPECT_EQ(std::set<std::string>(files.begin(), files.end()).size(), 6u);
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(std::stod(steps[i]), times[i / 2]);
    EXPECT_EQ(parts[i], i % 2 ? "1" : "0");
    const std::filesystem::path path = scratch.path() / files[i];
    const std::string xml            = check_xml(path);
    if (i % 2)
    {
      EXPECT_EQ(attributes(xml, "Piece", "NumberOfCells"), std::vector<std::string>{"2"});
      EXPECT_FALSE(std::regex_search(xml, std::regex("format=\"binary\">\\s*</DataArray>")))
          << "empty array";
      continue;
    }
    const std::vector<std::string> pieces = attributes(xml, "Piece", "Source");
    ASSERT_EQ(pieces.size(), static_cast<std::size_t>(n_ranks()));
    for (int r = 0; r < n_ranks(); ++r)
    {
      const std::string piece = check_xml(path.parent_path() / pieces[r]);
      EXPECT_EQ(attributes(piece, "Piece", "NumberOfPoints"),
                std::vector<std::string>{std::to_string(5 + r)});
      EXPECT_EQ(attributes(piece, "Piece", "NumberOfCells"),
                std::vector<std::string>{std::to_string(5 + r)});
      const std::vector<std::string> names = attributes(piece, "DataArray", "Name");
      for (const char *name :
           {"displacement [m]", "velocity [m/s]", "damage", "dilatation", "pressure [Pa]",
            "von Mises stress [Pa]", "strain energy density [J/m3]", "body"})
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
      EXPECT_TRUE(std::regex_search(
          piece, std::regex("Name=\"velocity .m/s.\"[^>]*NumberOfComponents=\"3\"")));
    }
  }
}

TEST(FieldWriter, RankWithoutPointsIsFine)
{
  const ScratchDirectory scratch;
  FieldWriter writer(MPI_COMM_WORLD, scratch.path(), /*vtu=*/true);
  // Only the last rank owns points; with one rank there are none at all.
  PointFrame points = rank() > 0 && rank() == n_ranks() - 1 ? points_at(0., 4) : PointFrame();
  writer.write(0., points, tetragon_at(0.));
  if (rank() != 0)
    return;
  const std::size_t expected = n_ranks() == 1 ? 0 : (4 + n_ranks() - 1 + 1) / 2;
  EXPECT_EQ(read_dataset(scratch.path() / "section.h5", "frame_0000/damage").values.size(),
            expected);
  EXPECT_EQ(
      attributes(check_xml(scratch.path() / "vtu/points_0000.000.vtu"), "Piece", "NumberOfPoints"),
      std::vector<std::string>{"0"});
}

/// All files of a folder with their content, temporary files included.
std::vector<std::pair<std::string, std::string>> snapshot(const std::filesystem::path &folder)
{
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files.emplace_back(entry.path().string(), read_text(entry.path()));
  std::sort(files.begin(), files.end());
  return files;
}

TEST(FieldWriter, FullDiskOnOneRankStopsAllAndKeepsEarlierFrames)
{
  const ScratchDirectory scratch;
  FieldWriter writer(MPI_COMM_WORLD, scratch.path(), /*vtu=*/true);
  write_all(writer);
  MPI_Barrier(MPI_COMM_WORLD);
  const auto before = snapshot(scratch.path());
  MPI_Barrier(MPI_COMM_WORLD);
  {
    // The last rank alone runs out of space, with a frame too large for its limit.
    const bool last = rank() == n_ranks() - 1;
    const FileSizeLimit limit(last ? 2000 : RLIM_INFINITY);
    const std::string message =
        message_of([&] { writer.write(4e-6, points_at(4e-6, 5000), tetragon_at(4e-6)); });
    EXPECT_TRUE(contains(message, "_0003") && contains(message, "too large")) << message;
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const auto after = snapshot(scratch.path());
  for (const auto &file : before)
    if (file.first.find("section.h5") ==
        std::string::npos) // may already list the new frame, if that is complete
    {
      EXPECT_TRUE(std::binary_search(after.begin(), after.end(), file)) << file.first;
    }
  for (const auto &file : after)
    EXPECT_FALSE(contains(file.first, ".tmp")) << file.first;
  if (rank() == 0)
  {
    for (std::size_t f = 0; f < times.size(); ++f)
      EXPECT_EQ(
          read_attribute(scratch.path() / "section.h5", "frame_000" + std::to_string(f), "time_s"),
          times[f]);
  }
  MPI_Barrier(MPI_COMM_WORLD);

  // Once there is space again the same frame can be written.
  writer.write(4e-6, points_at(4e-6, 5000), tetragon_at(4e-6));
  EXPECT_EQ(writer.n_frames(), 4u);
}

TEST(FieldWriter, FolderThatCannotBeMadeIsAnErrorOnAllRanks)
{
  const ScratchDirectory scratch;
  if (rank() == 0)
    std::ofstream(scratch.path() / "section") << "a file where the folder should be";
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string message =
      message_of([&] { FieldWriter writer(MPI_COMM_WORLD, scratch.path(), /*vtu=*/true); });
  EXPECT_TRUE(contains(message, "section") && contains(message, "folder")) << message;
}
} // namespace
} // namespace ricochet
