// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/completeness.h"

#include <fmt/format.h>
#include <zlib.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace trivet::exports {

// The layout is that of ZIP, APPNOTE 6.3, sections 4.3.7 (local header), 4.3.12 (directory), 4.3.16 (its end).

namespace {

constexpr std::size_t local_header = 30, directory_entry = 46, directory_end = 22;

class Archive {
 public:
  explicit Archive(std::string bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] bool is_complete() const {
    if (bytes_.size() < directory_end) return false;
    const std::size_t end = bytes_.size() - directory_end;
    if (!has("PK\5\6", end)) return false;
    std::size_t at = number(end + 16, 4);
    for (std::size_t entries = number(end + 10, 2); entries > 0; --entries) {
      if (!has("PK\1\2", at) || !is_complete_part(at)) return false;
      at += directory_entry + number(at + 28, 2) + number(at + 30, 2) + number(at + 32, 2);
    }
    return at == end;
  }

 private:
  [[nodiscard]] bool has(std::string_view mark, std::size_t at) const {
    return at <= bytes_.size() && std::string_view(bytes_).substr(at, mark.size()) == mark;
  }

  /// Little-endian; 0 beyond the end.
  [[nodiscard]] std::size_t number(std::size_t at, std::size_t count) const {
    std::size_t value = 0;
    for (std::size_t i = count; i-- > 0;)
      value = value << 8 | (at + i < bytes_.size() ? static_cast<unsigned char>(bytes_[at + i]) : 0u);
    return value;
  }

  [[nodiscard]] bool is_complete_part(std::size_t entry) const {
    const std::size_t header = number(entry + 42, 4);
    if (!has("PK\3\4", header)) return false;
    const std::size_t data = header + local_header + number(header + 26, 2) + number(header + 28, 2);
    const std::optional<std::string> content =
        inflated(data, number(entry + 20, 4), number(entry + 24, 4), number(entry + 10, 2));
    if (!content) return false;
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(content->data()), static_cast<uInt>(content->size()));
    return sum == number(entry + 16, 4) && ends_with_its_tag(*content);
  }

  [[nodiscard]] std::optional<std::string> inflated(std::size_t at, std::size_t compressed, std::size_t size,
                                                    std::size_t method) const {
    if (at + compressed > bytes_.size()) return std::nullopt;
    if (method == 0) return bytes_.substr(at, compressed);
    std::string content(size, '\0');
    z_stream stream = {};
    constexpr int raw_window = -15;
    if (inflateInit2(&stream, raw_window) != Z_OK) return std::nullopt;
    // zlib only reads the input; its interface predates const.
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes_.data() + at));
    stream.avail_in = static_cast<uInt>(compressed);
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = static_cast<uInt>(size);
    const int status = inflate(&stream, Z_FINISH);
    inflateEnd(&stream);
    return status == Z_STREAM_END && stream.avail_out == 0 ? std::optional(content) : std::nullopt;
  }

  /// <?xml …?> <worksheet …> … </worksheet>, or <one .../>
  static bool ends_with_its_tag(std::string_view xml) {
    while (!xml.empty() && (xml.back() == '\n' || xml.back() == '\r')) xml.remove_suffix(1);
    const std::size_t declaration = xml.find("?>");
    const std::size_t open = declaration == std::string_view::npos ? declaration : xml.find('<', declaration);
    if (open == std::string_view::npos) return false;
    const std::string_view name = xml.substr(open + 1, xml.find_first_of(" />\n", open) - open - 1);
    if (xml.ends_with("</" + std::string(name) + ">")) return true;
    return xml.find('>', open) == xml.size() - 1 && xml.ends_with("/>");
  }

  std::string bytes_;
};

}  // namespace

void require_complete_workbook(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const Archive archive(std::string(std::istreambuf_iterator<char>(file), {}));
  if (!archive.is_complete())
    throw std::runtime_error(fmt::format("cannot write {}: the file is incomplete; is the disk full?", path.string()));
}

}  // namespace trivet::exports
