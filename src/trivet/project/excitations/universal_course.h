// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "trivet/project/text/column_units.h"
#include "trivet/project/text/table_reader.h"

/// Functions of universal files (set 58) as courses of excitations.
namespace trivet::project {

/// True if `file` of the table is a universal file.
[[nodiscard]] bool names_universal_file(TableReader& reader);

/// `file = "….uff"` with a time response (type 1, or 0 over time): times [s] and values in the unit of the bare
/// numbers of `value`, n × 2. `value = "3:+z"`, or an id line, names one of several. The quantity of the file must be
/// that of `value`; its unit is stated by set 164, the labels or `unit`, which must agree.
[[nodiscard]] std::optional<Eigen::MatrixXd> read_time_response(TableReader& reader, const ColumnQuantity& value);

/// The same of a power spectral density (type 9, or 2 with a label per hertz), one-sided: frequencies [Hz] above 0 and
/// densities in the unit of the bare numbers of `density`; `psd` names one of several.
[[nodiscard]] std::optional<Eigen::MatrixXd> read_power_spectral_density(TableReader& reader,
                                                                         const ColumnQuantity& density);

}  // namespace trivet::project
