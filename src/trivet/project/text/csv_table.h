// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::project {

/// Largest table that is read.
inline constexpr std::uintmax_t largest_csv_file = 256u << 20;

/// Most rows of a table for a law over frequency; real ones have a few hundred.
inline constexpr std::size_t most_rows_over_frequency = 20'000;
/// Most rows of measured loads and time histories: a quarter of an hour at 1 kHz.
inline constexpr std::size_t most_rows_over_time = 1'000'000;
/// Most columns of any table: a 12×12 of complex numbers has 289.
inline constexpr std::size_t most_columns = 2'000;

/// A table of numbers with named columns. An empty cell, "nan" or "-" is NaN: not measured.
struct CsvTable {
  std::string source;                ///< file name, for messages
  std::vector<std::string> columns;  ///< names as written, outer blanks and quotes removed
  std::vector<int> lines;            ///< line of each row in the file, from 1
  Eigen::MatrixXd values;            ///< one row per row, one column per name
  std::vector<std::string> names;    ///< of the rows: the column "name" if there is one, else empty; not in `columns`
  foundation::Problems warnings;     ///< how a deviating heading was read
};

/// Table of a text with a header row, then numbers with a decimal point. The separator is the first of tab, semicolon,
/// comma in the header, or blanks if there is none and the rows are numbers between blanks; `#` begins a comment line;
/// a byte order mark, CRLF and quoted cells are accepted. A column "name" holds texts. Separators without a cell after
/// them, at the ends of rows, and rows of empty cells are ignored, as spreadsheets write them. A first column without a
/// name that counts the rows, as data frames write it, is ignored with a warning.
/// @param bare  names of the columns of a table of as many columns that has no header, or one that counts the columns;
///              its first column must increase. Empty: such a table is an error
/// Problems, all at once up to 20 of a kind, with file and line: no header, repeated or empty
/// column names, rows of another length, cells that are not a number, too many columns or rows.
[[nodiscard]] foundation::Expected<CsvTable> csv_table(std::string_view text, const std::string& source,
                                                       std::size_t most_rows = most_rows_over_time,
                                                       const std::vector<std::string>& bare = {});

/// As `csv_table`, from a file; rejects unreadable, empty and binary files and those larger than `largest_csv_file`.
[[nodiscard]] foundation::Expected<CsvTable> read_csv_table(const std::filesystem::path& path,
                                                            std::size_t most_rows = most_rows_over_time,
                                                            const std::vector<std::string>& bare = {});

/// A table of cells as written, outer blanks and quotes removed.
struct TextTable {
  int header_line = 0;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< as long as `columns`
  std::vector<int> lines;                      ///< of each row in the file, from 1
  std::vector<int>
      comments_like_rows;  ///< lines of comments with as many cells as the header: possibly rows named "#1"
};

/// As `read_csv_table`, with cells of any kind.
[[nodiscard]] foundation::Expected<TextTable> read_text_table(const std::filesystem::path& path, std::size_t most_rows);

/// The wanted columns, in that order. Problems name every missing column, the nearest name and the existing columns.
[[nodiscard]] foundation::Expected<Eigen::MatrixXd> columns(const CsvTable& table,
                                                            const std::vector<std::string>& wanted);

}  // namespace trivet::project
