// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

/// Reads the bytes of a NumPy `.npy` file, format 1.0, 2.0 or 3.0: a square matrix of float64 or complex128,
/// little-endian, in C or Fortran order. No labels. [NumPy, numpy.lib.format]
[[nodiscard]] foundation::Expected<NamedMatrix> read_numpy_array(std::string_view bytes, const std::string& source);

}  // namespace trivet::exchange
