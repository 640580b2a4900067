// SPDX-License-Identifier: BSD-3-Clause
#include "cli/new_project_file.h"

#include <filesystem>
#include <stdexcept>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/rewritten_project.h"

namespace trivet::cli {
namespace {

namespace fs = std::filesystem;

/// Why a file must not be replaced; empty if it may be.
std::string refusal(const fs::path& earlier) {
  std::error_code error;
  if (fs::file_size(earlier, error) == 0 && !error) return "";
  return project::is_project_file(earlier) ? "" : "it exists and is not a project file; choose another name";
}

}  // namespace

NewProjectFile::NewProjectFile(const Options& options, const project::Project& project,
                               const std::vector<project::Node>& trial)
    : options_(options), project_(project) {
  if (options.write.empty()) return;
  if (const auto possible = text(trial); !possible) {
    problems_ = possible.error();
    return;
  }
  try {
    file_ = std::make_unique<results::WholeFile>(options.write, refusal);
  } catch (const foundation::InvalidInput& refused) {
    throw BadArgument(std::string("--write ") + refused.what());
  }
}

foundation::Expected<std::string> NewProjectFile::text(const std::vector<project::Node>& changes) const {
  return project::rewritten_project(project_, options_.settings, changes, options_.write);
}

std::string NewProjectFile::write(const std::vector<project::Node>& changes) const {
  if (!file_) return "";
  const auto content = text(changes);
  if (!content) throw std::runtime_error(foundation::message(content.error().list().front()));
  file_->publish(*content);
  return "\nWritten: " + options_.write + "\n";
}

}  // namespace trivet::cli
