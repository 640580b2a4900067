// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/design_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/changed_case.h"
#include "trivet/modal/modes.h"
#include "trivet/numerics/batch/driven_peaks.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/roots/design_modes.h"

namespace trivet::design {
namespace {

DesignOutcome outcome_of(const Governing& least) {
  return {rounded_margin(least.margin), static_cast<std::uint8_t>(least.rule)};
}

/// Counts one natural frequency of a design that is below or in the band of the amplitudes.
void count_mode(double squared, const assembly::Band& band, DesignOutcome& outcome) {
  if (squared < band.from * band.from)
    outcome.modes_below += outcome.modes_below < std::numeric_limits<std::uint16_t>::max();
  else if (squared <= band.to * band.to)
    outcome.modes_in_band += outcome.modes_in_band < std::numeric_limits<std::uint8_t>::max();
}

bool is_good(numerics::DesignStatus status) {
  return status == numerics::DesignStatus::proven || status == numerics::DesignStatus::fallback;
}

constexpr std::size_t assembled_piece =
    1;  // a design takes milliseconds, and a step of the boundary search has few designs
constexpr std::size_t lane_piece = 256;  // designs; their matrices fit in the cache

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

std::string amplitude_words(const std::string& name, double amplitude, const std::string& unit) {
  return fmt::format("{} ≤ {:.6g} {}", name, amplitude, unit);
}

}  // namespace

DesignEvaluation::DesignEvaluation(const project::Case& variant, const project::MapRequest& request,
                                   const EvaluationOptions& options)
    : case_(variant), request_(request), options_(options), x_(request.x), y_(request.y) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  for (const project::AmplitudeLimit& limit : request.limits) {
    const std::size_t channel = channel_of(limit.name, limit.quantity);
    set_.rules.push_back({DesignRule::Kind::amplitude, channel, limit.amplitude});
  }
  for (const assembly::Channel& channel :
       assembly::channels(variant.system, assembled, request.no_peak, request.quantity))
    set_.rules.push_back(
        {DesignRule::Kind::no_peak, channel_of(channel.name, request.quantity), request.peak_tolerance});
  if (set_.rules.size() > DesignOutcome::most_rules)
    throw foundation::NotComputable(
        fmt::format("map: {} rules; a map has at most {}", set_.rules.size(), DesignOutcome::most_rules));
  set_.band = request.band.value_or(assembly::Band{0, std::numeric_limits<double>::infinity()});
  counts_modes_ = !request.limits.empty() && set_.band.from > 0 && std::isfinite(set_.band.to);
  set_.min_prominence = request.min_prominence;
  const std::vector<assembly::Channel> all = channels(variant.system, assembled);
  for (const DesignRule& rule : set_.rules) {
    const assembly::Channel& channel = all[rule.channel];
    const bool amplitude = rule.kind == DesignRule::Kind::amplitude;
    rules_.push_back(
        {rule.kind, channel.name, channel.unit, rule.allowed,
         amplitude ? amplitude_words(channel.name, rule.allowed, channel.unit) : "no peak of " + channel.name});
  }
  if (options.fast) fit_family(variant);
  else report_.no_family = "as requested";
}

/// @param form  plain_design or driven_design
template <typename Design, typename Form>
FamilyOrReason<Design> DesignEvaluation::fitted(const project::Case& variant, const Form& form) const {
  const auto formed = [&](const model::System& system) -> DesignOrReason<Design> {
    const assembly::Assembled assembled = assembly::assemble(system);
    DesignOrReason<Design> found = form(assembled, channels(system, assembled),
                                        assembly::harmonic_loading(system, assembled, request_.excitations));
    if (found.design && !numerics::is_positive_definite(found.design->K))
      return {{}, "rigid-body modes or unstable motions"};
    return found;
  };
  const std::string reason = formed(variant.system).reason;
  if (!reason.empty()) return {{}, reason};
  return DesignFamily<Design>::fitted(
      [&](const FamilyPoint& point) -> DesignOrReason<Design> {
        const auto system = system_at({point.x, point.y});
        return system ? formed(*system) : DesignOrReason<Design>{{}, "some designs are no valid model"};
      },
      {request_.x.from, request_.x.to, request_.x.name}, {request_.y.from, request_.y.to, request_.y.name});
}

void DesignEvaluation::fit_family(const project::Case& variant) {
  const auto words = [](const auto& family) {
    return fmt::format(
        "matrices interpolated from {} × {} assembled designs, compared with 41 others: largest deviation {:.0e}",
        family.x_nodes(), family.y_nodes(), std::max(family.worst_difference(), 1e-16));
  };
  FamilyOrReason<PlainDesign> plain = fitted<PlainDesign>(variant, plain_design);
  if (plain.family) {
    report_.family = words(*plain.family);
    plain_family_ = std::move(plain.family);
  } else {
    const bool within_band = std::isfinite(set_.band.to) && std::ranges::all_of(set_.rules, [](const DesignRule& rule) {
                               return rule.kind == DesignRule::Kind::amplitude;
                             });
    FamilyOrReason<DrivenDesign> driven = fitted<DrivenDesign>(
        variant,
        [&](const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
            const assembly::Loading& loading) { return driven_design(assembled, channels, loading, within_band); });
    if (driven.family) report_.family = words(*driven.family);
    else report_.no_family = driven.reason;
    driven_family_ = std::move(driven.family);
  }
  if (has_family()) plan_searches();
}

void DesignEvaluation::plan_searches() {
  const auto of_kind = [&](DesignRule::Kind kind) {
    return std::ranges::any_of(set_.rules, [&](const DesignRule& r) { return r.kind == kind; });
  };
  search_.count_peaks = of_kind(DesignRule::Kind::no_peak);
  search_.min_prominence = set_.min_prominence;
  search_.threads = 1;
  if (plain_family_) {
    const PlainDesign& first = plain_family_->first();
    search_.rows = first.rows.array();
    if (!first.rows_on_velocity.isZero(0)) search_.rows_on_velocity = first.rows_on_velocity.array();
    search_.derivative = first.derivative;
  }
  const bool whole = set_.band.from == 0 && std::isinf(set_.band.to);
  if (!search_.count_peaks) search_.from = set_.band.from, search_.to = set_.band.to;
  else beyond_band_ = !whole && of_kind(DesignRule::Kind::amplitude);
}

numerics::DesignPeaks DesignEvaluation::peaks_of_family(const std::vector<FamilyPoint>& places,
                                                        const numerics::DesignPeakOptions& search) const {
  if (plain_family_) return numerics::design_peaks(plain_family_->designs(places), search);
  return numerics::driven_peaks(driven_family_->designs(places),
                                {search.from, search.to, search.count_peaks, search.min_prominence});
}

Eigen::ArrayXXd DesignEvaluation::modes_of_family(const std::vector<FamilyPoint>& places) const {
  const auto lambda = [](const numerics::Designs& designs) {
    return numerics::design_modes(designs, {.shapes = false, .threads = 1}).lambda;
  };
  if (plain_family_) return lambda(plain_family_->designs(places));
  const numerics::DrivenDesigns driven = driven_family_->designs(places);
  return lambda({driven.A, driven.B, driven.K, Eigen::ArrayXXd::Zero(1, driven_family_->first().A.rows())});
}

std::optional<Eigen::ArrayXXd> DesignEvaluation::squared_frequencies(const std::vector<DesignPoint>& points) const {
  if (!has_family()) return std::nullopt;
  std::vector<FamilyPoint> places;
  for (const DesignPoint& p : points) places.push_back({p.x, p.y});
  return modes_of_family(places);
}

std::vector<std::size_t> DesignEvaluation::highest_outside_band(const numerics::DesignPeaks& found) const {
  std::vector<std::size_t> designs;
  for (Eigen::Index d = 0; d < found.highest.rows(); ++d)
    if (is_good(found.status[d]) && std::ranges::any_of(set_.rules, [&](const DesignRule& rule) {
          const double at = found.highest_at(d, to_index(rule.channel));
          return rule.kind == DesignRule::Kind::amplitude && !(at >= set_.band.from && at <= set_.band.to);
        }))
      designs.push_back(to_size(d));
  return designs;
}

void DesignEvaluation::evaluate_in_lanes(std::size_t first, const std::vector<DesignPoint>& points,
                                         DesignOutcome* outcomes) {
  std::vector<FamilyPoint> places;
  for (const DesignPoint& p : points) places.push_back({p.x, p.y});
  numerics::DesignPeaks found = peaks_of_family(places, search_);
  const Eigen::ArrayXXd squared_frequencies = counts_modes_ ? modes_of_family(places) : Eigen::ArrayXXd();
  if (beyond_band_) {  // peaks count at all frequencies, amplitudes only in the band; the highest one is rarely outside
    const std::vector<std::size_t> again = highest_outside_band(found);
    std::vector<FamilyPoint> there;
    for (const std::size_t d : again) there.push_back(places[d]);
    numerics::DesignPeakOptions in_band = search_;
    in_band.from = set_.band.from;
    in_band.to = set_.band.to;
    in_band.count_peaks = false;
    const numerics::DesignPeaks inside = again.empty() ? numerics::DesignPeaks() : peaks_of_family(there, in_band);
    for (std::size_t k = 0; k < again.size(); ++k) {
      found.highest.row(to_index(again[k])) = inside.highest.row(to_index(k));
      found.status[again[k]] = std::max(found.status[again[k]], inside.status[k]);  // the worse of both
    }
  }
  std::vector<double> values(set_.rules.size());
  std::size_t proven = 0, fallback = 0;
  for (std::size_t d = 0; d < points.size(); ++d) {
    if (!is_good(found.status[d])) {
      outcomes[d] = assembled_outcome(first + d, points[d]);
      continue;
    }
    for (std::size_t r = 0; r < values.size(); ++r) {
      const auto row = to_index(d), channel = to_index(set_.rules[r].channel);
      values[r] = set_.rules[r].kind == DesignRule::Kind::amplitude ? found.highest(row, channel)
                                                                    : found.largest_rise(row, channel);
    }
    outcomes[d] = outcome_of(governing(set_, values));
    for (Eigen::Index k = 0; k < squared_frequencies.cols(); ++k)
      count_mode(squared_frequencies(to_index(d), k), set_.band, outcomes[d]);
    ++(found.status[d] == numerics::DesignStatus::proven ? proven : fallback);
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
    if (!((of_case - scaled(b)).cwiseAbs().maxCoeff() <= reproduced_within * of_case.cwiseAbs().maxCoeff()))
      return false;
    const Eigen::VectorXcd load = assembly::exact_right_side(a, of_a, omega, omega);
    if (!((load - assembly::exact_right_side(b, of_b, omega, omega)).cwiseAbs().maxCoeff() <=
          reproduced_within * load.cwiseAbs().maxCoeff()))
      return false;
  }
  return true;
}

JudgedDesign DesignEvaluation::judged_design(const model::System& system) const {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const modal::Roots roots = modal::roots(system, assembled, modes);
  const std::vector<assembly::Channel> requested = channels(system, assembled);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled, request_.excitations);
  const double search_to = std::isfinite(set_.band.to) ? set_.band.to : 0;
  JudgedDesign result;
  result.peaks = response::peaks(assembled, requested, loading, modes, roots,
                                 {.min_prominence = set_.min_prominence, .search_to = search_to});
  result.rules = rule_values(assembled, requested, loading, result.peaks, set_);
  for (std::size_t r = 0; r < set_.rules.size(); ++r)
    result.margins.push_back(margin(set_.rules[r], result.rules.values[r]));
  result.governing = governing(result.margins);
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
    const JudgedDesign found = judged_design(*system);
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

}  // namespace trivet::design
