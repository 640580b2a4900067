// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/judging/changed_case.h"
#include "trivet/modal/modes.h"
#include "trivet/project/model_number.h"
#include "trivet/response/steady/visible_amplitudes.h"
#include "trivet/spatial/mass_properties.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {

namespace {

constexpr std::array<double, 3> shares = {0, 0.47, 1};  // of both axes; 0.47 avoids a symmetric design in the middle
constexpr std::array<double, 3> frequencies = {0.0137, 0.117, 0.83};  // of the highest natural frequency
constexpr double unchanged = 1e-11;  // of an amplitude; round-off with another load or matrix is below it

/// Amplitudes at one design, channels × frequencies; amplitudes of round-off size are 0.
using Amplitudes = Eigen::Array<double, Eigen::Dynamic, static_cast<int>(frequencies.size())>;

std::vector<std::string> rule_channels(const std::vector<design::MapRule>& rules) {
  std::vector<std::string> names;
  for (const design::MapRule& rule : rules)
    if (std::ranges::find(names, rule.channel) == names.end()) names.push_back(rule.channel);
  return names;
}

Amplitudes amplitudes(const model::System& system, const project::MapRequest& request,
                      const std::vector<std::string>& names, double top) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const std::vector<assembly::Channel> channels =
      assembly::channels(system, assembled, names, assembly::MotionQuantity::displacement);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled, request.excitations);
  double from = 0, to = std::numeric_limits<double>::infinity();
  for (const assembly::ElementMap& map : assembled.elements)
    from = std::max(from, map.defined_from), to = std::min(to, map.defined_to);
  Amplitudes found(to_index(names.size()), to_index(frequencies.size()));
  for (std::size_t f = 0; f < frequencies.size(); ++f)
    found.col(to_index(f)) =
        response::visible_amplitudes(assembled, channels, loading, std::max(from, std::min(to, frequencies[f] * top)));
  return found;
}

bool differ(const Amplitudes& a, const Amplitudes& b) { return !((a - b).abs() <= unchanged * a.max(b)).all(); }

}  // namespace

AxisEffects axis_effects(const project::Case& variant, const project::MapRequest& request,
                         const std::vector<design::MapRule>& rules) {
  const std::vector<std::string> names = rule_channels(rules);
  const double top = modal::highest_natural_frequency(variant.system, assembly::assemble(variant.system));
  const project::ModelNumber x(request.x), y(request.y);
  std::array<std::array<Amplitudes, shares.size()>, shares.size()> designs;
  Amplitudes largest = Amplitudes::Zero(to_index(names.size()), to_index(frequencies.size()));
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (std::size_t j = 0; j < shares.size(); ++j) try {
        const auto system =
            judging::changed_system(variant, {{x, request.x.at(shares[i])}, {y, request.y.at(shares[j])}});
        if (!system) return {};
        designs[i][j] = amplitudes(*system, request, names, top);
        largest = largest.max(designs[i][j]);
      } catch (const foundation::NotComputable&) {
        return {};
      } catch (const foundation::InvalidInput&) {
        return {};
      }
  AxisEffects result{{}, false, false};
  for (std::size_t c = 0; c < names.size(); ++c)
    if (largest.row(to_index(c)).isZero(0)) result.zero_channels.push_back(names[c]);
  for (std::size_t k = 0; k < shares.size(); ++k)
    for (std::size_t i = 1; i < shares.size(); ++i) {
      result.by_x = result.by_x || differ(designs[0][k], designs[i][k]);
      result.by_y = result.by_y || differ(designs[k][0], designs[k][i]);
    }
  return result;
}

namespace {

/// Grid lines on both sides of a place, or the one through it.
std::vector<int> lines_around(double share, int points) {
  constexpr double on_it = 1e-9;
  const double place = share * (points - 1), nearest = std::round(place);
  if (std::abs(place - nearest) <= on_it * points) return {static_cast<int>(nearest)};
  return {static_cast<int>(std::floor(place)), static_cast<int>(std::floor(place)) + 1};
}

void warn_of_contradictions(const DesignMap& map, foundation::Problems& warnings) {
  for (const MapMark& mark : map.marks)
    if (contradicts(map, mark))
      warnings.warning("map: " + (mark.name.empty() ? std::string("base model") : mark.name),
                       mark.judged->governing.feasible()
                           ? "meets every rule, but all designs of the grid around it violate one"
                           : "violates a rule that all designs of the grid around it meet",
                       "the map is too coarse there, and its feasible share is unreliable",
                       "use more points, or narrower ranges around it");
}

void warn_of_band_crossings(const DesignMap& map, foundation::Problems& warnings) {
  const design::BandCrossings& found = map.band_crossings;
  if (found.pairs == 0) return;
  std::string points;
  for (const auto& [axis, needed] : {std::pair{&map.request.x, found.points[0]}, {&map.request.y, found.points[1]}})
    if (needed > 0) points += fmt::format("{}{} points along {}", points.empty() ? "" : " and ", needed, axis->name);
  warnings.warning(
      "map",
      fmt::format("between {} of neighbouring feasible designs a resonance crosses the band and violates a rule",
                  found.pairs == 1 ? "one pair" : fmt::format("{} pairs", found.pairs)),
      "the map is too coarse there, and its feasible share too large",
      fmt::format("use {}, or narrower ranges around it", points));
}

bool has_requirements(const DesignMap& map) {
  return std::ranges::any_of(
      map.rules, [](const design::MapRule& rule) { return rule.kind == design::DesignRule::Kind::requirement; });
}

/// Does a requirement change from one design to the next along an axis? Its margins show it, where it governs.
bool margins_change(const DesignMap& map, int along_x, int along_y) {
  for (int j = 0; j + along_y < map.grid.ny; ++j)
    for (int i = 0; i + along_x < map.grid.nx; ++i) {
      const design::DesignOutcome &a = map.outcomes[map.grid.index(i, j)],
                                  &b = map.outcomes[map.grid.index(i + along_x, j + along_y)];
      if (a.known() != b.known() || a.margin != b.margin || a.governing != b.governing) return true;
    }
  return false;
}

/// The effects on amplitudes, and on margins if the map judges requirements too.
AxisEffects effects_on_rules(const project::Case& variant, const DesignMap& map) {
  std::vector<design::MapRule> of_amplitudes = map.rules;
  std::erase_if(of_amplitudes,
                [](const design::MapRule& rule) { return rule.kind == design::DesignRule::Kind::requirement; });
  AxisEffects found =
      of_amplitudes.empty() ? AxisEffects{{}, false, false} : axis_effects(variant, map.request, of_amplitudes);
  if (of_amplitudes.size() == map.rules.size()) return found;
  found.by_x = found.by_x || margins_change(map, 1, 0);
  found.by_y = found.by_y || margins_change(map, 0, 1);
  return found;
}

void warn_of_idle(const project::Case& variant, const DesignMap& map, foundation::Problems& warnings) {
  const AxisEffects found = effects_on_rules(variant, map);
  for (const std::string& name : found.zero_channels)
    warnings.warning("map: " + name, "is zero except for round-off", "its rules have no effect",
                     "check the directions of forces and constraints, or remove the rules");
  const bool all_zero = std::ranges::all_of(map.rules, [&](const design::MapRule& rule) {
    return std::ranges::find(found.zero_channels, rule.channel) != found.zero_channels.end();
  });
  if (all_zero) return;
  for (const auto& [axis, changes] : {std::pair{&map.request.x, found.by_x}, {&map.request.y, found.by_y}})
    if (!changes)
      warnings.warning("map: " + axis->name, "no result changes along this axis",
                       has_requirements(map) ? "no rule depends on it in this map"
                                             : "the amplitudes of all rules are constant along it",
                       "choose a number that affects the results");
}

/// Warns of a range that may be in another unit than the number of the model.
void warn_of_another_scale(const project::Case& variant, const DesignMap& map, foundation::Problems& warnings) {
  constexpr double unlikely = 100;  // designs that differ this much are hardly of one machine
  for (const project::DesignAxis* axis : {&map.request.x, &map.request.y}) {
    const std::optional<double> own = project::ModelNumber(*axis).read(variant);
    if (!own || *own == 0) continue;
    const double low = std::min(std::abs(axis->from), std::abs(axis->to)),
                 high = std::max(std::abs(axis->from), std::abs(axis->to));
    if (std::abs(*own) <= unlikely * high && std::abs(*own) * unlikely >= low) continue;
    warnings.warning("map: " + axis->name, fmt::format("{:.6g} … {:.6g}", axis->from, axis->to),
                     fmt::format("the model itself has {:.6g}, far from all designs of the map", *own),
                     "check the unit of the range");
  }
}

/// Warns of ground motions given by velocity or acceleration: their displacement is unbounded at ω = 0.
void warn_of_drift(const project::Case& variant, const DesignMap& map, foundation::Problems& warnings) {
  if (map.request.band && map.request.band->from > 0) return;
  const auto unbounded = [&](const design::DesignOutcome& d) {
    return d.known() && d.margin == 0 && map.rules[d.governing].kind == design::DesignRule::Kind::amplitude;
  };
  if (!std::ranges::all_of(map.outcomes, [&](const design::DesignOutcome& d) { return !d.known() || unbounded(d); }))
    return;
  const auto first = std::ranges::find_if(map.outcomes, unbounded);
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  std::vector<std::string> names = map.request.excitations;
  if (names.empty())
    for (const model::Excitation& e : variant.system.description().excitations)
      if (std::holds_alternative<model::Harmonic>(e.course)) names.push_back(e.name);
  for (const std::string& name : names)
    if (const int power = assembly::harmonic_loading(variant.system, assembled, {name}).lowest_power(); power < 0)
      warnings.warning("map: excitations." + name,
                       fmt::format("{} is unbounded in every design", map.rules[first->governing].channel),
                       fmt::format("a foundation that moves with this {} has no bounded displacement at ω = 0",
                                   power == -1 ? "velocity" : "acceleration"),
                       "start the band of the map above 0");
}

void warn_of_unphysical(const project::Case& variant, foundation::Problems& warnings) {
  for (const model::Body& body : variant.system.bodies())
    if (body.allow_unphysical && !spatial::violated_bounds(body.mass).empty())
      warnings.warning("map: bodies." + body.name, "no real body has these numbers (allow_unphysical is set)",
                       "every design is doubtful", "correct mass and inertia before the map is used");
}

}  // namespace

bool contradicts(const DesignMap& map, const MapMark& mark) {
  if (!mark.placed() || !mark.of_this_model || !mark.judged) return false;
  const double x = map.request.x.share(*mark.x), y = map.request.y.share(*mark.y);
  if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) return false;
  const bool feasible = mark.judged->governing.feasible();
  for (const int j : lines_around(y, map.grid.ny))
    for (const int i : lines_around(x, map.grid.nx)) {
      const design::DesignOutcome& design = map.outcomes[map.grid.index(i, j)];
      if (!design.known() || design.feasible() == feasible) return false;
    }
  return true;
}

foundation::Problems map_warnings(const project::Case& variant, const DesignMap& map) {
  foundation::Problems warnings;
  warn_of_unphysical(variant, warnings);
  warn_of_contradictions(map, warnings);
  warn_of_band_crossings(map, warnings);
  warn_of_another_scale(variant, map, warnings);
  warn_of_idle(variant, map, warnings);
  warn_of_drift(variant, map, warnings);
  const foundation::Progress silent;
  warnings.add(missed_speed_warnings(CaseContext(variant.system, silent), variant.analyses));
  return warnings;
}

}  // namespace trivet::study
