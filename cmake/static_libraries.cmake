# SPDX-License-Identifier: BSD-3-Clause
# With TRIVET_PORTABLE, a folder of static libraries (scripts/static-libraries), programs need none of the shared ones
# of this system. HDF5 is left out: compressed, it would be a megabyte of nine. Headers are those of the system's packages,
# whose versions the libraries have.
function(add_static target library)  # ARGN: what it needs itself
  find_library(found NAMES lib${library}.a PATHS ${TRIVET_PORTABLE} NO_DEFAULT_PATH REQUIRED NO_CACHE)
  add_library(${target} STATIC IMPORTED)
  set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${found} INTERFACE_LINK_LIBRARIES "${ARGN}"
    IMPORTED_GLOBAL ON)
endfunction()
add_static(fmt::fmt fmt)
add_static(NLopt::nlopt nlopt m)
add_static(tomlplusplus::tomlplusplus tomlplusplus)
add_static(PkgConfig::MD md)
add_static(ZLIB::ZLIB z)
add_static(PkgConfig::XLSXWRITER xlsxwriter ZLIB::ZLIB)
