// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "trivet/plausibility/rules.h"

namespace trivet::plausibility {
namespace {

/// The largest gap of the stops of a law, as it was given.
std::optional<double> largest_gap(const elements::ScalarLaws& laws) {
  std::optional<double> largest;
  for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(laws))
    if (const auto* stop = std::get_if<elements::GapStop>(&law))
      for (const double gap : {stop->gap_above, stop->gap_below})
        if (std::isfinite(gap)) largest = std::max(gap, largest.value_or(gap));
  return largest;
}

}  // namespace

void judge_gaps(const model::System& system, Suspicions& found) {
  constexpr double unusual = 0.2;  // [m]
  for (const model::Element& element : system.elements()) {
    std::optional<double> gap;
    const auto note = [&](const elements::ScalarLaws& laws) {
      if (const std::optional<double> own = largest_gap(laws)) gap = std::max(*own, gap.value_or(*own));
    };
    for (const model::NonlinearPart& part : element.nonlinear_parts)
      if (!part.is_rotation() && !part.is_inner()) note(part.laws);
    for (const model::DistancePart& part : element.distance_parts) note(part.law.laws);
    if (!gap || !(*gap > unusual)) continue;
    found.push_back({"gap", "elements." + element.name, fmt::format("a gap of {:.6g} m", *gap),
                     "machines touch their stops within 0.2 m",
                     fmt::format("it would be {:.6g} m if the number was meant in millimetres", 1e-3 * *gap)});
  }
}

}  // namespace trivet::plausibility
