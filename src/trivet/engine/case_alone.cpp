// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/case_alone.h"

namespace trivet::engine {

std::shared_ptr<const project::Project> case_alone(const project::Project& project, const project::Case& variant) {
  auto alone = std::make_shared<project::Project>();
  alone->title = project.title;
  alone->source = project.source;
  alone->folder = project.folder;
  alone->sha256 = project.sha256;
  alone->settings = project.settings;
  alone->parsed = project.parsed;
  project::Case& one = alone->cases.emplace_back(variant);
  one.analyses.optimize.reset();
  if (auto& requirements = one.analyses.requirements) requirements->hold_in = {one.name};
  return alone;
}

}  // namespace trivet::engine
