# SPDX-License-Identifier: MIT
# mpm_program: what examples, tests and benchmarks are compiled with, beyond what mpm::mpm asks of every user.
include(CheckCXXCompilerFlag)
set(MPM_WARNINGS -Wall -Wextra -Wpedantic -Wshadow)

add_library(mpm_program INTERFACE)
target_link_libraries(mpm_program INTERFACE mpm)
target_compile_options(mpm_program INTERFACE ${MPM_WARNINGS} $<$<BOOL:${MPM_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms on `"text" + std::string` (GCC bug 105329) and in its own AVX-512 intrinsics (105593).
  target_compile_options(mpm_program INTERFACE -Wno-restrict -Wno-uninitialized -Wno-maybe-uninitialized)
endif()
if(NOT OpenMP_CXX_FOUND)
  target_compile_options(mpm_program INTERFACE -Wno-unknown-pragmas)
endif()
if(MPM_NATIVE)
  check_cxx_compiler_flag(-march=native MPM_HAS_MARCH_NATIVE)
  target_compile_options(mpm_program INTERFACE $<$<BOOL:${MPM_HAS_MARCH_NATIVE}>:-march=native>)
endif()
