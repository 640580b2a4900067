// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/target.h"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "trivet/foundation/file_writing.h"
#include "trivet/foundation/folder_handle.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/leftovers.h"
#include "trivet/project/rewritten_project.h"

namespace trivet::exports {
namespace {

namespace fs = std::filesystem;

/// Why a file must not be replaced; empty if it may be.
std::string reason_against(const fs::path& target, const fs::file_status& status) {
  if (fs::is_symlink(status)) return "this is a symbolic link, which is neither followed nor replaced; name the file";
  if (fs::is_directory(status)) return "this is a folder; name a file inside it";
  if (!fs::is_regular_file(status)) return "this is a pipe or a device";
  return project::is_project_file(target) ? "this is a project file; choose another name" : "";
}

std::string reason_against_folder(const fs::path& target, const fs::file_status& status) {
  std::error_code error;
  if (!fs::is_directory(status)) return "this is a file, and the format is a folder of files; choose another name";
  return fs::is_empty(target, error) && !error ? "" : "this folder is not empty; choose a new name";
}

}  // namespace

Target::Target(const fs::path& target, Kind kind) : kind_(kind) {
  const auto refuse = [&](const std::string& reason) {
    throw foundation::InvalidInput(fmt::format("{}: {}", target.string(), reason));
  };
  if (target.empty()) throw foundation::InvalidInput("-o \"\": the export needs a name");
  std::error_code error;
  target_ = fs::absolute(target, error);
  if (target_.filename().empty()) target_ = target_.parent_path();  // "folder/"
  const fs::file_status status = fs::symlink_status(target_, error);
  if (error && status.type() != fs::file_type::not_found) refuse(error.message());
  if (fs::exists(status))
    if (const std::string reason =
            kind == Kind::file ? reason_against(target_, status) : reason_against_folder(target_, status);
        !reason.empty())
      refuse(reason);
  if (!fs::is_directory(target_.parent_path(), error))
    refuse(fmt::format("there is no folder {}; create it, or choose another", target_.parent_path().string()));
  try {
    temporary_ = std::make_unique<foundation::TemporaryFolder>(target_.parent_path());
  } catch (const std::system_error& reason) {
    refuse(fmt::format("cannot write there: {}; choose a folder with write permission", reason.code().message()));
  }
  if (kind == Kind::folder) fs::create_directory(path());
}

fs::path Target::path() const { return temporary_->path() / target_.filename(); }
fs::path Target::beside(const std::string& name) const { return temporary_->path() / name; }

void Target::publish() const {
  const foundation::Undisturbed step;
  std::vector<fs::path> written;
  for (const fs::directory_entry& entry : fs::directory_iterator(temporary_->path()))
    if (entry.path().filename() != foundation::owner_mark && entry.path() != path()) written.push_back(entry.path());
  written.push_back(path());  // last: it shows that the others are there
  for (const fs::path& file : written) {
    std::error_code error;
    const fs::path to = target_.parent_path() / file.filename();
    fs::rename(file, to, error);
    if (error) throw std::runtime_error(fmt::format("cannot write {}: {}", to.string(), error.message()));
  }
}

void write_bytes(const fs::path& file, std::string_view bytes) {
  foundation::write_new_file(foundation::FolderHandle(file.parent_path()), file.filename().string(), std::string(bytes),
                             file);
}

}  // namespace trivet::exports
