// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/map_requirements.h"

#include <algorithm>
#include <iterator>

#include "trivet/project/analyses/map_reader.h"

namespace trivet::project {

void use_requirements(Analyses& analyses) {
  if (!analyses.map) return;
  MapRequest& map = *analyses.map;
  if (!analyses.requirements) {  // clearances are judged in the band of the map
    Requirements& scope = map.requirements.emplace();
    scope.band = map.band;
    scope.excitations = map.excitations;
    return;
  }
  Requirements rest = *analyses.requirements;
  if (!map.limits_of_file && !map.own_band) map.band = rest.band;  // [requirements] takes that of the response
  std::copy_if(rest.hold_in.begin(), rest.hold_in.end(), std::back_inserter(map.hold_in),
               [](const std::string& name) { return !name.empty(); });
  if (map.limits.empty() && !map.own_no_peak) {  // nothing else needs the band and the excitations of the response
    if (!map.own_band) map.band = rest.band;
    if (!map.own_excitations) map.excitations = rest.excitations;
  }
  if (map.own_band) rest.band = map.band;
  if (map.own_excitations) rest.excitations = map.excitations;
  const bool same_load = map.excitations == rest.excitations;
  if (!map.limits_of_file) {
    rest.limits.clear();
  } else if (same_load && map.band == rest.band) {
    const auto own = std::ranges::stable_partition(rest.limits, [](const AmplitudeLimit& limit) {
                       return limit.has_common_scope();
                     }).begin();
    map.limits.insert(map.limits.end(), rest.limits.begin(), own);  // limits with their own band are judged separately
    rest.limits.erase(rest.limits.begin(), own);
  }
  if (map.own_no_peak) {
    rest.no_peak.clear();
  } else if (same_load) {
    map.no_peak = std::move(rest.no_peak);
    map.quantity = rest.quantity;
    if (!map.own_peak_shares) {
      map.min_prominence = rest.min_prominence;
      map.peak_tolerance = rest.peak_tolerance;
    }
    rest.no_peak.clear();
  }
  map.requirements = std::move(rest);  // even without a rule: clearances need its band and excitations
}

MapRequest map_of_case(const Analyses& of_case, const MapRequest& base) {
  Analyses analyses = of_case;
  MapRequest& map = analyses.map.emplace(base);
  map.requirements.reset();
  map.hold_in.clear();
  if (map.limits_of_file) map.limits.clear();
  if (!map.own_no_peak) map.no_peak.clear();
  use_limits_of_file(analyses);
  use_requirements(analyses);
  return map;
}

MapRequest MapRequest::of_pair(std::size_t pair) const {
  MapRequest one = *this;
  one.x = pairs.at(pair).first;
  one.y = pairs.at(pair).second;
  one.pairs.clear();
  return one;
}

}  // namespace trivet::project
