// SPDX-License-Identifier: MIT
#include "snapshot.hpp"
#include <mpm/io/hdf5.hpp>
#include <mpm/io/snapshot.hpp>
#include <cstdio>

namespace paper {
namespace {

using mpm::io::hdf5::check;
using mpm::io::hdf5::Handle;

template <class T>
std::vector<T> dataset(hid_t file, const std::string& name, hid_t type, const std::filesystem::path& path) {
  const Handle set(H5Dopen2(file, ("VTKHDF/" + name).c_str(), H5P_DEFAULT), H5Dclose, "H5Dopen2", path);
  const Handle space(H5Dget_space(set), H5Sclose, "H5Dget_space", path);
  std::vector<T> values(
      static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space), "H5Sget_simple_extent_npoints", path)));
  check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "H5Dread", path);
  return values;
}

}  // namespace

Rock read_rock(const Blast& blast) {
  char name[32];
  std::snprintf(name, sizeof name, "blast_%06d.hdf", blast.scene.output.snapshots);
  const auto path = blast.folder / name;
  const mpm::io::hdf5::QuietErrors quiet;
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "H5Fopen", path);
  const auto points = dataset<double>(file, "Points", H5T_NATIVE_DOUBLE, path);
  const auto corners = dataset<std::int64_t>(file, "Connectivity", H5T_NATIVE_INT64, path);
  const auto offsets = dataset<std::int64_t>(file, "Offsets", H5T_NATIVE_INT64, path);
  const auto types = dataset<std::uint8_t>(file, "Types", H5T_NATIVE_UINT8, path);
  const auto crushed = dataset<float>(file, "CellData/crushed", H5T_NATIVE_FLOAT, path);
  const auto cracked = dataset<float>(file, "CellData/cracked", H5T_NATIVE_FLOAT, path);
  Rock rock;
  for (std::size_t p = 0; p < types.size(); ++p) {
    if (types[p] != static_cast<std::uint8_t>(mpm::io::CellType::quad)) continue;  // gas
    blasting::Quad quad;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto at = static_cast<std::size_t>(3 * corners[static_cast<std::size_t>(offsets[p]) + c]);
      quad[c] = {points[at], points[at + 1]};
    }
    rock.domain.push_back(quad);
    rock.crushed.push_back(double(crushed[p]));
    rock.cracked.push_back(double(cracked[p]));
  }
  return rock;
}

std::vector<float> damage_picture(const Rock& rock, const blasting::Scene& scene, double half_width) {
  std::vector<double> damage(rock.domain.size());
  for (std::size_t p = 0; p < damage.size(); ++p) damage[p] = blasting::signed_damage(rock.crushed[p], rock.cracked[p]);
  return blasting::rasterise(
      {.centre = scene.middle(), .half_width = half_width, .quarter = scene.model == blasting::Model::quarter},
      rock.domain, damage);
}

double area(const blasting::Quad& q) {
  return 0.5 * std::abs((q[2][0] - q[0][0]) * (q[3][1] - q[1][1]) - (q[3][0] - q[1][0]) * (q[2][1] - q[0][1]));
}

blasting::Vec2 centre(const blasting::Quad& q) {
  return {(q[0][0] + q[1][0] + q[2][0] + q[3][0]) / 4, (q[0][1] + q[1][1] + q[2][1] + q[3][1]) / 4};
}

}  // namespace paper
