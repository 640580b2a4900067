// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/matlab_completeness.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <vector>

/// The layout is that of "MAT-File Format", The MathWorks: a tag of 8 bytes (type and size) before every element,
/// padded to 8 bytes; up to 4 bytes lie in the tag itself.
namespace trivet::exports {
namespace {

constexpr std::uint64_t header_size = 128, tag_size = 8;
constexpr std::uint32_t of_matrix = 14, cell_class = 1, structure_class = 2, complex_flag = 0x800;

struct Element {
  std::uint32_t type = 0;
  std::uint64_t data = 0, size = 0, end = 0;  ///< places in the file; `end` with padding
};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : file_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {}

  bool is_complete() {
    std::uint64_t at = header_size;
    while (at < size_) {
      const Element variable = element(at);
      if (variable.end > size_ || !is_complete_matrix(variable)) return false;
      at = variable.end;
    }
    return at == size_;
  }

 private:
  std::uint32_t number(std::uint64_t at) {
    std::uint32_t value = 0;
    file_.seekg(static_cast<std::streamoff>(at));
    file_.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  }

  Element element(std::uint64_t at) {
    const std::uint32_t type = number(at), small_size = type >> 16;
    if (small_size != 0) return {type & 0xffff, at + 4, small_size, at + tag_size};
    const std::uint64_t size = number(at + 4), data = at + tag_size;
    return {type, data, size, data + (size + tag_size - 1) / tag_size * tag_size};
  }

  /// Flags, sizes and name, then what its class requires. An empty matrix has nothing after its tag.
  bool is_complete_matrix(const Element& matrix) {
    if (matrix.type != of_matrix) return false;
    if (matrix.size == 0) return true;
    std::vector<Element> parts;
    for (std::uint64_t at = matrix.data; at < matrix.end; at = parts.back().end) parts.push_back(element(at));
    if (parts.size() < 3 || parts.back().end != matrix.end) return false;
    std::uint64_t count = 1;
    for (std::uint64_t at = 0; at < parts[1].size; at += 4) count *= number(parts[1].data + at);
    const std::uint32_t flags = number(parts[0].data), kind = flags & 0xff;
    std::size_t first = 3;
    if (kind == structure_class) {
      if (parts.size() < 5) return false;
      count *= parts[4].size / number(parts[3].data);
      first = 5;
    }
    if (kind != cell_class && kind != structure_class)
      return count == 0 || parts.size() == first + ((flags & complex_flag) != 0 ? 2 : 1);
    if (parts.size() != first + count) return false;
    for (std::size_t i = first; i < parts.size(); ++i)
      if (!is_complete_matrix(parts[i])) return false;
    return true;
  }

  std::ifstream file_;
  std::uint64_t size_;
};

}  // namespace

void require_complete_matlab_file(const std::filesystem::path& path) {
  if (!Reader(path).is_complete())
    throw std::runtime_error(fmt::format("cannot write {}: the file is incomplete; is the disk full?", path.string()));
}

}  // namespace trivet::exports
