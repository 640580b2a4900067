// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <ranges>
#include <string>
#include <vector>

#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/plausibility/rules.h"

namespace trivet::plausibility {
namespace {

/// A place this many times as far from the centre of mass as all others, and as the size of the body, is a slip.
constexpr double far = 100;

struct NamedPlace {
  std::string subject;
  double distance;  ///< from the centre of mass [m]
};

std::vector<NamedPlace> points_and_forces(const model::System& system, std::size_t b) {
  const model::Body& body = system.bodies()[b];
  std::vector<NamedPlace> places;
  const auto add = [&](const std::string& subject, const Eigen::Vector3d& at) {
    places.push_back({subject, (at - body.mass.centre).norm()});
  };
  for (const model::Point& point : body.points) add("bodies." + body.name + ".points." + point.name, point.at);
  for (const model::Excitation& excitation : system.description().excitations)
    if (excitation.action.body == b) add("excitations." + excitation.name + ".at", excitation.action.at);
  return places;
}

}  // namespace

void judge_far_points(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  for (const BodyPicture& picture : pictures) {
    std::vector<NamedPlace> places = points_and_forces(system, picture.body);
    if (places.empty()) continue;
    std::ranges::sort(places, {}, &NamedPlace::distance);
    constexpr double same = 1 - 1e-9;  // a force often acts at a point
    const double farthest = places.back().distance;
    const auto first_far =
        std::ranges::find_if(places, [&](const NamedPlace& one) { return one.distance >= same * farthest; });
    double others = 2 * mass_radius(picture.mass);
    if (first_far != places.begin()) others = std::max(others, std::prev(first_far)->distance);
    for (const Attachment& one : picture.attachments) others = std::max(others, (one.at - picture.mass.centre).norm());
    if (!(others > 0) || farthest < far * others) continue;
    for (const NamedPlace& one : std::ranges::subrange(first_far, places.end()))
      found.push_back(
          {"points", one.subject,
           fmt::format("{} from the centre of mass", foundation::prefixed_exactly(one.distance, "m", 5)),
           fmt::format("everything else of \"{}\" is within {} of it", system.bodies()[picture.body].name,
                       foundation::prefixed(others, "m")),
           fmt::format("write its place with a unit: {:.4g} mm are {:.4g} m", one.distance, one.distance / 1000)});
  }
}

}  // namespace trivet::plausibility
