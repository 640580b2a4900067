// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/matrix_formats.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "trivet/exchange/named_matrix.h"
#include "trivet/foundation/index.h"

static_assert(std::endian::native == std::endian::little, "the numbers of a file are copied as they are");

namespace trivet::exchange {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

struct ArrayHeader {
  bool is_complex = false;
  bool by_columns = false;
  int order = 0;
};

/// Text after 'key': in the dictionary of the header.
std::string_view value_of(std::string_view header, std::string_view key) {
  const std::size_t at = header.find("'" + std::string(key) + "'");
  if (at == std::string_view::npos) return {};
  const std::string_view rest = trimmed(header.substr(at + key.size() + 2));
  return rest.starts_with(':') ? trimmed(rest.substr(1)) : std::string_view{};
}

std::optional<ArrayHeader> read_header(std::string_view text, FileProblems& problems) {
  ArrayHeader header;
  const std::string_view type = value_of(text, "descr");
  header.is_complex = type.starts_with("'<c16'");
  if (!header.is_complex && !type.starts_with("'<f8'"))
    problems.error(0, "number type", in_quotes(type.substr(0, type.find(", "))),
                   "float64 ('<f8') and complex128 ('<c16') are read",
                   "save numpy.ascontiguousarray(matrix, dtype=\"float64\")");
  const std::string_view order = value_of(text, "fortran_order");
  header.by_columns = order.starts_with("True");
  if (!header.by_columns && !order.starts_with("False"))
    problems.error(0, "fortran_order", in_quotes(order.substr(0, order.find(','))), "it is True or False",
                   "write the file again with numpy.save");
  const std::string_view shape = value_of(text, "shape");
  const std::size_t end = shape.find(')');
  const auto sizes = shape.starts_with('(') && end != std::string_view::npos ? cells(shape.substr(1, end - 1), ',')
                                                                             : std::vector<std::string_view>{};
  const auto rows = sizes.size() == 2 ? whole_number(sizes[0]) : std::nullopt;
  const auto columns = rows ? whole_number(sizes[1]) : std::nullopt;
  if (!columns)
    problems.error(0, "shape", in_quotes(shape.substr(0, end == std::string_view::npos ? end : end + 1)),
                   "a matrix has two dimensions", "save a two-dimensional array");
  else check_size(*rows, *columns, 0, problems);
  header.order = rows.value_or(0);
  return problems.any() ? std::nullopt : std::optional(header);
}

/// Header text, removed from the front of the bytes; nullopt with an error if the file is invalid.
std::optional<std::string_view> cut_header(std::string_view& bytes, FileProblems& problems) {
  const std::size_t length_at = magic.size() + 2;
  const int version = bytes.size() > magic.size() ? static_cast<unsigned char>(bytes[magic.size()]) : 0;
  if (!bytes.starts_with(magic) || version < 1 || version > 3) {
    const bool zipped = bytes.starts_with("PK");
    problems.error(0, "header", zipped ? "an archive" : "not a NumPy file of format 1, 2 or 3",
                   "a .npy file holds one array",
                   zipped ? "extract the array from the .npz: numpy.save" : "write it with numpy.save");
    return std::nullopt;
  }
  const std::size_t width = version == 1 ? 2 : 4;
  std::size_t length = 0;
  for (std::size_t i = 0; i < width && length_at + i < bytes.size(); ++i)
    length |= std::size_t{static_cast<unsigned char>(bytes[length_at + i])} << (8 * i);
  const std::size_t start = length_at + width;
  if (bytes.size() < start || bytes.size() - start < length) {
    problems.error(0, "header", fmt::format("{} bytes stated, the file has {}", length, bytes.size()),
                   "the header comes before the numbers", "was the file cut off?");
    return std::nullopt;
  }
  const std::string_view header = bytes.substr(start, length);
  bytes.remove_prefix(start + length);
  return header;
}

}  // namespace

foundation::Expected<NamedMatrix> read_numpy_array(std::string_view bytes, const std::string& source) {
  FileProblems problems(source);
  const auto text = cut_header(bytes, problems);
  const auto header = text ? read_header(*text, problems) : std::nullopt;
  if (!header) return problems.refused();
  const int order = header->order, parts = header->is_complex ? 2 : 1;
  const std::size_t wanted = sizeof(double) * to_size(parts) * to_size(order) * to_size(order);
  if (bytes.size() != wanted) {
    problems.error(0, "numbers", fmt::format("{} bytes", bytes.size()),
                   fmt::format("a {0} × {0} matrix of this type has {1}", order, wanted),
                   bytes.size() < wanted ? "was the file cut off?" : "write the file again with numpy.save");
    return problems.refused();
  }
  NamedMatrix matrix;
  matrix.values.resize(order, order);
  if (header->is_complex) matrix.imaginary.resize(order, order);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j) {
      double number[2] = {0, 0};
      const std::size_t index = to_size(header->by_columns ? j * order + i : i * order + j);
      const std::size_t size = sizeof(double) * to_size(parts);
      std::memcpy(number, bytes.data() + index * size, size);
      matrix.values(i, j) = number[0];
      if (header->is_complex) matrix.imaginary(i, j) = number[1];
      if (problems.enough() || (std::isfinite(number[0]) && std::isfinite(number[1]))) continue;
      problems.error(0, fmt::format("entry ({}, {})", i + 1, j + 1),
                     fmt::format("{}", std::isfinite(number[0]) ? number[1] : number[0]), "every entry must be finite",
                     "find the cause in the program that wrote the file");
    }
  if (problems.any()) return problems.refused();
  return matrix;
}

}  // namespace trivet::exchange
