// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/response/machinery/transmissibility.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::study {

struct TransmissibilityResult {
  std::string words;  ///< "force on the ground over engine", "motion over a motion of the ground along z"
  response::FrequencyResponse curves;
  response::Peaks peaks;
  std::vector<response::Crossover> crossovers;
  response::Band band;
  bool of_force = false;  ///< forces on the ground, in total and of each mount; otherwise motions

  /// True for the force of one of several mounts over the whole exciting force: a share, not a measure of isolation.
  [[nodiscard]] bool is_share(std::size_t curve) const { return of_force && curve > 0 && curves.curves.size() > 2; }
};

}  // namespace trivet::study
