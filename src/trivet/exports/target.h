// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "trivet/foundation/temporary_folder.h"

namespace trivet::exports {

/// Where an export goes: a file or a folder that appears when it is complete, or not at all. Formats write into a
/// temporary folder beside it.
class Target {
 public:
  enum class Kind { file, folder };

  /// Checked before anything is computed. A file may replace a file, but no project file; a folder must not exist, or
  /// be empty.
  /// @throws foundation::InvalidInput with the reason
  Target(const std::filesystem::path& target, Kind kind);
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  /// The file, or the folder, to write to. Files beside it, named by `beside`, are published with it.
  [[nodiscard]] std::filesystem::path path() const;
  /// A further file in the folder of the target: "check.m".
  [[nodiscard]] std::filesystem::path beside(const std::string& name) const;

  /// @throws std::runtime_error with the reason; what was there before then stays
  void publish() const;

 private:
  std::filesystem::path target_;
  Kind kind_;
  std::unique_ptr<foundation::TemporaryFolder> temporary_;
};

/// Writes a whole file. @throws std::runtime_error with the reason
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace trivet::exports
