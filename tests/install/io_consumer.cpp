// SPDX-License-Identifier: MIT
#include <mpm/io/hdf5.hpp>
#include <mpm/io/info_file.hpp>
#include <cstdio>

int main() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  std::printf("linked HDF5 is the compiled one: %d\n", major == H5_VERS_MAJOR && minor == H5_VERS_MINOR);
}
