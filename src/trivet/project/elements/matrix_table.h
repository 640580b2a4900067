// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/table_reader.h"

/// A whole dynamic stiffness matrix over frequency, out of the columns k_I_J and k_I_J_loss of a file.
namespace trivet::project {

/// Has it a column that looks like an entry of a matrix?
[[nodiscard]] bool is_matrix_table(const CsvTable& csv);

/// Indices 1 … 6 are those of the moved end K with N held, 1 … 12 those of N, then K; an entry without columns is 0. Of
/// a symmetric element the upper triangle is given. Each row must be passive: the loss matrix has no negative
/// eigenvalue; linear interpolation keeps it so.
void read_matrix_table(TableReader& reader, const CsvTable& csv, const model::Span& span, model::Element& element);

}  // namespace trivet::project
