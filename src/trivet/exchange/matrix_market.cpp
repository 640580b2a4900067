// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/matrix_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {
namespace {

/// What the entries above the diagonal are, of those below it; `general`: they are in the file.
enum class MarketSymmetry { general, symmetric, skew_symmetric, hermitian };

struct MarketHeader {
  bool coordinate = false;
  bool is_complex = false;
  MarketSymmetry symmetry = MarketSymmetry::general;

  /// Row of the first entry of a column of an array.
  [[nodiscard]] int first_row(int column) const {
    if (symmetry == MarketSymmetry::general) return 0;
    return symmetry == MarketSymmetry::skew_symmetric ? column + 1 : column;
  }
};

/// What is wrong with the words of a header, if it is more than a word that is not known.
std::string remedy_of_header(const std::vector<std::string_view>& words) {
  const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
  if (has("pattern")) return "a pattern has no values: write the matrix with its numbers";
  if (has("vector")) return "a vector is no stiffness matrix: write a matrix";
  return "correct the line, or write the matrix again";
}

std::optional<MarketHeader> read_header(Lines& lines, FileProblems& problems) {
  const std::string rule =
      "the first line is %%MatrixMarket matrix, then coordinate or array, real, integer or complex, general, "
      "symmetric, "
      "skew-symmetric or hermitian";
  if (!lines.next()) {
    problems.error(0, "header", "the file is empty", rule, "did the program that wrote it finish?");
    return std::nullopt;
  }
  const std::string line = lower(lines.line());
  const auto parts = blank_separated(line);
  const auto is = [&](std::size_t i, std::initializer_list<std::string_view> allowed) {
    return i < parts.size() && std::ranges::find(allowed, parts[i]) != allowed.end();
  };
  if (parts.size() != 5 || !is(0, {"%%matrixmarket"}) || !is(1, {"matrix"}) || !is(2, {"coordinate", "array"}) ||
      !is(3, {"real", "double", "integer", "unsigned-integer", "complex"}) ||
      !is(4, {"general", "symmetric", "skew-symmetric", "hermitian"})) {
    problems.error(lines.number(), "header", in_quotes(lines.line()), rule, remedy_of_header(parts));
    return std::nullopt;
  }
  using enum MarketSymmetry;
  return MarketHeader{is(2, {"coordinate"}), is(3, {"complex"}),
                      is(4, {"general"})              ? general
                          : is(4, {"symmetric"})      ? symmetric
                          : is(4, {"skew-symmetric"}) ? skew_symmetric
                                                      : hermitian};
}

/// A number with an exponent of C or of Fortran: 1.5D+03.
std::optional<double> market_number(std::string_view text) {
  return text.find_first_of("dD") == std::string_view::npos ? number(text) : fortran_number(text);
}

/// Moves to the next line that is neither blank nor a comment.
bool next_data(Lines& lines) {
  while (lines.next())
    if (const auto text = trimmed(lines.line()); !text.empty() && !text.starts_with('%')) return true;
  return false;
}

void read_coordinates(Lines& lines, const MarketHeader& header, int order, long long count, std::vector<Entry>& entries,
                      FileProblems& problems) {
  const std::size_t wanted = header.is_complex ? 4 : 3;
  while (!problems.enough() && next_data(lines)) {
    const auto parts = blank_separated(lines.line());
    if (static_cast<long long>(entries.size()) >= count) {
      problems.error(lines.number(), "entries", fmt::format("more than the stated {}", count),
                     "the size line states the number of entries", "correct the size line");
      return;
    }
    Entry entry{.line = lines.number()};
    const auto row = parts.empty() ? std::nullopt : whole_number(parts[0]);
    const auto column = parts.size() < 2 ? std::nullopt : whole_number(parts[1]);
    const auto real = parts.size() < 3 ? std::nullopt : market_number(parts[2]);
    const auto imaginary = parts.size() < 4 ? std::optional(0.0) : market_number(parts[3]);
    if (parts.size() != wanted || !row || !column || !real || !imaginary) {
      problems.error(lines.number(), "entry", in_quotes(lines.line()),
                     header.is_complex ? "an entry is row, column, real and imaginary part"
                                       : "an entry is row, column and a finite number",
                     "correct the line");
    } else if (*row < 1 || *row > order || *column < 1 || *column > order) {
      problems.error(
          lines.number(), "entry", fmt::format("row {}, column {}", *row, *column),
          fmt::format("rows and columns count from 1 to {}", order),
          *row == 0 || *column == 0 ? "the file seems to count from 0: add 1" : "correct the size line or the entry");
    } else {
      entry.row = *row - 1, entry.column = *column - 1, entry.real = *real, entry.imaginary = *imaginary;
    }
    entries.push_back(entry);
  }
  if (!problems.any() && static_cast<long long>(entries.size()) < count)
    problems.error(lines.number(), "entries", fmt::format("the file ends after {} of {}", entries.size(), count),
                   "the size line states the number of entries", "was the file cut off?");
}

/// Reads values column by column; for a symmetric matrix from the diagonal downwards, for a skew-symmetric one from
/// below it.
void read_array(Lines& lines, const MarketHeader& header, int order, std::vector<Entry>& entries,
                FileProblems& problems) {
  int row = header.first_row(0), column = 0;
  const auto to_next_column = [&] {
    while (row >= order && column < order) row = header.first_row(++column);
  };
  to_next_column();
  const std::size_t wanted = header.is_complex ? 2 : 1;
  while (!problems.enough() && next_data(lines)) {
    if (column == order) {
      problems.error(lines.number(), "entries", fmt::format("more than a {0} × {0} matrix has", order),
                     "the size line states the number of rows and columns", "correct the size line");
      return;
    }
    const auto parts = blank_separated(lines.line());
    const auto real = parts.empty() ? std::nullopt : market_number(parts[0]);
    const auto imaginary = parts.size() < 2 ? std::optional(0.0) : market_number(parts[1]);
    if (parts.size() != wanted || !real || !imaginary)
      problems.error(lines.number(), "entry", in_quotes(lines.line()),
                     header.is_complex ? "a line holds real and imaginary part" : "a line holds one finite number",
                     "correct the line");
    entries.push_back({row, column, real.value_or(0), imaginary.value_or(0), lines.number()});
    ++row;
    to_next_column();
  }
  if (!problems.any() && column < order)
    problems.error(lines.number(), "entries", fmt::format("the file ends in column {} of {}", column + 1, order),
                   "every entry of an array is written", "was the file cut off?");
}

/// Adds the entries above the diagonal of a skew-symmetric or hermitian matrix; rejects entries on it that are not 0 or
/// not real.
void add_mirrored(const MarketHeader& header, std::vector<Entry>& entries, FileProblems& problems) {
  const bool skew = header.symmetry == MarketSymmetry::skew_symmetric;
  const std::size_t count = entries.size();
  for (std::size_t i = 0; i < count && !problems.enough(); ++i) {
    Entry mirrored = entries[i];
    if (mirrored.row == mirrored.column) {
      if (mirrored.imaginary == 0 && (!skew || mirrored.real == 0)) continue;
      problems.error(
          mirrored.line, "entry", fmt::format("({0}, {0}) on the diagonal", mirrored.row + 1),
          skew ? "the diagonal of a skew-symmetric matrix is 0" : "the diagonal of a hermitian matrix is real",
          "correct the entry, or declare the matrix as general");
      continue;
    }
    std::swap(mirrored.row, mirrored.column);
    if (skew) mirrored.real = -mirrored.real;
    mirrored.imaginary = -mirrored.imaginary;
    entries.push_back(mirrored);
  }
}

}  // namespace

foundation::Expected<NamedMatrix> read_matrix_market(std::string_view text, const std::string& source) {
  FileProblems problems(source);
  Lines lines(text);
  const auto header = read_header(lines, problems);
  if (!header) return problems.refused();

  const auto sizes = next_data(lines) ? blank_separated(lines.line()) : std::vector<std::string_view>{};
  const std::size_t wanted = header->coordinate ? 3 : 2;
  const auto rows = sizes.size() == wanted ? whole_number(sizes[0]) : std::nullopt;
  const auto columns = rows ? whole_number(sizes[1]) : std::nullopt;
  const auto count = !columns ? std::nullopt : header->coordinate ? whole_number(sizes[2]) : std::optional(0);
  if (!count || *count < 0) {
    problems.error(
        lines.number(), "size", sizes.empty() ? "missing" : in_quotes(lines.line()),
        header->coordinate ? "the size line is rows, columns, number of entries" : "the size line is rows and columns",
        "correct the size line");
    return problems.refused();
  }
  check_size(*rows, *columns, lines.number(), problems);
  if (problems.any()) return problems.refused();

  std::vector<Entry> entries;
  if (header->coordinate) read_coordinates(lines, *header, *rows, *count, entries, problems);
  else read_array(lines, *header, *rows, entries, problems);
  if (problems.any()) return problems.refused();
  const bool symmetric = header->symmetry == MarketSymmetry::symmetric;
  if (!symmetric && header->symmetry != MarketSymmetry::general) add_mirrored(*header, entries, problems);
  if (problems.any()) return problems.refused();
  auto matrix =
      assembled(std::move(entries), *rows, symmetric ? Triangles::one : Triangles::both, header->is_complex, problems);
  if (!matrix) return problems.refused();
  return std::move(*matrix);
}

}  // namespace trivet::exchange
