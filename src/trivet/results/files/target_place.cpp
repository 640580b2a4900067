// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/target_place.h"

#include <fmt/format.h>

#include <system_error>

#include "trivet/foundation/invalid_input.h"

namespace trivet::results {

namespace fs = std::filesystem;

namespace {

std::string reason_against(const fs::path& target, const fs::file_status& status, const Refusal& refusal) {
  if (fs::is_symlink(status))
    return "this is a symbolic link, which is neither followed nor replaced; name the file itself";
  if (!fs::is_regular_file(status) && !fs::is_directory(status)) return "this is a pipe or a device";
  return refusal(target, status);
}

}  // namespace

std::string reason_against_folder(const fs::file_status& status) {
  return fs::is_directory(status) ? "this is a folder; name a file inside it" : "";
}

TargetPlace target_place(const fs::path& target, const Refusal& refusal) {
  const auto refuse = [&](const std::string& reason) {
    throw foundation::InvalidInput(fmt::format("{}: {}", target.string(), reason));
  };
  std::error_code error;
  TargetPlace place{fs::absolute(target, error), nullptr};
  if (error) refuse(fmt::format("the current folder cannot be found ({})", error.message()));
  if (place.path.filename().empty()) place.path = place.path.parent_path();  // "folder/"
  const fs::file_status status = fs::symlink_status(place.path, error);
  if (error && status.type() != fs::file_type::not_found) refuse(error.message());
  if (fs::exists(status))
    if (const std::string reason = reason_against(place.path, status, refusal); !reason.empty()) refuse(reason);
  const fs::path folder = place.path.parent_path();
  if (!fs::is_directory(folder, error))
    refuse(fmt::format("there is no folder {}; create it, or choose another", folder.string()));
  try {
    place.temporary = std::make_unique<foundation::TemporaryFolder>(folder);
  } catch (const std::system_error& reason) {
    refuse(fmt::format("cannot write there: {}; choose a folder with write permission", reason.code().message()));
  }
  return place;
}

}  // namespace trivet::results
