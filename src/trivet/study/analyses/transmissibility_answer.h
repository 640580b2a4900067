// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/design/design_rules.h"
#include "trivet/project/analyses/transmissibility_question.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

struct TransmissibilityResult {
  std::string words;  ///< "force on the ground over engine", "motion over a motion of the ground along z"
  response::FrequencyResponse curves;
  response::Peaks peaks;
  std::vector<response::Crossover> crossovers;
  assembly::Band band;
  std::vector<design::LargestAmplitude> in_band;  ///< per curve
  bool of_force = false;  ///< forces on the ground, in total and of each mount; otherwise motions

  /// True for the force of one of several mounts over the whole exciting force: a share, not a measure of isolation.
  [[nodiscard]] bool is_share(std::size_t curve) const { return of_force && curve > 0 && curves.curves.size() > 2; }
};

/// Largest magnitude over the band of the question: of the total force on the ground, or of the first wanted motion.
/// @throws foundation::NotComputable, InvalidInput if the model does not have it
[[nodiscard]] double largest_transmissibility(const CaseContext& context,
                                              const project::TransmissibilityQuestion& asked);

}  // namespace trivet::study
