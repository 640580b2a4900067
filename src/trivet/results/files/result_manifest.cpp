// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/result_manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "trivet/project/text/source_file.h"

namespace trivet::results {
namespace {

constexpr std::size_t largest_manifest = 64u << 20;  // 400,000 files

/// Does a path stay inside the folder?
bool stays_inside(const std::string& path) {
  std::size_t from = 0;
  while (from <= path.size()) {
    const std::size_t slash = std::min(path.find('/', from), path.size());
    const std::string part = path.substr(from, slash - from);
    if (part.empty() || part == "." || part == "..") return false;
    from = slash + 1;
  }
  return true;
}

}  // namespace

std::optional<ResultManifest> ResultManifest::read(const foundation::FolderHandle& folder) {
  const auto text = folder.content(manifest_name, largest_manifest);
  if (!text) return std::nullopt;
  const nlohmann::json json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object() || json.value("format", nlohmann::json()) != "trivet-manifest" || !json.contains("files") ||
      !json["files"].is_array())
    return std::nullopt;
  ResultManifest manifest;
  for (const auto& file : json["files"]) {
    const bool complete = file.is_object() && file.contains("path") && file["path"].is_string() &&
        file.contains("size") && file["size"].is_number_unsigned() && file.contains("sha256") &&
        file["sha256"].is_string();
    if (!complete || !stays_inside(file["path"])) return std::nullopt;
    manifest.files_.emplace(file["path"], Content{file["size"], file["sha256"]});
  }
  return manifest;
}

void ResultManifest::add(const std::string& path, const std::string& content) {
  files_.emplace(path, Content{content.size(), project::sha256(content)});
}

std::string ResultManifest::text() const {
  std::string text = "{\"format\":\"trivet-manifest\",\"version\":1,\"files\":[";
  bool first = true;
  for (const auto& [path, content] : files_) {
    text += std::string(first ? "" : ",") + "\n" +
        nlohmann::json{{"path", path}, {"size", content.size}, {"sha256", content.sha256}}.dump(
            -1, ' ', false, nlohmann::json::error_handler_t::replace);
    first = false;
  }
  return text + "\n]}\n";
}

bool ResultManifest::names_folder(const std::string& path) const {
  const auto next = files_.lower_bound(path + "/");
  return next != files_.end() && next->first.starts_with(path + "/");
}

bool ResultManifest::is_ours(const std::string& path, const foundation::FolderHandle& folder,
                             const std::string& name) const {
  if (path == manifest_name) return folder.kind(name) == foundation::FolderHandle::Kind::file;
  std::string found;
  for (auto [file, end] = files_.equal_range(path); file != end; ++file) {
    const auto content = folder.content(name, file->second.size);
    if (!content || content->size() != file->second.size) continue;
    if (found.empty()) found = project::sha256(*content);
    if (found == file->second.sha256) return true;
  }
  return false;
}

}  // namespace trivet::results
