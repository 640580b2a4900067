// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/project.h"

#include <algorithm>

namespace trivet::project {

std::filesystem::path folder_of_files(const Project& project) {
  if (!project.folder.empty()) return project.folder;
  const std::filesystem::path folder = std::filesystem::path(project.source).parent_path();
  return folder.empty() ? "." : folder;
}

const Case* Project::find(const std::string& name) const {
  const auto found = std::ranges::find(cases, name, &Case::name);
  return found == cases.end() ? nullptr : &*found;
}

}  // namespace trivet::project
