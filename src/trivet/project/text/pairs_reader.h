// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/table_reader.h"

/// Two columns of numbers, in the project file or in a file that it names.
namespace trivet::project {

/// `key = [[x, y], …]`, at least two rows, numbers of these quantities; n × 2.
[[nodiscard]] std::optional<Eigen::MatrixXd> read_pairs(TableReader& reader, const std::string& key,
                                                        Quantity x = Quantity::pure, Quantity y = Quantity::pure);

/// `file = "….csv"` with the columns `x` and `y`; other names by the keys `x` and `y` of the table. A cell that was not
/// measured is a problem. n × 2.
[[nodiscard]] std::optional<Eigen::MatrixXd> read_pairs_of_file(TableReader& reader, const std::string& x,
                                                                const std::string& y,
                                                                std::size_t most_rows = most_rows_over_frequency);

}  // namespace trivet::project
