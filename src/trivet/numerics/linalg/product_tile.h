// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace trivet::numerics {

/// Rows and columns of the part of a product that the registers hold.
struct TileSize {
  std::ptrdiff_t rows, columns;
};

}  // namespace trivet::numerics
