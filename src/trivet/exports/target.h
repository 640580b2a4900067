// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/results/files/whole_file.h"

namespace trivet::exports {

/// A second file beside the first: NAME with this suffix instead of its extension. An earlier one is replaced only if
/// it is an export too, which its first line shows.
struct SideFile {
  std::string suffix;      ///< "_check.m"
  std::string first_line;  ///< without line end
};

/// Where an export goes: a file, perhaps with a file beside it, or a folder, which appears when it is complete, or not
/// at all. Formats write into a temporary folder.
class Target {
 public:
  enum class Kind { file, folder };

  /// Checked before anything is computed. A file may replace a file, but no project file; a folder must not exist, or
  /// be empty.
  /// @throws foundation::InvalidInput with the reason
  Target(const std::filesystem::path& target, Kind kind, const SideFile& side = {});
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  /// The file, or the folder, to write to.
  [[nodiscard]] std::filesystem::path path() const { return place_.temporary->path() / place_.path.filename(); }
  /// The file beside it to write to, if the format has one.
  [[nodiscard]] std::filesystem::path side() const { return place_.temporary->path() / side_.filename(); }

  /// Replaces what was there before; an earlier file beside it goes if no new one was written.
  /// @throws std::runtime_error with the reason; what was there before then stays
  void publish() const;

 private:
  results::TargetPlace place_;
  std::filesystem::path side_;  ///< where the file beside it appears; empty: none
};

/// Writes a whole file. @throws std::runtime_error with the reason
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace trivet::exports
