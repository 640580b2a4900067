// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/design_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/changed_case.h"
#include "trivet/modal/modes.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/study/family/packed_margins.h"

namespace trivet::study {
namespace {

using design::DesignOutcome;
using design::DesignPoint;
using design::DesignRule;

DesignOutcome outcome_of(const design::Governing& least) {
  return {design::rounded_margin(least.margin), static_cast<std::uint8_t>(least.rule)};
}

/// Counts one natural frequency of a design that is below or in the band of the amplitudes.
void count_mode(double squared, const assembly::Band& band, DesignOutcome& outcome) {
  if (squared < band.from * band.from)
    outcome.modes_below += outcome.modes_below < std::numeric_limits<std::uint16_t>::max();
  else if (squared <= band.to * band.to)
    outcome.modes_in_band += outcome.modes_in_band < std::numeric_limits<std::uint8_t>::max();
}

constexpr std::size_t assembled_piece =
    1;  // a design takes milliseconds, and a step of the boundary search has few designs
/// Designs whose matrices fit in the cache; 15 lines of it for each number, so that they do not displace each other.
constexpr std::size_t lane_piece = 120;

/// Frequency range in which differences of K, B and A of two systems show: three decades up to the highest natural
/// frequency, within the range of the tables.
assembly::Band compared_range(const assembly::Assembled& a, const assembly::Assembled& b, double natural_frequency) {
  constexpr double decades = 1e-3, least = 10;  // least: one decade, if tables start above the range
  assembly::Band range{decades * natural_frequency, std::numeric_limits<double>::infinity()};
  for (const assembly::Assembled* assembled : {&a, &b})
    for (const assembly::ElementMap& map : assembled->elements)
      range = {std::max(range.from, map.defined_from), std::min(range.to, map.defined_to)};
  range.to = std::min(range.to, std::max(natural_frequency, least * range.from));
  return range;
}

/// One design per row.
Eigen::MatrixXd rows_of(const std::vector<DesignPoint>& points) {
  Eigen::MatrixXd rows(to_index(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i) rows.row(to_index(i)) << points[i].x, points[i].y;
  return rows;
}

std::string amplitude_words(const std::string& name, double amplitude, const std::string& unit) {
  return fmt::format("{} ≤ {:.6g} {}", name, amplitude, unit);
}

}  // namespace

DesignEvaluation::DesignEvaluation(const project::Case& variant, const project::MapRequest& request,
                                   const design::EvaluationOptions& options,
                                   const std::vector<RequirementResult>& frequencies)
    : case_(variant), request_(request), options_(options), x_(request.x), y_(request.y) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  set_.band = request.band.value_or(assembly::Band{0, foundation::infinity});
  set_.min_prominence = request.min_prominence;
  std::vector<RequirementResult> results;
  const auto add = [&](const std::string& name, assembly::MotionQuantity quantity, DesignRule::Kind kind,
                       double allowed) {
    const bool amplitude = kind == DesignRule::Kind::amplitude;
    set_.rules.push_back({kind, channel_of(name, quantity), allowed});
    const assembly::Channel channel = assembly::channels(variant.system, assembled, {name}, quantity).front();
    rules_.push_back({kind, channel.name, channel.unit, allowed,
                      amplitude ? amplitude_words(channel.name, allowed, channel.unit) : "no peak of " + channel.name});
    RequirementResult& result = results.emplace_back();
    result.kind = amplitude ? RequirementKind::amplitude : RequirementKind::no_peak;
    result.subject = name;
    result.allowed = allowed;
    result.quantity = quantity;
    result.excitations = request.excitations;
    result.band = amplitude ? set_.band : assembly::Band{0, foundation::infinity};
  };
  for (const project::AmplitudeLimit& limit : request.limits)
    add(limit.name, limit.quantity, DesignRule::Kind::amplitude, limit.amplitude);
  for (const assembly::Channel& channel :
       assembly::channels(variant.system, assembled, request.no_peak, request.quantity))
    add(channel.name, request.quantity, DesignRule::Kind::no_peak, request.peak_tolerance);
  if (set_.rules.size() > DesignOutcome::most_rules)
    throw foundation::NotComputable(
        fmt::format("map: {} rules; a map has at most {}", set_.rules.size(), DesignOutcome::most_rules));
  counts_modes_ = !request.limits.empty() && set_.band.from > 0 && std::isfinite(set_.band.to);
  results.insert(results.end(), frequencies.begin(), frequencies.end());
  if (!options.fast) report_.no_family = "as requested";
  else if (!results.empty()) fit_batch(results);
}

void DesignEvaluation::fit_batch(const std::vector<RequirementResult>& results) {
  project::Analyses analyses;
  analyses.requirements = request_.requirements.value_or(project::Requirements());
  analyses.requirements->min_prominence = request_.min_prominence;
  const auto model = [&](const Eigen::VectorXd& values) {
    auto system = system_at({values(0), values(1)});
    if (!system) throw foundation::NotComputable(system.error().list().front().finding);
    return std::move(*system);
  };
  batch_.emplace(DesignNumbers{{{request_.x.from, request_.x.to, request_.x.name},
                                {request_.y.from, request_.y.to, request_.y.name}},
                               model,
                               design::SumFamily::Compared::grid,
                               true},
                 case_, analyses, results);
  report_.no_family = batch_->reason();
  if (has_family()) report_.family = "matrices as " + batch_->family().words();
}

Eigen::ArrayXXd DesignEvaluation::frequency_margins(const std::vector<DesignPoint>& points) const {
  const CaseVector& packed = batch_->packed();
  return quick_margins(packed, batch_->designs(rows_of(points)))
      .rightCols(to_index(packed.results().size() - rules_.size()));
}

void DesignEvaluation::evaluate_in_lanes(std::size_t first, const std::vector<DesignPoint>& points,
                                         DesignOutcome* outcomes) {
  const CaseVector::Unpacked designs = batch_->designs(rows_of(points));
  const auto [margins, status] = curve_margins(batch_->packed(), designs);
  Eigen::ArrayXXd squared_frequencies;
  if (counts_modes_)
    squared_frequencies =
        numerics::design_modes(batch_->packed().free(designs), {.shapes = false, .threads = 1}).lambda;
  std::size_t proven = 0, fallback = 0;
  std::vector<double> of_design(rules_.size());
  for (std::size_t d = 0; d < points.size(); ++d) {
    const bool good = status[d] == numerics::DesignStatus::proven || status[d] == numerics::DesignStatus::fallback;
    if (!good) {
      outcomes[d] = assembled_outcome(first + d, points[d]);
      continue;
    }
    for (std::size_t r = 0; r < of_design.size(); ++r) of_design[r] = margins(to_index(d), to_index(r));
    outcomes[d] = outcome_of(design::governing(of_design));
    for (Eigen::Index k = 0; k < squared_frequencies.cols(); ++k)
      count_mode(squared_frequencies(to_index(d), k), set_.band, outcomes[d]);
    ++(status[d] == numerics::DesignStatus::proven ? proven : fallback);
  }
  const std::lock_guard lock(noting_);
  report_.proven += proven;
  report_.fallback += fallback;
}

std::size_t DesignEvaluation::channel_of(const std::string& name, assembly::MotionQuantity quantity) {
  for (std::size_t i = 0; i < channels_.size(); ++i)
    if (channels_[i].name == name && channels_[i].quantity == quantity) return i;
  channels_.push_back({name, quantity});
  return channels_.size() - 1;
}

std::vector<assembly::Channel> DesignEvaluation::channels(const model::System& system,
                                                          const assembly::Assembled& assembled) const {
  std::vector<assembly::Channel> result;
  for (const NamedChannel& channel : channels_)
    result.push_back(assembly::channels(system, assembled, {channel.name}, channel.quantity).front());
  return result;
}

foundation::Expected<model::System> DesignEvaluation::system_at(const DesignPoint& point) const {
  return judging::changed_system(case_, {{x_, point.x}, {y_, point.y}});
}

bool DesignEvaluation::is_at(const model::System& system, const DesignPoint& point) const {
  const auto there = system_at(point);
  if (!there) return false;
  const assembly::Assembled a = assembly::assemble(system), b = assembly::assemble(*there);
  if (a.layout.size() != b.layout.size()) return false;
  const assembly::Loading of_a = assembly::harmonic_loading(system, a, request_.excitations),
                          of_b = assembly::harmonic_loading(*there, b, request_.excitations);
  const Eigen::VectorXd unit = numerics::unit_scale(a.matrices).head(a.layout.before_last());
  const auto [lowest, highest] = compared_range(a, b, modal::highest_natural_frequency(system, a));
  if (!(lowest < highest)) return false;
  for (const double omega : {lowest, std::sqrt(lowest * highest), highest}) {
    const auto scaled = [&](const assembly::Assembled& m) -> Eigen::MatrixXcd {
      return unit.asDiagonal() * m.dynamic_stiffness(omega, omega) * unit.asDiagonal();
    };
    const Eigen::MatrixXcd of_case = scaled(a);
    if (!((of_case - scaled(b)).cwiseAbs().maxCoeff() <= design::reproduced_within * of_case.cwiseAbs().maxCoeff()))
      return false;
    const Eigen::VectorXcd load = assembly::exact_right_side(a, of_a, omega, omega);
    if (!((load - assembly::exact_right_side(b, of_b, omega, omega)).cwiseAbs().maxCoeff() <=
          design::reproduced_within * load.cwiseAbs().maxCoeff()))
      return false;
  }
  return true;
}

design::JudgedDesign DesignEvaluation::judged_design(const model::System& system) const {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const modal::Roots roots = modal::roots(system, assembled, modes);
  const std::vector<assembly::Channel> requested = channels(system, assembled);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled, request_.excitations);
  const double search_to = std::isfinite(set_.band.to) ? set_.band.to : 0;
  design::JudgedDesign result;
  result.peaks = response::peaks(assembled, requested, loading, modes, roots,
                                 {.min_prominence = set_.min_prominence, .search_to = search_to});
  result.rules = design::rule_values(assembled, requested, loading, result.peaks, set_);
  for (std::size_t r = 0; r < set_.rules.size(); ++r)
    result.margins.push_back(design::margin(set_.rules[r], result.rules.values[r]));
  result.governing = design::governing(result.margins);
  for (const modal::Mode& mode : modes.list) result.natural_frequencies_squared.push_back(mode.eigenvalue_squared);
  return result;
}

DesignOutcome DesignEvaluation::assembled_outcome(std::size_t index, const DesignPoint& point) {
  ++assembled_separately_;
  const auto system = system_at(point);
  if (!system) {
    const auto& list = system.error().list();
    const auto first = std::ranges::find(list, foundation::Severity::error, &foundation::Problem::severity);
    missing_.note(index, first->subject + ": " + first->rule,
                  fmt::format("{}: {}; {}", first->subject, first->finding, first->rule));
    return {0, DesignOutcome::no_model};
  }
  try {
    const design::JudgedDesign found = judged_design(*system);
    DesignOutcome outcome = outcome_of(found.governing);
    for (const double squared : found.natural_frequencies_squared)
      if (counts_modes_) count_mode(squared, set_.band, outcome);
    return outcome;
  } catch (const foundation::NotComputable& reason) {
    missing_.note(index, reason.what(), reason.what());
  } catch (const foundation::InvalidInput& reason) {
    missing_.note(index, reason.what(), reason.what());
  }
  return {0, DesignOutcome::not_computed};
}

std::vector<DesignOutcome> DesignEvaluation::evaluate(std::size_t count,
                                                      const std::function<DesignPoint(std::size_t)>& point,
                                                      const foundation::Progress& progress) {
  std::vector<DesignOutcome> outcomes(count);
  foundation::parallel_for(count,
                           {.size = has_family() ? lane_piece : assembled_piece,
                            .threads = options_.threads,
                            .progress = progress,
                            .task = "designs"},
                           [&](std::size_t first, std::size_t last) {
                             std::vector<DesignPoint> points;
                             for (std::size_t i = first; i < last; ++i) points.push_back(point(i));
                             if (has_family()) return evaluate_in_lanes(first, points, &outcomes[first]);
                             for (std::size_t i = first; i < last; ++i)
                               outcomes[i] = assembled_outcome(i, points[i - first]);
                           });
  report_.assembled_separately = assembled_separately_;
  report_.missing = missing_.list();
  return outcomes;
}

}  // namespace trivet::study
