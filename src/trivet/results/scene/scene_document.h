// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/project/project.h"
#include "trivet/results/scene/drawn_machine.h"
#include "trivet/results/scene/drawn_stops.h"

namespace trivet::results {

/// What is drawn of a case.
struct Scene {
  DrawnMachine machine;
  std::vector<DrawnStop> stops;
};
[[nodiscard]] Scene scene_of(const project::Case& variant);

/// Everything that a program needs to draw the machine and to move it: docs/json.md, "scene".
[[nodiscard]] documents::Document scene_document(const project::Case& variant, const Scene& scene);

}  // namespace trivet::results
