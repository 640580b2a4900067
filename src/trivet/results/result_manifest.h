// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "trivet/foundation/folder_handle.h"

namespace trivet::results {

/// The file of a result folder that names the files of Trivet in it.
inline constexpr const char* manifest_name = "manifest.json";

/// Which files of a result folder are Trivet's: those that have one of the listed contents. Everything else is the
/// user's.
class ResultManifest {
 public:
  /// Of a folder; nothing if there is no manifest in it, or one that cannot be understood.
  [[nodiscard]] static std::optional<ResultManifest> of(const foundation::FolderHandle& folder);

  /// @param path  "00-base/modes.csv", relative to the folder
  void add(const std::string& path, const std::string& content);
  void add(const ResultManifest& other) { files_.insert(other.files_.begin(), other.files_.end()); }
  [[nodiscard]] std::string text() const;

  [[nodiscard]] bool names(const std::string& path) const { return path == manifest_name || files_.contains(path); }
  /// Is this folder the place of a file that is listed?
  [[nodiscard]] bool names_folder(const std::string& path) const;
  /// Is it listed, and unchanged since? @param folder  that holds it  @param name  its name there
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
