// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/scene/drawn_stops.h"

#include <cmath>

namespace trivet::results {
namespace {

/// The stops among laws over the same deflection.
std::vector<const elements::GapStop*> gap_stops(const elements::ScalarLaws& laws) {
  std::vector<const elements::GapStop*> stops;
  for (const elements::ScalarLaw& law : laws)
    if (const auto* force = std::get_if<elements::ElasticForce>(&law))
      if (const auto* stop = std::get_if<elements::GapStop>(force)) stops.push_back(stop);
  return stops;
}

/// Both sides of the stops. @param stop  of the upper side, without a gap @param deflection  at rest
void add_sides(const elements::ScalarLaws& laws, double deflection, const DrawnStop& stop,
               std::vector<DrawnStop>& list) {
  for (const elements::GapStop* law : gap_stops(laws))
    for (const double side : {1.0, -1.0}) {
      const double gap = side > 0 ? law->upper() - deflection : deflection - law->lower();
      if (!std::isfinite(gap)) continue;
      list.push_back(stop);
      list.back().gap = gap;
      if (stop.kind != DrawnStop::Kind::ring) list.back().direction *= side;
    }
}

}  // namespace

std::vector<DrawnStop> drawn_stops(const model::System& system) {
  std::vector<DrawnStop> list;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const spatial::Pose n = model::end_in_ground(system.bodies(), element.n),
                        k = model::end_in_ground(system.bodies(), element.k);
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      if (part.is_inner()) continue;
      const auto kind = part.is_rotation() ? DrawnStop::Kind::turn : DrawnStop::Kind::travel;
      const Eigen::Vector3d at = n.position + part.centre * (k.position - n.position);
      add_sides(part.laws, part.at_rest, {e, kind, at, k.rotation.col(part.axis % 3)}, list);
    }
    for (const model::DistancePart& part : element.distance_parts) {
      const double extension = part.law.distance(part.at_rest) - part.law.length;
      const auto kind = part.law.across ? DrawnStop::Kind::ring : DrawnStop::Kind::distance;
      const Eigen::Vector3d direction =
          k.rotation * (part.law.across ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : part.law.offset.normalized());
      add_sides(part.law.laws, extension, {e, kind, k.position, direction}, list);
    }
  }
  return list;
}

const char* word_of(DrawnStop::Kind kind) {
  switch (kind) {
    case DrawnStop::Kind::travel:
      return "travel";
    case DrawnStop::Kind::turn:
      return "turn";
    case DrawnStop::Kind::ring:
      return "ring";
    default:
      return "distance";
  }
}

}  // namespace trivet::results
