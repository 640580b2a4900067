// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/new_project_file.h"

#include <filesystem>
#include <stdexcept>

#include "trivet/engine/key_reader.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/rewritten_project.h"

namespace trivet::engine {
namespace {

namespace fs = std::filesystem;

/// Why a file must not be replaced; empty if it may be.
std::string refusal(const fs::path& earlier) {
  std::error_code error;
  if (fs::file_size(earlier, error) == 0 && !error) return "";
  return project::is_project_file(earlier) ? "" : "it exists and is not a project file; choose another name";
}

}  // namespace

NewProjectFile::NewProjectFile(const Task& task, const std::vector<project::Node>& trial)
    : project_(*task.project), settings_(task.settings), target_(task.keys.text("write")) {
  if (target_.empty()) return;
  if (const auto possible = text(trial); !possible) {
    problems_ = possible.error();
    return;
  }
  try {
    file_ = std::make_unique<results::WholeFile>(target_, refusal);
  } catch (const foundation::InvalidInput& refused) {
    throw foundation::InvalidInput(task.keys.written("write") + " " + refused.what());
  }
}

foundation::Expected<std::string> NewProjectFile::text(const std::vector<project::Node>& changes) const {
  return project::rewritten_project(project_, settings_, changes, target_);
}

std::string NewProjectFile::write(const std::vector<project::Node>& changes, Result& result) const {
  if (!file_) return "";
  try {
    const auto content = text(changes);
    if (!content) throw std::runtime_error(foundation::message(content.error().list().front()));
    file_->publish(*content);
  } catch (const std::runtime_error& reason) {
    result.add_not_written(reason.what());
    return "";
  }
  return "\nWritten: " + target_ + "\n";
}

}  // namespace trivet::engine
