// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/matrix_file.h"

#include <algorithm>
#include <utility>

#include "trivet/exchange/matrix_formats.h"
#include "trivet/exchange/named_matrix.h"
#include "trivet/exchange/text/file_bytes.h"
#include "trivet/exchange/text/text_lines.h"

namespace trivet::exchange {
namespace {

/// True for a first line that is, or means to be, the header of a Matrix Market file.
bool is_market_header(std::string_view bytes) {
  std::string_view line = trimmed(bytes.substr(0, bytes.find('\n')));
  if (!line.starts_with('%')) return false;
  line.remove_prefix(std::min(line.find_first_not_of('%'), line.size()));
  const std::string words = lower(line);
  return words.starts_with("matrixmarket") || words.starts_with("matrix market");
}

std::string format_of(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.starts_with("\x93NUMPY")) return "numpy";
  if (is_market_header(bytes)) return "matrix_market";
  const std::string ending = lower(path.extension().string());
  if (ending == ".npy") return "numpy";
  if (ending == ".mm") return "matrix_market";
  if (ending == ".mtx" || ending == ".inp") return "abaqus";
  if (ending == ".sti" || ending == ".mas") return "calculix";
  if (ending == ".csv" || ending == ".txt") return "csv";
  for (const char* nastran : {".pch", ".bdf", ".nas", ".dmig", ".dat", ".blk"})
    if (ending == nastran) return "nastran";
  return "";
}

}  // namespace

const std::vector<std::string>& matrix_formats() {
  static const std::vector<std::string> formats{"matrix_market", "numpy", "csv", "nastran", "abaqus", "calculix"};
  return formats;
}

foundation::Expected<NamedMatrix> read_matrix_file(const std::filesystem::path& path,
                                                   const MatrixFileOptions& options) {
  auto bytes = file_bytes(path);
  if (!bytes) return tl::make_unexpected(bytes.error());
  *bytes = with_line_feeds(std::move(*bytes));
  if (bytes->starts_with("\xEF\xBB\xBF")) bytes->erase(0, 3);
  const std::string source = path.string();
  const std::string format = options.format.empty() ? format_of(path, *bytes) : options.format;
  if (format == "numpy") return read_numpy_array(*bytes, source);
  if (format == "matrix_market") return read_matrix_market(*bytes, source);
  if (format == "csv") return read_csv_matrix(*bytes, source);
  if (format == "nastran") return read_nastran_dmig(*bytes, source, options.name);
  if (format == "abaqus") return read_abaqus_matrix(*bytes, source, options.name.empty() ? "stiffness" : options.name);
  if (format == "calculix") {
    std::filesystem::path rows = path;
    rows.replace_extension(".dof");
    const auto rows_text = file_bytes(rows);
    if (!rows_text) return tl::make_unexpected(rows_text.error());
    return read_matrix_storage(*bytes, source, *rows_text, rows.string());
  }
  FileProblems problems(source);
  std::string known;
  for (const std::string& one : matrix_formats()) known += (known.empty() ? "" : ", ") + one;
  problems.error(0, "format", options.format.empty() ? "the file name does not show it" : in_quotes(options.format),
                 "known formats are " + known, "name one of them");
  return problems.refused();
}

}  // namespace trivet::exchange
