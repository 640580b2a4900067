// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

/// Reads a matrix of Nastran DMIG cards from bulk data or a punch file: small, large and free field; real and complex,
/// also polar; square (IFO 1) and symmetric (6). Rows are sorted by grid point and component; a scalar point has
/// component 0.
/// @param name  of the matrix, "KAAX" for instance; may be empty if the file has only one
/// [MSC Nastran Quick Reference Guide, DMIG]
[[nodiscard]] foundation::Expected<NamedMatrix> read_nastran_dmig(std::string_view text, const std::string& source,
                                                                  const std::string& name = "");

}  // namespace trivet::exchange
