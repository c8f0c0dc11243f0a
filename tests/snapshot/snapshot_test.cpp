// SPDX-License-Identifier: MIT
#include <mpm/io/snapshot.hpp>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <csignal>
#include "run_python.hpp"
#include "temporary_folder.hpp"

namespace {

using mpm::io::CellType;
using mpm::io::SnapshotSeries;
using mpm::io::UnstructuredGrid;

/// Two quadrilaterals that share an edge, and a vertex, with a scalar, a vector and a tensor; `shift` tells steps
/// apart.
UnstructuredGrid mixed_grid(double shift) {
  UnstructuredGrid grid;
  grid.points = {shift, 0, 0, 1, 0.1, 0, 1.25, 1, 0, -0.5, 1 / 3.0, 0, 2, 0, 0, 2, 1, 0};
  grid.connectivity = {0, 1, 2, 3, 1, 4, 5, 2};
  grid.offsets = {0, 4, 8};
  grid.types = {9, 9};
  grid.add_cell(CellType::vertex, std::vector<std::array<double, 3>>{{-7, 1e-3, 0.5}});
  grid.fields = {{"damage", 1, {0.1F, 0.25F, static_cast<float>(shift)}},
                 {"velocity", 3, {1, -2, 3, 4, 5.5F, -6, 7, 8, 9e6F}},
                 {"stress", 9, std::vector<float>(27, -40e6F)}};
  for (std::size_t i = 0; i < 27; ++i) grid.fields[2].values[i] += static_cast<float>(i) * 1e6F;
  return grid;
}

/// Rows of `width` numbers as JSON lists, to the last bit.
template <class T>
std::string rows(const std::vector<T>& values, std::size_t width) {
  std::string out = "[";
  for (std::size_t i = 0; i < values.size(); ++i)
    out += (i % width ? "," : i ? "],[" : "[") + mpm::io::json_number(static_cast<double>(values[i]));
  return out + "]]";
}

std::string expected(double time, const UnstructuredGrid& grid) {
  std::string out = "{\"time\": " + mpm::io::json_number(time) + ", \"points\": " + rows(grid.points, 3) +
                    ", \"types\": [9, 9, 1], \"cells\": [[0,1,2,3],[1,4,5,2],[6]], \"fields\": {";
  for (const auto& [name, components, values] : grid.fields)
    out += (name == "damage" ? "\"" : ", \"") + name + "\": " + rows(values, static_cast<std::size_t>(components));
  return out + "}}";
}

/// Writes a snapshot under a limit on the size of files, which stands for a full disk; the message of what it throws.
std::string write_on_full_disk(SnapshotSeries& series, const UnstructuredGrid& grid, rlim_t bytes) {
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const auto signal_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::string message;
  try {
    series.write(1, grid);
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, signal_handler);
  return message;
}

TEST(Snapshot, ReadsBackInVtk) {
  const TemporaryFolder folder;
  SnapshotSeries series(folder / "blast");
  std::string steps;
  for (const double time : {0.0, 1e-4 / 3, 2.5e-4}) {
    const auto grid = mixed_grid(time * 1e4);
    series.write(time, grid);
    steps += (steps.empty() ? "[" : ",") + expected(time, grid);
  }
  std::ofstream(folder / "expected.json") << steps << "]";
  const int status = run_python("read_snapshot.py", folder.path());
  if (status == 77) FAIL() << "VTK for Python (python3-vtk9) is not there";
  EXPECT_EQ(status, 0);
  EXPECT_EQ(count_files(folder.path(), ".part"), 0);
}

// ParaView 5.11 merges the steps of a temporal file (2.x) silently and refuses PolyData.
TEST(Snapshot, IsVersion1UnstructuredGridWithoutSteps) {
  const TemporaryFolder folder;
  SnapshotSeries(folder / "s").write(0, mixed_grid(1));
  const hid_t file = H5Fopen((folder / "s_000000.hdf").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  const hid_t version = H5Aopen_by_name(file, "VTKHDF", "Version", H5P_DEFAULT, H5P_DEFAULT);
  int numbers[2] = {-1, -1};
  EXPECT_GE(H5Aread(version, H5T_NATIVE_INT, numbers), 0);
  EXPECT_EQ(numbers[0], 1);
  EXPECT_EQ(numbers[1], 0);
  const hid_t type = H5Aopen_by_name(file, "VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT);
  const hid_t text = H5Aget_type(type);
  EXPECT_EQ(H5Tis_variable_str(text), 0);
  EXPECT_EQ(H5Tget_cset(text), H5T_CSET_ASCII);
  std::string name(H5Tget_size(text), ' ');
  EXPECT_GE(H5Aread(type, text, name.data()), 0);
  EXPECT_EQ(name, "UnstructuredGrid");
  EXPECT_EQ(H5Lexists(file, "VTKHDF/Steps", H5P_DEFAULT), 0);
  for (const hid_t attribute : {version, type}) H5Aclose(attribute);
  H5Tclose(text);
  H5Fclose(file);
}

TEST(Snapshot, FullDiskKeepsEarlierSnapshots) {
  const TemporaryFolder folder;
  SnapshotSeries series(folder / "s");
  series.write(0, mixed_grid(0));
  const std::string list = content(folder / "s.hdf.series");
  auto large = mixed_grid(1);
  for (int i = 0; i < 5000; ++i) large.points.insert(large.points.end(), {0, 0, 0});
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{4096}, rlim_t{100000}}) {
    const std::string message = write_on_full_disk(series, large, bytes);
    EXPECT_NE(message.find("s_000001.hdf"), std::string::npos) << message;
    EXPECT_NE(message.find("fwrite: File too large"), std::string::npos) << message;
  }
  EXPECT_EQ(content(folder / "s.hdf.series"), list);
  EXPECT_EQ(count_files(folder.path(), ".hdf"), 1);
  EXPECT_EQ(count_files(folder.path(), ".part"), 0);
  series.write(1, large);
  EXPECT_NE(content(folder / "s.hdf.series").find("s_000001.hdf"), std::string::npos);
}

TEST(Snapshot, NamesFileAndCallWhenTheFolderIsMissing) {
  const TemporaryFolder folder;
  SnapshotSeries series(folder / "nowhere/s");
  try {
    series.write(0, mixed_grid(0));
    FAIL() << "written into a folder that is not there";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("nowhere/s_000000.hdf"), std::string::npos) << message;
    EXPECT_NE(message.find("fopen: No such file"), std::string::npos) << message;
  }
}

TEST(Snapshot, RefusesAnInconsistentGrid) {
  const TemporaryFolder folder;
  SnapshotSeries series(folder / "s");
  const auto refuses = [&](auto spoil) {
    auto grid = mixed_grid(0);
    spoil(grid);
    EXPECT_THROW(series.write(0, grid), std::invalid_argument);
  };
  refuses([](auto& grid) { grid.points.pop_back(); });
  refuses([](auto& grid) { grid.offsets.pop_back(); });
  refuses([](auto& grid) { grid.offsets[1] = 9; });
  refuses([](auto& grid) { grid.connectivity[3] = 7; });
  refuses([](auto& grid) { grid.connectivity[3] = -1; });
  refuses([](auto& grid) { grid.fields[1].values.pop_back(); });
  refuses([](auto& grid) { grid.fields[2].components = 6; });
  refuses([](auto& grid) { grid.fields[0].name = "a/b"; });
  EXPECT_THROW(series.write(std::nan(""), mixed_grid(0)), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
