// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Largest negative eigenvalue of the scaled loss matrix that rounding, or noise of a measurement, explains.
inline constexpr double rounded_loss = 1e-6, noisy_loss = 0.02;

/// Adds the imaginary part of a constant complex stiffness (N, K, end axes) to the law of an element: a loss factor if
/// it is a multiple of the real part, which the law already has; else a stiffness K' + iK'' that is the same at every
/// frequency. Problems are reported at the key `file`.
void set_loss(TableReader& reader, const elements::Matrix12& loss, const model::Span& span, model::Element& element);

// A whole dynamic stiffness matrix over frequency, from the columns k_I_J and k_I_J_loss of a file.

/// True if a column has the name of a matrix entry.
[[nodiscard]] bool is_matrix_table(const CsvTable& csv);

/// Indices 1 … 6 are those of the moved end K with N held, 1 … 12 those of N, then K; an entry without columns is 0.
/// A symmetric element has only the upper triangle. Each row must be passive, with no negative eigenvalue of the loss
/// matrix; linear interpolation keeps it passive.
void read_matrix_table(TableReader& reader, const CsvTable& csv, const model::Span& span, model::Element& element);

}  // namespace trivet::project
