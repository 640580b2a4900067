// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/input_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "trivet/project/text/source_file.h"
#include "trivet/project/unopened_text.h"

namespace trivet::project {
namespace {

namespace fs = std::filesystem;

void add_file(const std::string& name, const fs::path& path, std::vector<InputFile>& files) {
  std::error_code unreadable;
  if (std::ranges::find(files, name, &InputFile::name) != files.end() || !fs::is_regular_file(path, unreadable)) return;
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file) files.push_back({name, sha256(bytes)});
}

/// A matrix of CalculiX is in two files: the names of its rows are next to it.
void add_named_file(const FileName& named, std::vector<InputFile>& files) {
  add_file(named.text, named.file, files);
  const std::string ending = named.file.extension().string();
  if (ending == ".sti" || ending == ".mas")
    add_file(fs::path(named.text).replace_extension(".dof").string(), fs::path(named.file).replace_extension(".dof"),
             files);
}

}  // namespace

std::vector<InputFile> input_files(const Project& project) {
  std::vector<InputFile> files;
  if (!project.parsed) return files;
  const fs::path folder = folder_of_files(project);
  for (FileName& named : files_named_in_tables(project.parsed->text, project.source)) {
    if (!project.folder.empty()) named.file = folder / named.text;  // an absolute name replaces the folder
    add_named_file(named, files);
  }
  for (const FileName& named : files_named_in_settings(project.settings, folder)) add_named_file(named, files);
  return files;
}

std::string input_hash(const Project& project, const std::vector<InputFile>& files) {
  if (files.empty()) return project.sha256;
  std::string hashes = project.sha256 + "\n";
  for (const InputFile& file : files) hashes += file.sha256 + "\n";
  return sha256(hashes);
}

std::string input_hash(const Project& project) { return input_hash(project, input_files(project)); }

}  // namespace trivet::project
