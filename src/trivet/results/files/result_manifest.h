// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "trivet/foundation/files.h"

namespace trivet::results {

/// The file of a result folder that names the files of Trivet in it.
inline constexpr const char* manifest_name = "manifest.json";

/// List of Trivet's files in a result folder: those with one of the listed contents. All other files are the user's.
class ResultManifest {
 public:
  /// Manifest of a folder; empty if there is none or it cannot be read.
  [[nodiscard]] static std::optional<ResultManifest> read(const foundation::FolderHandle& folder);

  /// @param path  "00-base/modes.csv", relative to the folder
  void add(const std::string& path, const std::string& content);
  void add(const ResultManifest& other) { files_.insert(other.files_.begin(), other.files_.end()); }
  [[nodiscard]] std::string text() const;

  [[nodiscard]] bool names(const std::string& path) const { return path == manifest_name || files_.contains(path); }
  /// Is a file in this folder listed?
  [[nodiscard]] bool names_folder(const std::string& path) const;
  /// Is the file listed and unchanged? @param folder  folder of the file  @param name  its name there
  [[nodiscard]] bool is_ours(const std::string& path, const foundation::FolderHandle& folder,
                             const std::string& name) const;

  struct Content {
    std::uintmax_t size;
    std::string sha256;
  };
  /// By path; a path may have two contents while files are replaced one by one.
  [[nodiscard]] const std::multimap<std::string, Content>& files() const { return files_; }

 private:
  std::multimap<std::string, Content> files_;
};

}  // namespace trivet::results
