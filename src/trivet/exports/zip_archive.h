// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trivet::exports {

/// A ZIP archive in memory. Its bytes depend only on names, contents and their order: all files have the same date.
class ZipArchive {
 public:
  /// Adds a file, compressed if that makes it smaller.
  /// @param name  path in UTF-8 with slashes, relative, unique
  /// @throws foundation::InvalidInput if the name is not such a path, or the archive would need more than 4 GB or 65535
  /// files
  void add(const std::string& name, std::string_view content);

  /// The whole archive. @throws foundation::InvalidInput if it needs more than 4 GB
  [[nodiscard]] std::string bytes() const;

 private:
  struct Entry {
    std::string name;
    std::uint16_t method = 0;
    std::uint32_t crc = 0, compressed_size = 0, size = 0, offset = 0;
  };
  static void append_common_header(std::string& bytes, const Entry& entry);
  static void append_directory_entry(std::string& bytes, const Entry& entry);

  std::string files_;  ///< headers and contents
  std::vector<Entry> entries_;
};

}  // namespace trivet::exports
