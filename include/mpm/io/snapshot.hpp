// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/io/hdf5.hpp>
#include <mpm/io/text.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Snapshots for ParaView and VTK: VTKHDF 1.0, one unstructured grid a file, with ParaView's list of files and times
// beside them. Later versions of the format keep many steps in one file and know more kinds of grids, but ParaView 5.11
// merges those steps silently and refuses those grids.
namespace mpm::io {

/// Kinds of cells, by VTK's numbers.
enum class CellType : std::uint8_t { vertex = 1, quad = 9 };

/// Values of one name on the cells: 1 (scalar), 3 (vector) or 9 (tensor, row-major) numbers a cell, cell after cell.
struct CellField {
  std::string name{};
  int components = 1;
  std::vector<float> values{};
};

/// Particles as cells: a domain with corners is its polygon, a particle without is a vertex. Corners may be shared.
struct UnstructuredGrid {
  std::vector<double> points{};              ///< x y z a point, m
  std::vector<std::int64_t> connectivity{};  ///< the points of cell after cell
  std::vector<std::int64_t> offsets{0};      ///< where in `connectivity` each cell begins, and the end: one more
  std::vector<std::uint8_t> types{};         ///< CellType a cell
  std::vector<CellField> fields{};

  /// Appends a cell with points of its own, in VTK's order (a quad: around).
  void add_cell(CellType type, std::span<const std::array<double, 3>> corners) {
    for (const auto& corner : corners) {
      connectivity.push_back(static_cast<std::int64_t>(points.size() / 3));
      points.insert(points.end(), corner.begin(), corner.end());
    }
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(static_cast<std::uint8_t>(type));
  }
};

/// Throws std::invalid_argument that names what does not fit if the arrays of a grid disagree with each other.
inline void validate(const UnstructuredGrid& grid) {
  const auto require = [](bool fits, const std::string& what) {
    if (!fits) throw std::invalid_argument("snapshot: " + what);
  };
  const std::size_t cells = grid.types.size();
  const auto points = static_cast<std::int64_t>(grid.points.size() / 3);
  require(grid.points.size() % 3 == 0, "points hold three coordinates each");
  require(grid.offsets.size() == cells + 1, "offsets are one more than the cells");
  require(grid.offsets.front() == 0 && std::ranges::is_sorted(grid.offsets) &&
              grid.offsets.back() == static_cast<std::int64_t>(grid.connectivity.size()),
          "offsets rise from 0 to the length of the connectivity");
  require(std::ranges::all_of(grid.connectivity, [&](auto point) { return 0 <= point && point < points; }),
          "connectivity names a point that is not there");
  for (const auto& [name, components, values] : grid.fields) {
    require(!name.empty() && name.find('/') == std::string::npos, "field name `" + name + "` is empty or has a slash");
    require(components == 1 || components == 3 || components == 9, "field `" + name + "` is no scalar, vector, tensor");
    require(values.size() == cells * static_cast<std::size_t>(components),
            "field `" + name + "` has " + std::to_string(values.size()) + " values for " + std::to_string(cells) +
                " cells of " + std::to_string(components) + " components");
  }
}

namespace detail {

/// One VTKHDF file in the making. It grows in memory: a disk that fills up under an open file makes the HDF5 library
/// (1.10) keep that file and crash at the program's end.
class VtkHdfFile {
 public:
  explicit VtkHdfFile(std::filesystem::path path)
      : path_(std::move(path)),
        access_(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "H5Pcreate", path_),
        file_(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, in_memory(access_)), H5Fclose, "H5Fcreate", path_),
        root_(group(file_, "VTKHDF")) {}

  void write(const UnstructuredGrid& grid) {
    write_header();
    const std::int64_t points = static_cast<std::int64_t>(grid.points.size() / 3);
    const std::int64_t cells = static_cast<std::int64_t>(grid.types.size());
    const std::int64_t ids = static_cast<std::int64_t>(grid.connectivity.size());
    dataset(root_, "NumberOfPoints", H5T_NATIVE_INT64, &points, 1);
    dataset(root_, "NumberOfCells", H5T_NATIVE_INT64, &cells, 1);
    dataset(root_, "NumberOfConnectivityIds", H5T_NATIVE_INT64, &ids, 1);
    dataset(root_, "Points", H5T_NATIVE_DOUBLE, grid.points.data(), grid.points.size() / 3, 3);
    dataset(root_, "Connectivity", H5T_NATIVE_INT64, grid.connectivity.data(), grid.connectivity.size());
    dataset(root_, "Offsets", H5T_NATIVE_INT64, grid.offsets.data(), grid.offsets.size());
    dataset(root_, "Types", H5T_NATIVE_UINT8, grid.types.data(), grid.types.size());
    group(root_, "PointData");
    const hdf5::Handle cell_data = group(root_, "CellData");
    for (const auto& [name, components, values] : grid.fields)
      dataset(cell_data, name.c_str(), H5T_NATIVE_FLOAT, values.data(), grid.types.size(), components);
  }

  /// The bytes of the whole file.
  std::string image() {
    hdf5::check(H5Fflush(file_, H5F_SCOPE_LOCAL), "H5Fflush", path_);
    std::string bytes(
        static_cast<std::size_t>(hdf5::check(H5Fget_file_image(file_, nullptr, 0), "H5Fget_file_image", path_)), '\0');
    hdf5::check(H5Fget_file_image(file_, bytes.data(), bytes.size()), "H5Fget_file_image", path_);
    return bytes;
  }

 private:
  hid_t in_memory(hid_t access) const {
    const std::size_t growth = 1 << 20;
    hdf5::check(H5Pset_fapl_core(access, growth, false), "H5Pset_fapl_core", path_);
    return access;
  }

  void write_header() {
    const std::int64_t version[2] = {1, 0};
    const hsize_t two = 2;
    attribute("Version", H5T_NATIVE_INT64, {H5Screate_simple(1, &two, nullptr), H5Sclose, "H5Screate_simple", path_},
              version);
    const std::string type = "UnstructuredGrid";
    const hdf5::Handle text(H5Tcopy(H5T_C_S1), H5Tclose, "H5Tcopy", path_);
    hdf5::check(H5Tset_size(text, type.size()), "H5Tset_size", path_);
    hdf5::check(H5Tset_strpad(text, H5T_STR_NULLPAD), "H5Tset_strpad", path_);
    attribute("Type", text, {H5Screate(H5S_SCALAR), H5Sclose, "H5Screate", path_}, type.data());
  }

  void attribute(const char* name, hid_t type, const hdf5::Handle& space, const void* value) {
    const hdf5::Handle handle(H5Acreate2(root_, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "H5Acreate2",
                              path_);
    hdf5::check(H5Awrite(handle, type, value), "H5Awrite", path_);
  }

  hdf5::Handle group(hid_t parent, const char* name) {
    return {H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "H5Gcreate2", path_};
  }

  /// `rows` rows of `columns` numbers; a single column has one dimension only, as VTK wants scalars.
  void dataset(hid_t parent, const char* name, hid_t type, const void* values, std::size_t rows, int columns = 1) {
    const hsize_t size[2] = {rows, static_cast<hsize_t>(columns)};
    const hdf5::Handle space(H5Screate_simple(columns == 1 ? 1 : 2, size, nullptr), H5Sclose, "H5Screate_simple",
                             path_);
    const hdf5::Handle handle(H5Dcreate2(parent, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                              "H5Dcreate2", path_);
    if (rows) hdf5::check(H5Dwrite(handle, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "H5Dwrite", path_);
  }

  std::filesystem::path path_;
  hdf5::Handle access_;
  hdf5::Handle file_;
  hdf5::Handle root_;
};

}  // namespace detail

/// Snapshots of one run: `<stem>_000000.hdf`, `<stem>_000001.hdf`, ... and `<stem>.hdf.series`, which ParaView opens as
/// one animation with the right times. Each file appears whole or not at all, and the list names only whole ones: a run
/// that fails keeps its earlier snapshots.
class SnapshotSeries {
 public:
  /// `stem` is folder and beginning of the file names; the folder is there already. Writes nothing yet.
  explicit SnapshotSeries(std::filesystem::path stem) : stem_(std::move(stem)) {}

  /// Writes the next snapshot, at `time` in s. Throws std::runtime_error naming the file and the call that failed, and
  /// std::invalid_argument if the time is not finite or the grid is inconsistent.
  void write(double time, const UnstructuredGrid& grid) {
    if (!std::isfinite(time)) throw std::invalid_argument("snapshot: the time is not a number");
    validate(grid);
    char number_and_end[32];
    std::snprintf(number_and_end, sizeof number_and_end, "_%06d.hdf", count_);
    const auto file = with_suffix(number_and_end);
    const hdf5::QuietErrors quiet;
    detail::VtkHdfFile out(file);
    out.write(grid);
    replace_file(file, out.image());
    const std::string entry =
        "    {\"name\": " + json_string(file.filename().string()) + ", \"time\": " + number(time) + "}";
    entries_ += (count_++ ? ",\n" : "") + entry;
    replace_file(with_suffix(".hdf.series"),
                 "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n" + entries_ + "\n  ]\n}\n");
  }

 private:
  std::filesystem::path with_suffix(const char* suffix) const {
    auto path = stem_;
    return path += suffix;
  }

  std::filesystem::path stem_;
  int count_ = 0;
  std::string entries_;
};

}  // namespace mpm::io
