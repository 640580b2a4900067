// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/suspension.h"

namespace trivet::study {

SuspensionResult suspension(const project::Case& variant, const std::vector<Eigen::Vector3d>& torques,
                            const std::vector<double>& excitations) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  const modal::Modes modes = modal::modes(variant.system, assembled);
  SuspensionResult result;
  for (std::size_t b = 0; b < variant.system.bodies().size(); ++b)
    if (!variant.system.bodies()[b].is_node)
      result.bodies.push_back(
          modal::body_suspension(variant.system, assembled, b, torques.empty() ? modal::body_axes() : torques));
  result.excitations = excitations;
  result.separation = modal::frequency_separation(modes, excitations);
  result.warnings = variant.warnings;
  result.warnings.add(modes.warnings);
  return result;
}

}  // namespace trivet::study
