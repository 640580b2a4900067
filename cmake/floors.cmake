# SPDX-License-Identifier: BSD-3-Clause
# add_floor(NAME [USES LOWER...]): folder src/trivet/NAME = static library trivet::NAME = namespace trivet::NAME.
# The floor's CMakeLists.txt lists its sources and its public headers. The arrows are written to floors.txt for the test
# that holds all #include lines to them.
file(WRITE ${PROJECT_BINARY_DIR}/floors.txt "")
set_property(GLOBAL PROPERTY TRIVET_FLOORS "")

function(add_floor name)
  cmake_parse_arguments(FLOOR "" "" "USES" ${ARGN})
  add_library(trivet_${name} STATIC)
  add_library(trivet::${name} ALIAS trivet_${name})
  set_target_properties(trivet_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(trivet_${name} PUBLIC cxx_std_20)
  target_compile_options(trivet_${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual
    # False alarm of GCC 12 inside the standard library; the pack of eight doubles is used within one file only.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-psabi>)
  list(TRANSFORM FLOOR_USES PREPEND trivet_ OUTPUT_VARIABLE lower)
  target_link_libraries(trivet_${name} PUBLIC ${lower})
  string(REPLACE ";" " " uses "${FLOOR_USES}")
  file(APPEND ${PROJECT_BINARY_DIR}/floors.txt "${name}: ${uses}\n")
  set_property(GLOBAL APPEND PROPERTY TRIVET_FLOORS ${name})
  add_subdirectory(src/trivet/${name})
endfunction()

# floor_files(NAME SOURCES ... PUBLIC_HEADERS ...)
function(floor_files name)
  cmake_parse_arguments(FILES "" "" "SOURCES;PUBLIC_HEADERS" ${ARGN})
  target_sources(trivet_${name} PRIVATE ${FILES_SOURCES})
  target_sources(trivet_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${FILES_PUBLIC_HEADERS})
endfunction()
