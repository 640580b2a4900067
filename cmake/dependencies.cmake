# SPDX-License-Identifier: BSD-3-Clause
# Every library comes from the system (Debian 12 package names in scripts/packages).
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(tl-expected REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_package(Boost 1.74 REQUIRED CONFIG)  # headers of Boost.Math, included by source files only
find_package(hwy REQUIRED)
find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)  # headers of counter-based random numbers
if(TRIVET_PORTABLE)
  include(static_libraries)
else()
  find_package(fmt REQUIRED)
  find_package(tomlplusplus REQUIRED)
  find_package(NLopt REQUIRED)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(MD REQUIRED IMPORTED_TARGET libmd)
  find_package(ZLIB REQUIRED)
  # Formats of `trivet export`; without one of these the format says so.
  pkg_check_modules(HDF5 IMPORTED_TARGET hdf5-serial)
  find_library(HDF5_HL_LIBRARY hdf5_serial_hl)
  pkg_check_modules(XLSXWRITER IMPORTED_TARGET xlsxwriter)
endif()

# ccache makes a second build of the same sources nearly free.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endif()
