// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/table_reader.h"

/// A whole dynamic stiffness matrix over frequency, from the columns k_I_J and k_I_J_loss of a file.
namespace trivet::project {

/// True if a column has the name of a matrix entry.
[[nodiscard]] bool is_matrix_table(const CsvTable& csv);

/// Indices 1 … 6 are those of the moved end K with N held, 1 … 12 those of N, then K; an entry without columns is 0.
/// A symmetric element has only the upper triangle. Each row must be passive, with no negative eigenvalue of the loss
/// matrix; linear interpolation keeps it passive.
void read_matrix_table(TableReader& reader, const CsvTable& csv, const model::Span& span, model::Element& element);

}  // namespace trivet::project
