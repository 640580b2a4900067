// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/design_summary.h"

#include <algorithm>

#include "trivet/assembly/assembled.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/modes.h"
#include "trivet/modal/suspension.h"

namespace trivet::study {

DesignSummary design_summary(const model::System& system) {
  const assembly::Assembled assembled = assembly::assemble(system);
  DesignSummary summary;
  for (const modal::Mode& mode : modal::modes(system, assembled).list)
    if (mode.angular_frequency.value_or(0) > 0) summary.angular_frequencies.push_back(*mode.angular_frequency);
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const model::Body& body = system.bodies()[b];
    if (body.is_node || std::ranges::count(body.free, true) < 2) continue;  // one is never coupled
    try {
      const std::vector<modal::BodyMode> modes = modal::body_suspension(system, assembled, b).modes;
      double least = 1;
      for (const modal::BodyMode& mode : modes) least = std::min(least, mode.decoupling());
      if (!modes.empty()) summary.decoupling.push_back({body.name, least});
    } catch (const foundation::NotComputable&) {  // this body is left out, not the design
    }
  }
  return summary;
}

}  // namespace trivet::study
