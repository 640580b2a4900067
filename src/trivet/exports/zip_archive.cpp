// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/zip_archive.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <stdexcept>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::exports {
namespace {

constexpr std::size_t largest_size = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t most_files = std::numeric_limits<std::uint16_t>::max();
constexpr std::uint16_t stored = 0, deflated = 8;

/// Appends the lowest bytes of a number, lowest first.
void append_bytes(std::string& bytes, std::uint32_t number, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
}
void append_16(std::string& bytes, std::uint16_t number) { append_bytes(bytes, number, 2); }
void append_32(std::string& bytes, std::uint32_t number) { append_bytes(bytes, number, 4); }

std::uint32_t size_32(std::size_t size) {
  if (size > largest_size) throw foundation::InvalidInput("a ZIP archive cannot be larger than 4 GB");
  return static_cast<std::uint32_t>(size);
}

bool is_relative_path(const std::string& name) {
  std::size_t from = 0;
  while (from <= name.size()) {
    const std::size_t slash = std::min(name.find('/', from), name.size());
    const std::string part = name.substr(from, slash - from);
    if (part.empty() || part == "." || part == "..") return false;
    from = slash + 1;
  }
  return name.find_first_of("\\:") == std::string::npos && !foundation::unprintable(name) &&
      name.size() <= std::numeric_limits<std::uint16_t>::max();
}

/// A stream of raw deflate, released at the end.
class Deflation {
 public:
  Deflation() {
    constexpr int raw_window = -15, memory = 8;
    if (deflateInit2(&stream_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, raw_window, memory, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Deflation() { deflateEnd(&stream_); }
  Deflation(const Deflation&) = delete;
  Deflation& operator=(const Deflation&) = delete;

  std::string compressed(std::string_view content) {
    std::array<char, 1 << 16> part;
    std::string result;
    // zlib only reads the input; its interface predates const.
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(content.data()));
    stream_.avail_in = static_cast<uInt>(content.size());
    int status = Z_OK;
    while (status == Z_OK) {
      stream_.next_out = reinterpret_cast<Bytef*>(part.data());
      stream_.avail_out = static_cast<uInt>(part.size());
      status = deflate(&stream_, Z_FINISH);
      result.append(part.data(), part.size() - stream_.avail_out);
    }
    if (status != Z_STREAM_END) throw std::runtime_error("a file cannot be compressed");
    return result;
  }

 private:
  z_stream stream_ = {};
};

}  // namespace

void ZipArchive::add(const std::string& name, std::string_view content) {
  if (!is_relative_path(name))
    throw foundation::InvalidInput(
        fmt::format("{} is not a relative path inside a ZIP archive", foundation::quoted(name)));
  if (std::ranges::any_of(entries_, [&](const Entry& entry) { return entry.name == name; }))
    throw foundation::InvalidInput(fmt::format("{} is already in the ZIP archive", foundation::quoted(name)));
  if (entries_.size() == most_files) throw foundation::InvalidInput("a ZIP archive cannot have more than 65535 files");

  Entry entry{.name = name, .size = size_32(content.size()), .offset = size_32(files_.size())};
  const std::string smaller = Deflation().compressed(content);
  const bool compresses = smaller.size() < content.size();
  const std::string_view data = compresses ? std::string_view(smaller) : content;
  entry.method = compresses ? deflated : stored;
  entry.crc = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())));
  entry.compressed_size = size_32(data.size());
  size_32(files_.size() + data.size());

  append_32(files_, 0x04034b50);
  append_common_header(files_, entry);
  files_ += name;
  files_ += data;
  entries_.push_back(std::move(entry));
}

/// The fields that a file and its line of the directory have in common, up to the length of extra fields.
void ZipArchive::append_common_header(std::string& bytes, const Entry& entry) {
  constexpr std::uint16_t version_needed = 20, names_are_utf8 = 1 << 11, midnight = 0, first_of_january_1980 = 0x21;
  append_16(bytes, version_needed);
  append_16(bytes, names_are_utf8);
  append_16(bytes, entry.method);
  append_16(bytes, midnight);
  append_16(bytes, first_of_january_1980);
  append_32(bytes, entry.crc);
  append_32(bytes, entry.compressed_size);
  append_32(bytes, entry.size);
  append_16(bytes, static_cast<std::uint16_t>(entry.name.size()));
  append_16(bytes, 0);  // extra fields
}

void ZipArchive::append_directory_entry(std::string& bytes, const Entry& entry) {
  constexpr std::uint16_t made_by_unix = (3 << 8) | 20;
  constexpr std::uint32_t regular_file_644 = 0100644;
  append_32(bytes, 0x02014b50);
  append_16(bytes, made_by_unix);
  append_common_header(bytes, entry);
  append_16(bytes, 0);  // comment
  append_16(bytes, 0);  // number of the disk
  append_16(bytes, 0);  // internal attributes
  append_32(bytes, regular_file_644 << 16);
  append_32(bytes, entry.offset);
  bytes += entry.name;
}

std::string ZipArchive::bytes() const {
  std::string directory;
  for (const Entry& entry : entries_) append_directory_entry(directory, entry);
  const auto count = static_cast<std::uint16_t>(entries_.size());
  std::string end;
  append_32(end, 0x06054b50);
  append_16(end, 0);  // number of this disk
  append_16(end, 0);  // disk of the directory
  append_16(end, count);
  append_16(end, count);
  append_32(end, size_32(directory.size()));
  append_32(end, size_32(files_.size()));
  append_16(end, 0);  // comment
  return files_ + directory + end;
}

}  // namespace trivet::exports
