# SPDX-License-Identifier: MIT
# The targets a user links: mpm::mpm (Eigen, and OpenMP where found) and, where HDF5 and Boost are found, mpm::io.
include(GNUInstallDirs)

find_package(Eigen3 3.3 REQUIRED NO_MODULE)
add_library(mpm INTERFACE)
add_library(mpm::mpm ALIAS mpm)
target_compile_features(mpm INTERFACE cxx_std_20)
target_include_directories(mpm INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(mpm INTERFACE Eigen3::Eigen)
# Neither changes a value; without them sqrt and branch-free selections keep the compiler from vectorising.
target_compile_options(
  mpm INTERFACE "$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-fno-math-errno;-fno-trapping-math>")

# In the installed package the user's own compiler decides whether there is OpenMP (mpmConfig.cmake).
if(MPM_OPENMP)
  find_package(OpenMP COMPONENTS CXX)
endif()
if(OpenMP_CXX_FOUND)
  target_link_libraries(mpm INTERFACE $<BUILD_INTERFACE:OpenMP::OpenMP_CXX>)
else()
  message(STATUS "mpm: no OpenMP, steps run on one thread")
endif()

find_package(HDF5 QUIET COMPONENTS C)
find_package(Boost QUIET CONFIG)
if(HDF5_FOUND AND Boost_FOUND)
  add_library(mpm_io INTERFACE)
  add_library(mpm::io ALIAS mpm_io)
  set_target_properties(mpm_io PROPERTIES EXPORT_NAME io)
  target_link_libraries(mpm_io INTERFACE mpm hdf5::hdf5 Boost::headers)
elseif(MPM_BUILD_EXAMPLES OR MPM_BUILD_TESTS)
  message(FATAL_ERROR "mpm: the examples and tests need mpm::io, and that needs HDF5 (C) and Boost")
else()
  message(STATUS "mpm: no mpm::io, it needs HDF5 (C) and Boost")
endif()
