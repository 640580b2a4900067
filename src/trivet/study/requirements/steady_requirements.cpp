// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/branch/stable_motions.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/level_crossings.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

using foundation::infinity;
using nonlinear::stable_points;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

/// A stop, with its gaps from rest; or one of a strut or a ring, over three deflections.
struct Stop {
  std::string element;
  std::size_t deflection;
  double above, below;
  const model::DistancePart* distance = nullptr;
};

/// Travel over gap.
double of_gap(double travel, double gap) {
  if (std::isinf(gap) || travel <= 0) return gap > 0 ? 0.0 : infinity;
  return gap > 0 ? travel / gap : infinity;
}

/// The largest share of the gaps that the distance between the ends uses: of a ring from its axis, of a strut from
/// rest.
double share_of_distance(const SteadyPoint& point, const Stop& stop) {
  const elements::DistanceForce& law = stop.distance->law;
  const double from = law.across ? 0 : law.distance(stop.distance->at_rest);
  if (law.across && law.distance(stop.distance->at_rest) >= stop.above) return infinity;  // it is closed at rest
  const Eigen::MatrixXd motion = point.deflections.middleCols(to_index(stop.deflection), 3);
  // The square of the distance has twice the harmonics, exactly.
  const Eigen::Index harmonics = (motion.rows() - 1) / 2, samples = 4 * harmonics + 2;
  Eigen::VectorXd square = Eigen::VectorXd::Zero(numerics::coefficient_count(2 * harmonics));
  for (Eigen::Index n = 0; n < samples; ++n) {
    const Eigen::RowVectorXd row = numerics::fourier_row(
        2 * harmonics, foundation::two_pi * static_cast<double>(n) / static_cast<double>(samples));
    const Eigen::Vector3d deviation = (row.head(motion.rows()) * motion).transpose();
    square += 2 * std::pow(law.distance(stop.distance->at_rest + deviation), 2) / static_cast<double>(samples) *
        row.transpose();
  }
  square(0) /= 2;
  const auto [low, high] = numerics::range_of_motion(square);
  return std::max(of_gap(std::sqrt(high) - from, stop.above), of_gap(from - std::sqrt(std::max(low, 0.0)), stop.below));
}

std::vector<Stop> stops_of(const model::System& system) {
  std::vector<Stop> stops;
  std::size_t deflection = 0;
  for (const model::Element& element : system.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(part.laws))
        if (const auto* stop = std::get_if<elements::GapStop>(&law); stop && !part.is_inner())
          stops.push_back({element.name, deflection, stop->upper() - part.at_rest, part.at_rest - stop->lower()});
      ++deflection;
    }
  for (const model::Element& element : system.elements())
    for (const model::DistancePart& part : element.distance_parts) {
      const double rest = part.law.across ? 0 : part.law.distance(part.at_rest) - part.law.length;
      for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(part.law.laws))
        if (const auto* stop = std::get_if<elements::GapStop>(&law))
          stops.push_back({element.name, deflection, stop->upper() - rest, rest - stop->lower(), &part});
      deflection += 3;
    }
  return stops;
}

project::SteadyAnalysis steady_request(const project::Analyses& analyses) {
  const auto& of_file = analyses.steady;
  const project::Requirements& required = *analyses.requirements;
  const bool has_band = required.band && required.band->from > 0 && std::isfinite(required.band->to);
  if (of_file && of_file->over_load_factor && !has_band)
    throw foundation::InvalidInput(
        "analyses.steady is over the load factor; requirements are judged over the frequency: give them a band");
  project::SteadyAnalysis request = of_file && !of_file->over_load_factor ? *of_file : project::SteadyAnalysis();
  if (has_band) request.band = required.band;
  if (!required.excitations.empty()) request.selection.excitations = required.excitations;
  request.selection.of.clear();
  return request;
}

void set_contacts(const SteadyBranch& branch, const std::vector<Stop>& stops, std::size_t first,
                  RequirementList& list) {
  for (std::size_t i = 0; i < stops.size(); ++i) {
    RequirementResult& result = list[first + i];
    double share = 0;
    for (const SteadyPoint* point : stable_points(branch)) {
      double here = 0;
      if (stops[i].distance) {
        here = share_of_distance(*point, stops[i]);
      } else {
        const auto [low, high] = numerics::range_of_motion(point->deflections.col(to_index(stops[i].deflection)));
        here = std::max(of_gap(high, stops[i].above), of_gap(-low, stops[i].below));
      }
      if (here <= share) continue;
      share = here;
      result.angular_frequency = point->angular_frequency;
    }
    result.value = share;
    result.margin = std::isinf(share) ? 0 : margin_of(1, share);
  }
}

/// "the stability of 3 of 120 motions is uncertain", those of further curves included; empty if none is.
std::string uncertain_stability(const SteadyBranch& branch) {
  std::ptrdiff_t uncertain = 0, all = 0;
  const auto add = [&](const SteadyBranch& curve) {
    uncertain += std::ranges::count_if(curve.points, &SteadyPoint::uncertain);
    all += std::ssize(curve.points);
  };
  add(branch);
  for (const SteadyBranch& curve : branch.further) add(curve);
  return uncertain > 0 ? fmt::format("the stability of {} of {} motions is uncertain", uncertain, all) : "";
}

void set_jumps(const SteadyBranch& branch, RequirementResult& result) {
  const bool always_stable =
      std::ranges::all_of(branch.points, [](const SteadyPoint& point) { return point.stable || point.uncertain; });
  std::size_t jumps = std::max<std::size_t>(branch.folds.size() + branch.changes.size(), always_stable ? 0 : 1);
  const std::vector<const SteadyBranch*> detached = branch.further_ones(SteadyBranch::Found::detached);
  for (const SteadyBranch* curve : detached)
    if (!stable_points(*curve).empty()) jumps += std::max<std::size_t>(curve->folds.size(), 1);
  result.value = static_cast<double>(jumps);
  result.margin = jumps == 0 ? infinity : 0;
  if (!branch.folds.empty()) result.angular_frequency = branch.folds.front().point.angular_frequency;
  else if (!branch.changes.empty()) result.angular_frequency = branch.changes.front().point.angular_frequency;
  result.detail = always_stable ? "" : "some motions are unstable; ";
  result.detail += detached.empty() ? "no detached motions found, which is no proof that there are none"
                                    : fmt::format("detached curves of motions: {}", detached.size());
}

/// What the verdict does not know: it holds for the motions that were found, and none is known in some stretches.
void add_limits(const SteadyBranch& branch, const foundation::Problems& doubts, RequirementResult& result) {
  const auto add = [&](const std::string& words) { result.detail += (result.detail.empty() ? "" : "; ") + words; };
  if (result.kind == RequirementKind::no_contact && result.value && std::isinf(*result.value))
    add("the stop is closed at rest already");
  else if (!branch.search && result.kind != RequirementKind::no_jump)
    add("motions connected with the lower end of the band only; branches = \"all\" of steady seeks others");
  for (const foundation::Problem& doubt : doubts.list()) add(doubt.finding);
  const auto in_hertz = [](const std::vector<std::pair<double, double>>& stretches) {
    std::string text;
    for (const auto& [from, to] : stretches)
      text += fmt::format("{}{:.5g} to {:.5g}", text.empty() ? "" : ", ", from / foundation::two_pi,
                          to / foundation::two_pi);
    return text;
  };
  std::vector<std::string> gaps;  // in what is known
  if (!branch.ended.empty()) gaps.push_back("steady motion: " + branch.ended);
  if (std::string uncertain = uncertain_stability(branch); !uncertain.empty()) gaps.push_back(std::move(uncertain));
  if (const auto without = nonlinear::without_stable_motion(branch); !without.empty())
    gaps.push_back(fmt::format(
        "no periodic motion is known to be stable from {} Hz; what happens there is not computed", in_hertz(without)));
  if (const auto lost = nonlinear::quasi_periodic_stretches(branch); !lost.empty())
    gaps.push_back(fmt::format(
        "a motion has lost its stability to quasi-periodic ones from {} Hz, which are not computed", in_hertz(lost)));
  if (gaps.empty()) return;
  const std::string unknown = fmt::format("{}", fmt::join(gaps, "; "));
  const bool is_violated = result.margin < 1;
  if (is_violated) {
    add(unknown);
    return;
  }
  result.value.reset();
  result.angular_frequency.reset();
  result.margin = 0;
  result.reason = unknown;
}

}  // namespace

void add_steady_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list) {
  if (!analyses.requirements || !analyses.requirements->is_about_steady_motion()) return;
  const project::Requirements& required = *analyses.requirements;
  const std::size_t first = list.size();
  const std::vector<Stop> stops = required.no_contact ? stops_of(context.system) : std::vector<Stop>();
  if (required.no_jump) list.add(RequirementKind::no_jump, "", "no jumps of the steady motion", "1", 0);
  for (const Stop& stop : stops)
    list.add(RequirementKind::no_contact, stop.element, {stop.element + " untouched: travel", "≤ gap"}, "1", 1);
  const std::size_t bounds = list.size();
  list.add_bounds(context, RequirementKind::steady, required.steady, "steady ");
  list.attempt(first, [&] {
    project::SteadyAnalysis request = steady_request(analyses);
    std::vector<assembly::MotionQuantity> quantities;
    for (const project::AmplitudeLimit& limit : required.steady) {
      request.selection.of.push_back(limit.name);
      quantities.push_back(limit.quantity);
    }
    request.all_branches = request.all_branches || (required.no_jump && !required.connected_only);
    const SteadyBranch branch = steady_motions(context, request, quantities);
    foundation::Problems doubts;
    warn_of_motions(context, request, branch, doubts);
    if (required.no_jump) set_jumps(branch, list[first]);
    set_contacts(branch, stops, first + (required.no_jump ? 1 : 0), list);
    for (std::size_t i = 0; i < required.steady.size(); ++i) {
      RequirementResult& result = list[bounds + i];
      double largest = 0;
      for (const SteadyPoint* point : stable_points(branch)) {
        const nonlinear::ObservedMotion& motion = point->results[i];
        const double here = std::max(motion.largest, -motion.smallest);
        if (!std::isfinite(here))
          throw foundation::NotComputable(fmt::format("steady motion: {} is no number at {:.6g} Hz",
                                                      required.steady[i].name,
                                                      point->angular_frequency / foundation::two_pi));
        if (here <= largest) continue;
        largest = here;
        result.angular_frequency = point->angular_frequency;
      }
      result.value = largest;
      result.margin = margin_of(result.allowed, largest);
      result.quantity = required.steady[i].quantity;
      if (request.band) result.band = *request.band;
    }
    for (std::size_t i = first; i < list.size(); ++i) add_limits(branch, doubts, list[i]);
  });
}

}  // namespace trivet::study
