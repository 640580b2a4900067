// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/response/frequency_grid.h"

namespace trivet::study {

/// Which answers of which quantity under which excitations.
struct Wanted {
  std::vector<std::string> of = {"coordinates"};
  assembly::Quantity quantity = assembly::Quantity::displacement;
  std::vector<std::string> excitations;  ///< empty: all

  bool operator==(const Wanted&) const = default;
};

struct ResponseRequest {
  Wanted wanted;
  std::optional<response::Band> band;  ///< none: from 0 to 1.3 times the highest natural frequency
  response::Spacing spacing = response::Spacing::automatic;
  int points = 1001;                   ///< of a linear or logarithmic grid
  std::vector<double> at;              ///< single ω instead of a band [rad/s]
  bool continuous_phase = false;
};

struct PeaksRequest {
  Wanted wanted;
  double min_prominence = 1e-6;
  double peak_tolerance = 0.01;  ///< prominence over the minimum beside a peak from which the design rule counts it
};

/// Largest allowed amplitude of one answer, SI.
struct Limit {
  std::string name;
  double amplitude = 0;
};

struct Analyses {
  bool modes = false;
  bool roots = false;
  std::optional<ResponseRequest> response;
  std::optional<PeaksRequest> peaks;
  std::optional<std::vector<std::string>> static_of;
  std::vector<Limit> limits;
};

}  // namespace trivet::study
