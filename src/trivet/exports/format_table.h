// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/exports/format.h"

/// The formats in the order of the help. A row NAME is NAME_format in NAME_export.cpp.
// clang-format off
#define TRIVET_FORMATS(row) \
  row(matlab) \
  row(universal) \
  row(universal_binary) \
  row(nastran) \
  row(numpy) \
  row(hdf5) \
  row(excel) \
  row(fmu) \
  row(fmu3) \
  row(matrix_market) \
  row(csv)
// clang-format on

namespace trivet::exports {

#define TRIVET_FORMAT(name) extern const Format name##_format;
TRIVET_FORMATS(TRIVET_FORMAT)
#undef TRIVET_FORMAT

}  // namespace trivet::exports
