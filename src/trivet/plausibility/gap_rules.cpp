// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "trivet/elements/scalar_law.h"
#include "trivet/plausibility/rules.h"

namespace trivet::plausibility {
namespace {

/// Of the stops of a law; 0 without any.
double largest_gap(const elements::ScalarLaws& laws) {
  double largest = 0;
  for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(laws))
    if (const auto* stop = std::get_if<elements::GapStop>(&law))
      for (const double gap : {stop->gap_above, stop->gap_below})
        if (std::isfinite(gap)) largest = std::max(largest, gap);
  return largest;
}

/// The travel of coil springs until their coils touch follows from their dimensions, and the gaps of struts are counted
/// from their free length: both may be long.
double largest_gap(const model::Element& element) {
  double largest = 0;
  if (element.type == "coil_spring") return largest;
  for (const model::NonlinearPart& part : element.nonlinear_parts)
    if (!part.is_rotation() && !part.is_inner()) largest = std::max(largest, largest_gap(part.laws));
  for (const model::DistancePart& part : element.distance_parts)
    if (part.law.across) largest = std::max(largest, largest_gap(part.law.laws));
  return largest;
}

}  // namespace

void judge_gaps(const model::System& system, Suspicions& found) {
  constexpr double unusual = 0.2;  // [m]
  std::vector<const model::Element*> wide;
  for (const model::Element& element : system.elements())
    if (largest_gap(element) > unusual) wide.push_back(&element);
  if (wide.empty()) return;
  const double gap = largest_gap(*wide.front());
  const std::string others = wide.size() > 1 ? fmt::format(", and {} more", wide.size() - 1) : "";
  found.push_back(
      {"gap", "elements." + wide.front()->name, fmt::format("a gap of {:.6g} m{}", gap, others),
       fmt::format("gaps of stops are mostly below {:.6g} m", unusual),
       fmt::format("it would be {:.6g} m if a number without a unit was meant in millimetres", 1e-3 * gap)});
}

}  // namespace trivet::plausibility
