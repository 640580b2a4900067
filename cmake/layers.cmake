# SPDX-License-Identifier: BSD-3-Clause
# add_layer(NAME [WORDS|FAST] [OPTIMIZED Release|Debug] [USES LOWER...]): folder src/trivet/NAME = static library
# trivet::NAME = namespace trivet::NAME. All .cpp files of the folder are its sources. All headers are public and
# installed, except kernels (-inl.h) and those that its CMakeLists.txt lists as private. The permitted includes
# between layers and between the folders of a layer, and the private headers, are written to layers.txt for the test
# that checks all #include lines against them.
file(WRITE ${PROJECT_BINARY_DIR}/layers.txt "")
set_property(GLOBAL PROPERTY TRIVET_LAYERS "")

set(TRIVET_BATCH_SIZE 16)  # files; the largest batch takes 2.2 GB of memory
set(TRIVET_WARNINGS -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual
  -Wno-missing-field-initializers  # named initialisers leave the other fields at their defaults
  # In a batch, a constant of one file is global to the next; so only the build without batches checks for shadowed
  # ones.
  $<IF:$<BOOL:${TRIVET_BATCHES}>,$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>,-Wshadow>
  # Lossy conversions between numbers. Indices of Eigen are signed and sizes of the standard library are not.
  $<$<CXX_COMPILER_ID:Clang>:-Wconversion;-Wno-sign-conversion>
  # False alarms of GCC 12 inside the standard library; the pack of eight doubles is used within one file only.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-free-nonheap-object;-Wno-psabi>)

# One precompiled header for all layers, except those that are OPTIMIZED (-O3) in this type of build, because it
# stores the optimisation options. Layers of WORDS (reading, writing) are not optimised in debug builds, which have
# sanitizers, and for size in portable ones, like all that are neither OPTIMIZED nor FAST; there they have another header.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "// Compiles cmake/precompiled.h.\n")
function(add_precompiled name)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_options(${name} PRIVATE ${TRIVET_WARNINGS} ${ARGN})
  target_link_libraries(${name} PRIVATE Eigen3::Eigen fmt::fmt tl::expected)
  target_precompile_headers(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
endfunction()
add_precompiled(trivet_precompiled)
set(TRIVET_WORDS_OPTION "")
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(TRIVET_WORDS_OPTION -O0)
elseif(TRIVET_PORTABLE)  # a third smaller
  set(TRIVET_WORDS_OPTION -Os)
endif()
if(TRIVET_WORDS_OPTION)
  add_precompiled(trivet_precompiled_words ${TRIVET_WORDS_OPTION})
endif()

# The precompiled header and the options of a target that only reads and writes.
function(compile_words target)
  if(TARGET trivet_precompiled_words)
    target_compile_options(${target} PRIVATE ${TRIVET_WORDS_OPTION})
    target_precompile_headers(${target} REUSE_FROM trivet_precompiled_words)
  else()
    target_precompile_headers(${target} REUSE_FROM trivet_precompiled)
  endif()
endfunction()

function(add_layer name)
  cmake_parse_arguments(LAYER "WORDS;FAST" "OPTIMIZED" "USES" ${ARGN})
  add_library(trivet_${name} STATIC)
  add_library(trivet::${name} ALIAS trivet_${name})
  set_target_properties(trivet_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    UNITY_BUILD ${TRIVET_BATCHES} UNITY_BUILD_BATCH_SIZE ${TRIVET_BATCH_SIZE})
  target_compile_features(trivet_${name} PUBLIC cxx_std_20)
  target_compile_options(trivet_${name} PRIVATE ${TRIVET_WARNINGS})
  if(LAYER_OPTIMIZED STREQUAL CMAKE_BUILD_TYPE AND NOT TRIVET_PORTABLE)
    target_compile_options(trivet_${name} PRIVATE -O3)
    target_precompile_headers(trivet_${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  elseif(LAYER_WORDS OR (TRIVET_PORTABLE AND NOT LAYER_OPTIMIZED STREQUAL CMAKE_BUILD_TYPE AND NOT LAYER_FAST))
    compile_words(trivet_${name})
  else()
    target_precompile_headers(trivet_${name} REUSE_FROM trivet_precompiled)
  endif()
  target_link_libraries(trivet_${name} PRIVATE fmt::fmt)
  list(TRANSFORM LAYER_USES PREPEND trivet_ OUTPUT_VARIABLE lower)
  target_link_libraries(trivet_${name} PUBLIC ${lower})
  string(REPLACE ";" " " uses "${LAYER_USES}")
  file(APPEND ${PROJECT_BINARY_DIR}/layers.txt "${name}: ${uses}\n")
  set_property(GLOBAL APPEND PROPERTY TRIVET_LAYERS ${name})
  add_subdirectory(src/trivet/${name})
endfunction()

# layer_files(NAME [PRIVATE_HEADERS ...])
function(layer_files name)
  cmake_parse_arguments(FILES "" "" "PRIVATE_HEADERS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS *.h)
  list(FILTER headers EXCLUDE REGEX "-inl\\.h$")
  list(TRANSFORM FILES_PRIVATE_HEADERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE private)
  foreach(header IN LISTS private)
    if(NOT EXISTS ${header})
      message(FATAL_ERROR "${header} is named private and does not exist")
    endif()
  endforeach()
  list(REMOVE_ITEM headers ${private} "")
  target_sources(trivet_${name} PRIVATE ${sources})
  target_sources(trivet_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${headers})
  string(REPLACE ";" " " listed "${FILES_PRIVATE_HEADERS}")
  file(APPEND ${PROJECT_BINARY_DIR}/layers.txt "private ${name}: ${listed}\n")
endfunction()

# add_folder(LAYER/FOLDER [USES FOLDER...]): a sub-folder of a layer. It may include itself and the folders listed
# here. Files of the layer outside its folders may include all of them; no folder may include these files.
function(add_folder name)
  cmake_parse_arguments(FOLDER "" "" "USES" ${ARGN})
  string(REPLACE ";" " " uses "${FOLDER_USES}")
  file(APPEND ${PROJECT_BINARY_DIR}/layers.txt "folder ${name}: ${uses}\n")
endfunction()
