// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <variant>
#include <vector>

#include "trivet/elements/law.h"
#include "trivet/elements/scalar_law.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/plausibility/rules.h"

namespace trivet::plausibility {

namespace {

/// A foundation with less than this share of the stiffness of its mount acts in place of the mount.
constexpr double softest = 1.0 / 30;
/// Lowest usual natural frequency of translation of machines on mounts [Hz]; a stiff joint on a flexible deck is usual.
constexpr double lowest_usual = 0.8;

/// Translational stiffness of one end with the other end fixed, in the axes of the ground [N/m].
Eigen::Matrix3d translation(const model::Element& element, const model::End& end, int first) {
  return end.axes * elements::stiffness(element.law).block<3, 3>(first, first) * end.axes.transpose();
}

/// Natural frequency of a body if all its mounts were on such springs [Hz].
double frequency_on(double stiffness, const BodyPicture& picture) {
  return std::sqrt(static_cast<double>(picture.attachments.size()) * stiffness / picture.mass.mass) /
      (2 * std::numbers::pi);
}

}  // namespace

void judge_foundations(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  std::map<std::size_t, const model::Element*> places;
  for (const model::Element& element : system.elements())
    if (model::joins_foundation_to_ground(element)) places[element.k.foundation->foundation] = &element;
  for (const model::Element& mount : system.elements()) {
    if (mount.is_foundation || !mount.n.foundation) continue;
    const auto place = places.find(mount.n.foundation->foundation);
    const auto picture = std::ranges::find(pictures, mount.k.body, &BodyPicture::body);
    if (place == places.end() || picture == pictures.end()) continue;
    const Eigen::Vector3d own = translation(mount, mount.n, 0).diagonal(),
                          below = translation(*place->second, place->second->k, 6).diagonal();
    for (int j = 0; j < 3; ++j) {
      if (!(below(j) > 0) || below(j) >= softest * own(j) || frequency_on(below(j), *picture) >= lowest_usual) continue;
      found.push_back({"stiffness", "foundations." + mount.name + ".translation",
                       fmt::format("{} along {}", foundation::prefixed_exactly(below(j), "N/m", 6), "xyz"[j]),
                       fmt::format("the mount \"{}\" on it has {}; on such springs alone \"{}\" would have {:.2g} Hz",
                                   mount.name, foundation::prefixed_exactly(own(j), "N/m", 6),
                                   system.bodies()[picture->body].name, frequency_on(below(j), *picture)),
                       fmt::format("it would be {} if the number was meant in N/mm",
                                   foundation::prefixed_exactly(1000 * below(j), "N/m", 6))});
      break;
    }
  }
}

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
  found.push_back({"gap", "elements." + wide.front()->name,
                   fmt::format("a gap of {}{}", foundation::prefixed_exactly(gap, "m", 6), others),
                   fmt::format("gaps of stops are mostly below {}", foundation::prefixed_exactly(unusual, "m", 6)),
                   fmt::format("it would be {} if a number without a unit was meant in millimetres",
                               foundation::prefixed_exactly(1e-3 * gap, "m", 6))});
}

}  // namespace trivet::plausibility
