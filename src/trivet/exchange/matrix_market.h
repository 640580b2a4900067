// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

/// Reads a Matrix Market text: coordinate or array, real, integer or complex, general, symmetric,
/// skew-symmetric or hermitian; exponents of C or Fortran. No labels.
/// [Boisvert, Pozo, Remington, The Matrix Market Exchange Formats, NISTIR 5935, 1996]
[[nodiscard]] foundation::Expected<NamedMatrix> read_matrix_market(std::string_view text, const std::string& source);

}  // namespace trivet::exchange
