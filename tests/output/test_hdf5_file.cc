// SPDX-License-Identifier: LGPL-2.1-or-later
#include "output/hdf5_file.h"

#include "support/scratch_directory.h"

#include <cmath>

namespace ricochet
{
namespace
{
using namespace tests;

TEST(Hdf5File, KeepsNumbersShapesAndUnits)
{
  const ScratchDirectory scratch;
  const auto path = scratch.path() / "file.h5";
  Hdf5File file;
  const std::vector<double> numbers{1., -2.5, 1e-300, 3., std::nextafter(1., 2.), 6.};
  file.add("table", numbers, 3, "m/s");
  file.add("count", std::vector<int>{7, -8}, 1, "-");
  file.add("empty", std::vector<float>(), 3, "");
  file.set_attribute("time_s", 0.1);
  file.save(path);

  const Dataset table = read_dataset(path, "table");
  EXPECT_EQ(table.shape, (std::vector<hsize_t>{2, 3}));
  EXPECT_EQ(table.values, numbers);
  EXPECT_EQ(table.unit, "m/s");
  const Dataset count = read_dataset(path, "count");
  EXPECT_EQ(count.shape, std::vector<hsize_t>{2});
  EXPECT_EQ(count.values, (std::vector<double>{7., -8.}));
  EXPECT_EQ(read_dataset(path, "empty").shape, (std::vector<hsize_t>{0, 3}));
  EXPECT_EQ(read_attribute(path, "/", "time_s"), 0.1);
}

TEST(Hdf5File, CompressesWhatIsLargeWithoutLoss)
{
  const ScratchDirectory scratch;
  std::vector<double> numbers(200000);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = std::sin(static_cast<double>(i / 100));
  Hdf5File file;
  file.add("wave", numbers, 2, "-");
  file.save(scratch.path() / "file.h5");
  EXPECT_EQ(read_dataset(scratch.path() / "file.h5", "wave").values, numbers);
  EXPECT_LT(std::filesystem::file_size(scratch.path() / "file.h5"),
            numbers.size() * sizeof(double) / 4);
}

TEST(Hdf5File, LinksFollowTheFolderWhenItMoves)
{
  const ScratchDirectory scratch;
  const auto before = scratch.path() / "before", after = scratch.path() / "after";
  std::filesystem::create_directory(before);
  Hdf5File part, index;
  part.add("values", std::vector<int>{42}, 1, "-");
  part.save(before / "part.h5");
  index.link("first", "part.h5");
  index.save(before / "index.h5");
  std::filesystem::rename(before, after);
  EXPECT_EQ(read_dataset(after / "index.h5", "first/values").values, std::vector<double>{42.});
}

/// Counts HDF5's reports instead of printing them.
herr_t count_report(hid_t, void *const counter)
{
  ++*static_cast<int *>(counter);
  return 0;
}

TEST(Hdf5File, FailureIsAnExceptionAndNotHdf5sOwnReport)
{
  H5E_auto2_t usual_report = nullptr;
  void *usual_data         = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &usual_report, &usual_data);
  int n_reports = 0;
  H5Eset_auto2(H5E_DEFAULT, count_report, &n_reports);

  Hdf5File file;
  const std::vector<double> numbers{1.};
  file.add("twice", numbers, 1, "-");
  file.set_attribute("time_s", 0.);
  EXPECT_TRUE(contains(message_of([&] { file.add("twice", numbers, 1, "-"); }), "twice"));
  EXPECT_TRUE(contains(message_of([&] { file.set_attribute("time_s", 0.); }), "time_s"));
  EXPECT_TRUE(contains(message_of([&] { file.link("twice", "other.h5"); }), "twice"));
  EXPECT_EQ(n_reports, 0);

  // What others do with HDF5 is reported as before.
  EXPECT_LT(H5Fopen("/there/is/no/such/file.h5", H5F_ACC_RDONLY, H5P_DEFAULT), 0);
  EXPECT_EQ(n_reports, 1);
  H5Eset_auto2(H5E_DEFAULT, usual_report, usual_data);
}
} // namespace
} // namespace ricochet
