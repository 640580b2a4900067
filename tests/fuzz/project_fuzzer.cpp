// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: any bytes as a project file. Small models go on to their modes and roots.
#include <cstddef>
#include <cstdint>
#include <string>

#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/roots.h"
#include "trivet/study/project_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto project = trivet::study::project_from_text(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
  if (!project || project->base().system.bodies().size() > 2) return 0;
  try {
    const auto assembled = trivet::assembly::assemble(project->base().system);
    const auto modes = trivet::modal::modes(project->base().system, assembled);
    static_cast<void>(trivet::modal::roots(project->base().system, assembled, modes));
    static_cast<void>(trivet::study::results_json(*project, {}));
  } catch (const trivet::foundation::NotComputable&) {
  }
  return 0;
}
