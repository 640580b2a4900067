// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

/// Reads the matrix that CalculiX writes with *FREQUENCY, SOLVER=MATRIXSTORAGE: the upper triangle as row, column,
/// value (.sti or .mas) and node.component of every row (.dof).
[[nodiscard]] foundation::Expected<NamedMatrix> read_matrix_storage(std::string_view entries, const std::string& source,
                                                                    std::string_view rows,
                                                                    const std::string& rows_source);

}  // namespace trivet::exchange
