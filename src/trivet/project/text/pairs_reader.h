// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "trivet/project/text/column_units.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/table_reader.h"

/// Two columns of numbers, in the project file or in a file that it names.
namespace trivet::project {

/// `key = [[x, y], …]`, at least two rows, numbers of these quantities, or texts with units: in one column all or none,
/// except for 0. n × 2, in the units of the bare numbers.
[[nodiscard]] std::optional<Eigen::MatrixXd> read_pairs(TableReader& reader, const std::string& key,
                                                        const ColumnQuantity& x, const ColumnQuantity& y);

/// `file = "….csv"` with the columns `x` and `y`; other names by the keys `x` and `y` of the table. A heading may have
/// a unit: "force [kN]". A cell that was not measured is a problem. n × 2, in the units of the bare numbers.
[[nodiscard]] std::optional<Eigen::MatrixXd> read_pairs_of_file(TableReader& reader, const std::string& x,
                                                                const std::string& y, const ColumnQuantity& x_quantity,
                                                                const ColumnQuantity& y_quantity,
                                                                std::size_t most_rows = most_rows_over_frequency);

/// `unit = "mm/s"`: what a number without a unit of this column means; "SI" is the SI unit.
[[nodiscard]] ColumnQuantity read_bare_unit(TableReader& reader, ColumnQuantity column);

}  // namespace trivet::project
