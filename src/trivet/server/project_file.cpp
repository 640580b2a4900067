// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/project_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "trivet/foundation/files.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/project/text/source_file.h"

namespace trivet::server {

namespace fs = std::filesystem;

std::string version_of(const std::string& text) { return project::sha256(text); }

FileState read_state(const std::string& file) {
  foundation::Expected<std::string> bytes = project::read_bytes(file);
  if (!bytes) {
    std::error_code error;
    const bool exists = fs::exists(file, error);
    return {.version = exists ? version_of(foundation::message(bytes.error().list().front())) : "",
            .problems = std::move(bytes.error())};
  }
  FileState state{.version = project::is_blank(*bytes) ? "" : version_of(*bytes),
                  .problems = project::source_problems(*bytes, file)};
  if (!state.problems.has_errors()) state.problems = project::encoding_problems(*bytes, file);
  if (!state.problems.has_errors()) state.text = std::move(*bytes);
  return state;
}

void replace_text(const std::string& file, const std::string& text) {
  const auto refuse = [&](const std::string& reason) {
    throw std::runtime_error(fmt::format("{} cannot be saved: {}", file, reason));
  };
  std::error_code error;
  const fs::path target = fs::weakly_canonical(file, error);
  if (error) refuse(error.message());
  const fs::file_status status = fs::status(target, error);
  const bool exists = fs::exists(status);
  if (exists && !fs::is_regular_file(status)) refuse("it is no regular file");
  if (exists && access(target.c_str(), W_OK) != 0) refuse(std::strerror(errno));
  try {
    const foundation::TemporaryFolder temporary(target.parent_path());
    foundation::write_new_file(foundation::FolderHandle(temporary.path()), "project", text, target);
    if (exists) fs::permissions(temporary.path() / "project", status.permissions());
    const foundation::Undisturbed step;
    fs::rename(temporary.path() / "project", target);
  } catch (const std::system_error& reason) {
    refuse(reason.code().message());
  }
}

}  // namespace trivet::server
