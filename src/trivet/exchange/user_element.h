// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/named_matrix.h"
#include "trivet/exchange/text/text_lines.h"

namespace trivet::exchange {

/// Reads a linear user element in Abaqus keywords: *USER ELEMENT, its nodes in a comment, its components, and the
/// *MATRIX of this type (lower case): the lower triangle row by row, or all rows if it is unsymmetric.
[[nodiscard]] foundation::Expected<NamedMatrix> read_user_element(std::string_view text, const std::string& type,
                                                                  FileProblems& problems);

}  // namespace trivet::exchange
