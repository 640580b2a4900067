// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/exchange/universal/universal_reading.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/column_units.h"

namespace trivet::project {
namespace {

constexpr std::string_view table_rule = "a table has a header row and rows of the same length";
constexpr std::string_view name_column = "name";
/// Most listed problems of one kind; a file with the wrong separator would fill the screen.
constexpr int most_listed = 20;
/// Most numbers of one table: 160 MB.
constexpr std::size_t most_cells = 20'000'000;

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view{}
                                         : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

constexpr char blanks = ' ';  ///< separator: runs of blanks

/// The words of a line.
std::vector<std::string> words(std::string_view line) {
  std::vector<std::string> result;
  for (std::size_t at = line.find_first_not_of(" \t\r"); at < line.size(); at = line.find_first_not_of(" \t\r", at)) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    result.emplace_back(line.substr(at, end - at));
    at = end;
  }
  return result;
}

/// Cells of a line; a cell in quotes may contain the separator, and "" is one quote. None if a quote is not closed.
std::optional<std::vector<std::string>> cells(std::string_view line, char separator) {
  if (separator == blanks) return words(line);
  std::vector<std::string> result;
  for (std::size_t at = 0; at <= line.size();) {
    while (at < line.size() && line[at] == ' ') ++at;
    std::string cell;
    if (at < line.size() && line[at] == '"') {
      for (++at; at < line.size() && (line[at] != '"' || (at + 1 < line.size() && line[at + 1] == '"')); ++at) {
        cell += line[at];
        if (line[at] == '"') ++at;
      }
      if (at == line.size()) return std::nullopt;
      ++at;
    }
    const std::size_t end = std::min(line.find(separator, at), line.size());
    cell += without_blanks(line.substr(at, end - at));
    result.push_back(std::move(cell));
    at = end + 1;
  }
  return result;
}

/// Number of a cell, NaN if it means "not measured", none for anything else (also inf, numbers beyond double and those
/// outside the range of projects).
std::optional<double> number(std::string_view cell) {
  if (cell.empty() || cell == "-" || cell == "nan" || cell == "NaN" || cell == "NAN")
    return std::numeric_limits<double>::quiet_NaN();
  if (cell.front() == '+') cell.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value) ||
      outside_range(value, Quantity::pure))
    return std::nullopt;
  return value;
}

/// Why number() rejects a cell.
std::string rule_of_cell(std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (end == cell.data() + cell.size() && error == std::errc{} && std::isfinite(value))
    if (const auto broken = outside_range(value, Quantity::pure)) return *broken;
  const bool number_and_more = error == std::errc{} && end != cell.data() + cell.size() && *end != ',' && *end != '.';
  return number_and_more ? "a cell is a number alone; its unit is in the heading: NAME [unit]"
                         : "a cell is a finite number with a decimal point, or empty if not measured";
}

/// Spreadsheets save empty cells right of a table, and empty rows below it.
void drop_empty_end(std::size_t columns, std::vector<std::string>& row) {
  while (row.size() > columns && row.back().empty()) row.pop_back();
}

bool is_empty(const std::vector<std::string>& row) {
  return row.size() > 1 && std::ranges::all_of(row, [](const std::string& cell) { return cell.empty(); });
}

bool all_numbers(const std::vector<std::string>& row) {
  return std::ranges::all_of(row, [](const std::string& cell) { return number(cell).has_value(); });
}

/// Separator of a header: the first of tab, semicolon, comma in it.
char separator_of(std::string_view header) {
  return header.find('\t') != std::string_view::npos ? '\t' : header.find(';') != std::string_view::npos ? ';' : ',';
}

/// The first two lines that are neither empty nor comments.
std::array<std::string_view, 2> first_lines(std::string_view text) {
  std::array<std::string_view, 2> found;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size() && count < found.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view content = without_blanks(text.substr(at, end - at));
    if (!content.empty() && content.front() != '#') found[count++] = content;
    at = end + 1;
  }
  return found;
}

/// Separator of a table: that of its header, or blanks if it has none and its rows are numbers between blanks.
char separator_of_table(std::string_view text) {
  const auto [header, row] = first_lines(text);
  if (header.find_first_of("\t;,") != std::string_view::npos || row.find_first_of("\t;,") != std::string_view::npos)
    return separator_of(header);
  const auto names = words(header), numbers = words(row.empty() ? header : row);
  return numbers.size() > 1 && names.size() == numbers.size() && all_numbers(numbers) ? blanks : ',';
}

class Reader {
 public:
  Reader(const std::string& source, std::size_t most_rows, const std::vector<std::string>& bare)
      : bare_(bare), most_rows_(most_rows) {
    table_.source = source;
  }

  foundation::Expected<CsvTable> read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    separator_ = separator_of_table(text);
    int line = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::string_view content = without_blanks(text.substr(at, end - at));
      std::string_view written = text.substr(at, end - at);
      if (written.ends_with('\r')) written.remove_suffix(1);
      ++line;
      at = end + 1;
      if (content.empty() || content.front() == '#') continue;
      if (width_ == 0) read_header(written, line);
      else read_row(written, line);
      if (width_ == 0 || too_long_) break;
    }
    if (table_.lines.empty() && !problems_.has_errors())
      problem(line, width_ == 0 ? "the table is empty" : "no row below the header", std::string(table_rule),
              "check the file");
    if (problems_.has_errors()) return tl::make_unexpected(std::move(problems_));
    const auto rows = to_index(table_.lines.size()), count = to_index(table_.columns.size());
    table_.values = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        values_.data(), rows, count);
    if (counts_rows_) problems_.add(drop_row_numbers(table_, header_line_));
    if (bare_heading_.line > 0) problems_.add(judge_bare_heading(table_, bare_heading_));
    if (problems_.has_errors()) return tl::make_unexpected(std::move(problems_));
    return std::move(table_);
  }

 private:
  void problem(int line, std::string finding, std::string broken_rule, std::string remedy) {
    problems_.error("", std::move(finding), std::move(broken_rule), std::move(remedy)).origin = {table_.source, line,
                                                                                                 0};
  }

  void read_header(std::string_view line, int number_of_line) {
    auto names = cells(line, separator_);
    if (!names) return problem(number_of_line, "a quote is not closed", std::string(table_rule), "close it");
    const std::size_t cells_of_header = names->size();
    drop_empty_end(1, *names);
    unnamed_ = cells_of_header - names->size();
    header_line_ = number_of_line;
    counts_rows_ = names->size() > 1 && names->front().empty();
    if (all_numbers(*names)) {
      const std::size_t before = counts_rows_ ? 1 : 0;
      if (names->size() != bare_.size() + before || bare_.empty())
        return problem(number_of_line, "the first row holds numbers", "the first row names the columns",
                       bare_.empty() ? "add a header row" : "add a header row: " + foundation::comma_separated(bare_));
      bare_heading_ = {.line = number_of_line, .counts_columns = true};
      const std::string first = (*names)[before];
      for (std::size_t i = 0; i < bare_.size(); ++i)
        bare_heading_.counts_columns = bare_heading_.counts_columns && (first == "0" || first == "1") &&
            (*names)[before + i] == std::to_string(i + (first == "1"));
      std::ranges::copy(bare_, names->begin() + static_cast<std::ptrdiff_t>(before));
    }
    if (names->size() > most_columns)
      return problem(number_of_line, fmt::format("{} columns", names->size()),
                     fmt::format("a table has at most {} columns", most_columns),
                     "is this the right file? keep the columns that are needed");
    width_ = names->size();
    most_rows_ = std::min(most_rows_, most_cells / width_);
    header_ = *names;
    std::map<std::string, int> count;
    for (const std::string& name : *names) ++count[name];
    for (const std::string& name : *names) {
      if (const auto found = foundation::unprintable(name))
        problem(number_of_line, "a column name holds " + *found, "names are printable UTF-8 on one line",
                "rename the column, or save the file as UTF-8");
      if (name.empty() && (!counts_rows_ || &name != names->data()))
        problem(number_of_line, fmt::format("column {} has no name", table_.columns.size() + 1),
                "every column has a name", "name it");
      if (count[name] > 1 && !name.empty()) {
        count[name] = 1;  // reported once
        problem(number_of_line, "the column " + foundation::shortened(name) + " appears twice",
                "every column has a different name", "rename one");
      }
      if (name == name_column) texts_at_ = &name - names->data();
      else table_.columns.push_back(name);
    }
    // A bare first row is data; that of a data frame with row numbers counts the columns.
    if (bare_heading_.line > 0 && !counts_rows_) read_row(line, number_of_line);
  }

  void read_row(std::string_view line, int number_of_line) {
    auto row = cells(line, separator_);
    if (row) drop_empty_end(width_, *row);
    if (row && is_empty(*row)) return;
    if (row && row->size() > width_ && row->size() <= width_ + unnamed_) {
      unnamed_ = 0;
      return problem(header_line_, fmt::format("column {} has no name", row->size()), "every column has a name",
                     "name it");
    }
    if (!row || row->size() != width_) {
      if (ragged_++ < most_listed)
        problem(number_of_line, row ? fmt::format("{} cells", row->size()) : "a quote is not closed",
                fmt::format("the header has {} columns", width_),
                "complete the row; numbers have a decimal point, not a comma");
      return;
    }
    if (table_.lines.size() == most_rows_) {
      too_long_ = true;
      return problem(number_of_line, fmt::format("more than {} rows", most_rows_),
                     fmt::format("a table of this kind has at most {} rows", most_rows_),
                     "take every tenth row, or the part that is needed");
    }
    table_.lines.push_back(number_of_line);
    if (bare_heading_.line > 0 && number_of_line > bare_heading_.line)
      bare_heading_.whole_below = bare_heading_.whole_below || std::ranges::any_of(*row, [](const std::string& cell) {
                                    return cell.find_first_of(".eE") == std::string::npos;
                                  });
    for (std::size_t i = 0; i < width_; ++i) {
      if (static_cast<std::ptrdiff_t>(i) == texts_at_) {
        if (const auto found = foundation::unprintable((*row)[i]); found && wrong_cells_++ < most_listed)
          problem(number_of_line, "a name holds " + *found, "names are printable UTF-8 on one line",
                  "rename it, or save the file as UTF-8");
        table_.names.push_back((*row)[i]);
        continue;
      }
      const std::string& cell = (*row)[i];
      const auto value = number(cell);
      if (!value && wrong_cells_++ < most_listed)
        problem(number_of_line, foundation::shortened(header_[i]) + " = " + foundation::quoted(cell),
                rule_of_cell(cell), "correct the cell, or begin a comment line with #");
      values_.push_back(value.value_or(0));
    }
  }

  CsvTable table_;
  foundation::Problems problems_;
  const std::vector<std::string>& bare_;
  int header_line_ = 0;
  BareHeading bare_heading_;
  std::size_t unnamed_ = 0;     ///< empty cells at the end of the header
  bool counts_rows_ = false;    ///< the first column has no name
  std::vector<double> values_;  // row by row
  std::size_t width_ = 0;
  std::ptrdiff_t texts_at_ = -1;
  std::vector<std::string> header_;
  std::size_t most_rows_;
  bool too_long_ = false;
  char separator_ = ',';
  int ragged_ = 0, wrong_cells_ = 0;
};

tl::unexpected<foundation::Problems> refused(const std::filesystem::path& path, std::string finding,
                                             std::string remedy) {
  return foundation::failure({.origin = {path.string()},
                              .finding = std::move(finding),
                              .rule = "a table must be a readable text file",
                              .remedy = std::move(remedy)});
}

}  // namespace

foundation::Expected<CsvTable> csv_table(std::string_view text, const std::string& source, std::size_t most_rows,
                                         const std::vector<std::string>& bare) {
  return Reader(source, most_rows, bare).read(text);
}

namespace {

/// The bytes of a table.
foundation::Expected<std::string> table_text(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return refused(path, error ? error.message() : "no such file", "check the path");
  if (!std::filesystem::is_regular_file(path, error)) return refused(path, "this is not a file", "name the .csv file");
  const auto size = std::filesystem::file_size(path, error);
  if (size > largest_csv_file)
    return refused(path, fmt::format("larger than {} MiB", largest_csv_file >> 20), "is this the right file?");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refused(path, std::strerror(errno), "check its permissions");
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (stream.bad() || static_cast<std::uintmax_t>(stream.gcount()) != size)
    return refused(path, "reading failed", "check the disk");
  if (exchange::begins_as_universal_file(text))
    return refused(path, "a universal file",
                   "write a table in CSV form; universal files are read by `history` and `psd` of excitations, "
                   "[measurements] and mobilities with `nodes`");
  if (text.find('\0') != std::string::npos)
    return refused(path, "the file contains NUL bytes", "it is not a text file, or is in UTF-16: save it as UTF-8");
  return exchange::with_line_feeds(std::move(text));
}

}  // namespace

foundation::Expected<CsvTable> read_csv_table(const std::filesystem::path& path, std::size_t most_rows,
                                              const std::vector<std::string>& bare) {
  const auto text = table_text(path);
  if (!text) return tl::make_unexpected(text.error());
  return csv_table(*text, path.string(), most_rows, bare);
}

foundation::Expected<TextTable> read_text_table(const std::filesystem::path& path, std::size_t most_rows) {
  const auto read = table_text(path);
  if (!read) return tl::make_unexpected(read.error());
  std::string_view text = *read;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  TextTable table;
  foundation::Problems problems;
  const auto problem = [&](int line, std::string finding, std::string broken_rule, std::string remedy) {
    problems.error("", std::move(finding), std::move(broken_rule), std::move(remedy)).origin = {path.string(), line, 0};
  };
  char separator = ',';
  int line = 0;
  for (std::size_t at = 0; at < text.size() && problems.errors() < most_listed;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view content = without_blanks(text.substr(at, end - at));
    ++line;
    at = end + 1;
    if (content.empty()) continue;
    if (content.front() == '#') {
      const auto commented = table.columns.size() > 1 ? cells(content, separator) : std::nullopt;
      if (commented && commented->size() == table.columns.size()) table.comments_like_rows.push_back(line);
      continue;
    }
    if (table.columns.empty()) separator = separator_of(content);
    auto row = cells(content, separator);
    if (row) drop_empty_end(table.columns.empty() ? 1 : table.columns.size(), *row);
    if (row && !table.columns.empty() && is_empty(*row)) continue;
    // `content` lacks the last tabs of a row with empty last cells.
    if (row && !table.columns.empty() && row->size() < table.columns.size() && (separator == '\t'))
      row->resize(table.columns.size());
    for (std::size_t i = 0; row && i < row->size(); ++i)
      if (const auto found = foundation::unprintable((*row)[i]))
        problem(line, "a cell holds " + *found, "cells are printable UTF-8 on one line",
                "correct it, or save the file as UTF-8");
    if (!row) {
      problem(line, "a quote is not closed", std::string(table_rule), "close it");
    } else if (table.columns.empty()) {
      table.header_line = line;
      table.columns = std::move(*row);
      for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (table.columns[i].empty())
          problem(line, fmt::format("column {} has no name", i + 1), "every column has a name", "name it");
        else if (std::count(table.columns.begin(), table.columns.begin() + static_cast<std::ptrdiff_t>(i),
                            table.columns[i]) > 0)
          problem(line, "the column " + foundation::shortened(table.columns[i]) + " appears twice",
                  "every column has a different name", "rename one");
      }
      if (table.columns.size() > most_columns)
        problem(line, fmt::format("{} columns", table.columns.size()),
                fmt::format("a table has at most {} columns", most_columns), "is this the right file?");
    } else if (row->size() != table.columns.size()) {
      problem(line, fmt::format("{} cells", row->size()),
              fmt::format("the header has {} columns", table.columns.size()),
              "complete the row; numbers have a decimal point, not a comma");
    } else if (table.rows.size() == most_rows) {
      problem(line, fmt::format("more than {} rows", most_rows),
              fmt::format("a table of this kind has at most {} rows", most_rows), "split the model");
      break;
    } else {
      table.rows.push_back(std::move(*row));
      table.lines.push_back(line);
    }
  }
  if (table.rows.empty() && !problems.has_errors())
    problem(line, table.columns.empty() ? "the table is empty" : "no row below the header", std::string(table_rule),
            "check the file");
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return table;
}

foundation::Expected<Eigen::MatrixXd> columns(const CsvTable& table, const std::vector<std::string>& wanted) {
  foundation::Problems problems;
  Eigen::MatrixXd result(table.values.rows(), to_index(wanted.size()));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto found = std::ranges::find(table.columns, wanted[i]);
    if (found != table.columns.end()) {
      result.col(to_index(i)) = table.values.col(found - table.columns.begin());
      continue;
    }
    const std::string guess = foundation::nearest_name(wanted[i], table.columns);
    problems
        .error("", "no column " + wanted[i], "the columns are: " + foundation::comma_separated(table.columns),
               guess.empty() ? "add it or rename one" : "did you mean " + guess + "?")
        .origin = {table.source, 0, 0};
  }
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return result;
}

}  // namespace trivet::project
