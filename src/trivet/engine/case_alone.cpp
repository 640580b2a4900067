// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/case_alone.h"

namespace trivet::engine {

std::shared_ptr<const project::Project> case_alone(const project::Project& project, const project::Case& variant) {
  auto alone = std::make_shared<project::Project>(project);
  alone->cases = {variant};
  project::Case& one = alone->cases.front();
  one.analyses.optimize.reset();
  if (auto& requirements = one.analyses.requirements) requirements->hold_in = {one.name};
  return alone;
}

}  // namespace trivet::engine
