// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/target.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <system_error>

#include "trivet/foundation/files.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/project/rewritten_project.h"

namespace trivet::exports {
namespace {

namespace fs = std::filesystem;

std::string reason_against_file(const fs::path& target, const fs::file_status& status) {
  if (fs::is_directory(status)) return results::reason_against_folder(status);
  return project::is_project_file(target) ? "this is a project file; choose another name" : "";
}

std::string reason_against_full_folder(const fs::path& target, const fs::file_status& status) {
  std::error_code error;
  if (!fs::is_directory(status)) return "this is a file, and the format is a folder of files; choose another name";
  return fs::is_empty(target, error) && !error ? "" : "this folder is not empty; choose a new name";
}

bool begins_with_line(const fs::path& file, const std::string& line) {
  std::ifstream stream(file);
  std::string first;
  return std::getline(stream, first) && first == line;
}

fs::path checked_side(const fs::path& target, const SideFile& side) {
  if (side.suffix.empty()) return {};
  fs::path path = target.parent_path() / (target.stem().string() + side.suffix);
  if (path == target)
    throw foundation::InvalidInput(fmt::format("{}: a second file gets this name; choose another", target.string()));
  if (fs::exists(fs::symlink_status(path)) &&
      (!fs::is_regular_file(fs::symlink_status(path)) || !begins_with_line(path, side.first_line)))
    throw foundation::InvalidInput(
        fmt::format("{}: would be written beside {}, but it is there already and is no file of an export; move it, or "
                    "choose another name for the export",
                    path.string(), target.filename().string()));
  return path;
}

void rename_or_throw(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw std::runtime_error(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

}  // namespace

Target::Target(const fs::path& target, Kind kind, const SideFile& side) {
  if (target.empty()) throw foundation::InvalidInput("-o \"\": the export needs a name");
  place_ = results::target_place(target, kind == Kind::file ? reason_against_file : reason_against_full_folder);
  side_ = checked_side(place_.path, side);
  if (kind == Kind::folder) fs::create_directory(path());
}

void Target::publish() const {
  const foundation::Undisturbed step;
  const fs::path earlier = place_.temporary->path() / "earlier";
  const bool had_side = !side_.empty() && fs::exists(side_);
  if (had_side) rename_or_throw(side_, earlier);
  try {
    if (!side_.empty() && fs::exists(side())) rename_or_throw(side(), side_);
    rename_or_throw(path(), place_.path);  // last: it shows that the other is there
  } catch (const std::runtime_error&) {
    std::error_code ignored;
    if (!side_.empty()) fs::remove(side_, ignored);
    if (had_side) fs::rename(earlier, side_, ignored);
    throw;
  }
}

void write_bytes(const fs::path& file, std::string_view bytes) {
  foundation::write_new_file(foundation::FolderHandle(file.parent_path()), file.filename().string(), std::string(bytes),
                             file);
}

}  // namespace trivet::exports
