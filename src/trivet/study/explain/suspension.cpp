// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/suspension.h"

namespace trivet::study {

SuspensionAnswer suspension(const project::Case& variant, const std::vector<Eigen::Vector3d>& torques,
                            const std::vector<double>& excitations) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  const modal::Modes modes = modal::modes(variant.system, assembled);
  SuspensionAnswer answer;
  for (std::size_t b = 0; b < variant.system.bodies().size(); ++b)
    if (!variant.system.bodies()[b].is_node)
      answer.bodies.push_back(
          modal::body_suspension(variant.system, assembled, b, torques.empty() ? modal::body_axes() : torques));
  answer.excitations = excitations;
  answer.separation = modal::frequency_separation(modes, excitations);
  answer.warnings = variant.warnings;
  answer.warnings.add(modes.warnings);
  return answer;
}

}  // namespace trivet::study
