// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/stl_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <unordered_map>

#include "trivet/foundation/index.h"

namespace trivet::solids {
namespace {

using foundation::Problems;
using Corner = std::array<double, 3>;

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;
constexpr std::size_t triangles_between_reports = 50'000;

struct CornerHash {
  std::size_t operator()(const Corner& c) const {
    std::uint64_t hash = 0;
    for (const double x : c) hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u, hash ^= hash >> 29;
    return hash;
  }
};

/// Collects corners, three per triangle.
class Builder {
 public:
  void add(const Corner& corner) {
    const Corner key{corner[0] + 0.0, corner[1] + 0.0, corner[2] + 0.0};  // −0 is 0
    const auto [place, is_new] = numbers_.try_emplace(key, static_cast<int>(corners_.size()));
    if (is_new) corners_.push_back(key);
    order_.push_back(place->second);
  }
  [[nodiscard]] std::size_t count() const { return order_.size() / 3; }
  [[nodiscard]] TriangleSurface surface() const {
    return {Eigen::Map<const Eigen::Matrix3Xd>(corners_.empty() ? nullptr : corners_[0].data(), 3,
                                               to_index(corners_.size())),
            Eigen::Map<const Eigen::Matrix3Xi>(order_.data(), 3, to_index(count()))};
  }

 private:
  std::unordered_map<Corner, int, CornerHash> numbers_;
  std::vector<Corner> corners_;
  std::vector<int> order_;
};

tl::unexpected<Problems> refused(const std::filesystem::path& file, const std::string& finding, int line = 0) {
  return foundation::failure(
      {.subject = "file",
       .finding = fmt::format("{}{}: {}", file.string(), line > 0 ? fmt::format(", line {}", line) : "", finding),
       .rule = "an STL file holds triangles, as binary records or as text from 'solid' to 'endsolid'",
       .remedy = "export the part again as STL"});
}

bool finite(const Corner& c) { return std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]); }

foundation::Expected<TriangleSurface> read_binary(const std::filesystem::path& file, std::string_view bytes,
                                                  std::size_t count, const foundation::Progress& progress) {
  Builder builder;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % triangles_between_reports == 0)
      foundation::report_progress(progress, "reading STL", static_cast<double>(i) / static_cast<double>(count));
    for (std::size_t j = 0; j < 3; ++j) {
      std::array<float, 3> x;  // little-endian by the format
      std::memcpy(x.data(), bytes.data() + header_bytes + i * triangle_bytes + 12 * (j + 1), sizeof x);
      if (!finite({x[0], x[1], x[2]}))
        return refused(file,
                       fmt::format("triangle {} of {} has a coordinate that is not a finite number", i + 1, count));
      builder.add({x[0], x[1], x[2]});
    }
  }
  TriangleSurface surface = builder.surface();
  if (const std::size_t end = header_bytes + count * triangle_bytes; bytes.size() > end)
    surface.remarks.warning("file", fmt::format("{} bytes after the last of {} triangles", bytes.size() - end, count),
                            "the header of a binary STL file states the number of its triangles",
                            "they are ignored; check the part if they could be triangles");
  return surface;
}

/// Words of a text with their line numbers.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}
  /// The next word in lower case, empty at the end.
  std::string next() {
    while (!rest_.empty() && is_blank(rest_.front())) skip();
    std::string word;
    for (; !rest_.empty() && !is_blank(rest_.front()); rest_.remove_prefix(1)) word += lower(rest_.front());
    return word;
  }
  void skip_line() {
    while (!rest_.empty() && rest_.front() != '\n') rest_.remove_prefix(1);
  }
  [[nodiscard]] int line() const { return line_; }

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
  void skip() {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }
  std::string_view rest_;
  int line_ = 1;
};

/// Step of the last digit of coordinates that are printed with a fixed number of decimals: "10.001".
class PrintedStep {
 public:
  void add(std::string_view number) {
    const std::size_t point = number.find('.');
    const bool fixed = point != std::string_view::npos && number.find_first_of("eE") == std::string_view::npos;
    const std::size_t decimals = fixed ? number.size() - point - 1 : 0;
    if (decimals_ == unknown) decimals_ = decimals;
    if (decimals != decimals_) decimals_ = 0;
  }
  /// 0 without such a step.
  [[nodiscard]] double value() const {
    return decimals_ == 0 || decimals_ == unknown ? 0 : std::pow(10.0, -static_cast<double>(decimals_));
  }

 private:
  static constexpr std::size_t unknown = std::string_view::npos;
  std::size_t decimals_ = unknown;
};

bool read_corner(Words& words, Corner& corner, PrintedStep& step) {
  for (double& x : corner) {
    const std::string word = words.next();
    step.add(word);
    const char* begin = word.c_str() + (word.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.c_str() + word.size(), x);
    if (error != std::errc() || end != word.c_str() + word.size() || !std::isfinite(x)) return false;
  }
  return true;
}

foundation::Expected<TriangleSurface> read_text(const std::filesystem::path& file, std::string_view text,
                                                const foundation::Progress& progress) {
  Words words(text);
  Builder builder;
  PrintedStep step;
  int corners = 0;
  bool in_solid = false;
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid") {
      in_solid = true;
      words.skip_line();  // its name
    } else if (word == "endsolid") {
      in_solid = false;
      words.skip_line();
    } else if (word == "vertex") {
      Corner corner;
      if (!read_corner(words, corner, step))
        return refused(file, "'vertex' is not followed by three finite numbers", words.line());
      builder.add(corner);
      ++corners;
    } else if (word == "endloop") {
      if (corners != 3) return refused(file, fmt::format("a loop of {} vertices, not 3", corners), words.line());
      corners = 0;
      if (builder.count() % triangles_between_reports == 0) foundation::report_progress(progress, "reading STL", 0.5);
    } else if (word == "facet") {
      words.skip_line();  // its normal
    } else if (word != "outer" && word != "loop" && word != "endfacet") {
      return refused(file, fmt::format("unexpected '{:.40}'", word), words.line());
    }
  }
  if (in_solid || corners != 0) return refused(file, "ends without 'endsolid': it was cut off", words.line());
  TriangleSurface surface = builder.surface();
  surface.printed_step = step.value();
  return surface;
}

/// A text without what fills its last block: NUL, or the end mark of old systems.
std::string_view without_filling(std::string_view bytes) {
  while (!bytes.empty() && (bytes.back() == '\0' || bytes.back() == '\x1A')) bytes.remove_suffix(1);
  return bytes;
}

}  // namespace

foundation::Expected<TriangleSurface> read_stl(const std::filesystem::path& file,
                                               const foundation::Progress& progress) {
  std::error_code not_a_file;
  if (!std::filesystem::is_regular_file(file, not_a_file))
    return refused(file, "cannot be read");  // a pipe would block
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return refused(file, "cannot be read");
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});

  std::uint32_t count = 0;
  if (bytes.size() >= header_bytes) std::memcpy(&count, bytes.data() + header_bytes - 4, 4);
  // Binary headers may also begin with "solid": the size decides.
  const std::size_t stated_bytes = header_bytes + std::size_t{count} * triangle_bytes;
  const std::string_view content = without_filling(bytes);
  const bool exact = bytes.size() >= header_bytes && bytes.size() == stated_bytes;
  const bool text = !exact && content.find('\0') == std::string_view::npos && Words(content).next() == "solid";
  // Some programs append colours or text, or fill the last block of the disk.
  const bool binary = exact || (!text && count > 0 && bytes.size() > stated_bytes);
  if (!binary && !text)
    return refused(file,
                   bytes.size() < header_bytes
                       ? fmt::format("{} bytes, neither text nor a binary STL file", bytes.size())
                       : fmt::format("{} bytes; a binary file of {} triangles, as stated in its header, has {}",
                                     bytes.size(), count, header_bytes + std::size_t{count} * triangle_bytes));
  foundation::Expected<TriangleSurface> surface =
      binary ? read_binary(file, bytes, count, progress) : read_text(file, content, progress);
  if (surface && surface->triangles.cols() == 0) return refused(file, "contains no triangle");
  return surface;
}

}  // namespace trivet::solids
