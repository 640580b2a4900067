// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"

namespace trivet::project {

/// What of the results of `minimize` is made small: the largest amplitude over the band, the root mean square under the
/// random excitations, or the magnitude under gravity and constant forces. Or, instead of results, the price of the
/// chosen mounts, or the largest transmissibility of the required isolations as a share of the allowed one.
enum class Minimized { amplitude, rms, at_rest, price, isolation };

inline constexpr int usual_starts = 32;

/// The search for the best design: [analyses.optimize].
struct OptimizeRequest {
  std::vector<std::string> parameters;  ///< names in [parameters], of numbers and choices; empty: all
  std::vector<std::string> minimize;    ///< results with the amplitude to minimise over the band of the requirements;
                                        ///< empty: the largest least margin of the requirements
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;  ///< of these
  Minimized minimized = Minimized::amplitude;
  std::vector<double> weights;     ///< of these, for a sum of amplitudes; empty: the largest counts
  std::vector<std::string> front;  ///< two or three results between whose amplitudes the front is searched
  int points = 11;                 ///< of a front of two
  std::optional<int> starts;       ///< climbs; none: `usual_starts`, or fewer of designs that take long
  int combinations = 1000;         ///< most combinations of mounts whose numbers are optimised

  /// True if a parameter of this name is varied.
  [[nodiscard]] bool varies(const std::string& parameter) const {
    return parameters.empty() || std::ranges::find(parameters, parameter) != parameters.end();
  }
};

}  // namespace trivet::project
