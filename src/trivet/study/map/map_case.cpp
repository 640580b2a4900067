// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"
#include "trivet/modal/modes.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/packed_margins.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

using design::DesignOutcome;
using design::DesignPoint;
using design::DesignRule;

constexpr double no_margin = std::numeric_limits<double>::quiet_NaN();

bool is_on_frequencies(const RequirementResult& result) {
  return requirement_row(result.kind).packed == PackedPart::frequencies;
}

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

std::string words_of(const std::vector<design::MapRule>& rules, std::size_t first, std::size_t last) {
  constexpr std::size_t most = 4;
  std::string words;
  for (std::size_t r = first; r < std::min(last, first + most); ++r)
    words += (r == first ? "" : ", ") + rules[r].stated();
  return last - first > most ? words + fmt::format(" and {} more", last - first - most) : words;
}

}  // namespace

MapCase::MapCase(const project::Case& variant, project::MapRequest request, const design::EvaluationOptions& options,
                 bool further)
    : case_(variant),
      request_(std::move(request)),
      of_case_(further ? " in case " + foundation::quoted(variant.name) : ""),
      x_(request_.x),
      y_(request_.y),
      required_(variant.analyses) {
  required_.limits.clear();                                           // rules of the map, or replaced by those
  if (!variant.analyses.requirements) required_.limit_lines.clear();  // no rules of a map
  required_.requirements = request_.requirements;
  std::vector<RequirementResult> results = add_own_rules();
  std::vector<RequirementResult> required = requirements(variant.system, warnings_);
  std::ranges::copy_if(required, std::back_inserter(results), is_on_frequencies);
  if (!options.fast) no_family_ = "as requested";
  else if (!results.empty()) fit_batch(results);
  if (has_family()) {
    at_once_ = results.size() - own();
    std::ranges::stable_partition(required, std::not_fn(is_on_frequencies));
  }
  for (const RequirementResult& result : required) {
    rules_.push_back({DesignRule::Kind::requirement, result.subject, result.unit, result.allowed,
                      result.words_at_level(), study::name(result.kind)});
    rules_.back().words_for_people = result.words_for_people(case_.display);
    rules_.back().level = rules_.back().shown_level = result.level();
    if (const auto shown_at = result.level_for_people(case_.display)) {
      rules_.back().shown_level = project::level_ending(*shown_at);
      rules_.back().shown_factor = project::level_factor(*shown_at);
    }
  }
}

std::vector<RequirementResult> MapCase::add_own_rules() {
  const assembly::Assembled assembled = assembly::assemble(case_.system);
  set_.band = request_.band.value_or(assembly::Band{0, foundation::infinity});
  set_.min_prominence = request_.min_prominence;
  std::vector<RequirementResult> results;
  const auto add = [&](const std::string& name, assembly::MotionQuantity quantity, DesignRule::Kind kind,
                       double allowed) {
    const bool amplitude = kind == DesignRule::Kind::amplitude;
    set_.rules.push_back({kind, channel_of(name, quantity), allowed});
    const assembly::Channel channel = assembly::channels(case_.system, assembled, {name}, quantity).front();
    rules_.push_back({kind, channel.name, channel.unit, allowed,
                      amplitude ? amplitude_words(channel.name, allowed, channel.unit) : "no peak of " + channel.name});
    RequirementResult& result = results.emplace_back();
    result.kind = amplitude ? RequirementKind::amplitude : RequirementKind::no_peak;
    result.subject = name;
    result.allowed = allowed;
    result.quantity = quantity;
    result.excitations = request_.excitations;
    result.band = amplitude ? set_.band : assembly::Band{0, foundation::infinity};
  };
  for (const project::AmplitudeLimit& limit : request_.limits)
    add(limit.name, limit.quantity, DesignRule::Kind::amplitude, limit.amplitude);
  for (const assembly::Channel& channel :
       assembly::channels(case_.system, assembled, request_.no_peak, request_.quantity))
    add(channel.name, request_.quantity, DesignRule::Kind::no_peak, request_.peak_tolerance);
  if (own() > DesignOutcome::most_rules)
    throw foundation::NotComputable(
        fmt::format("map: {} rules; a map has at most {}", own(), DesignOutcome::most_rules));
  counts_modes_ = of_case_.empty() && !request_.limits.empty() && set_.band.from > 0 && std::isfinite(set_.band.to);
  return results;
}

void MapCase::fit_batch(const std::vector<RequirementResult>& results) {
  project::Analyses analyses;
  analyses.requirements = request_.requirements.value_or(project::Requirements());
  analyses.requirements->min_prominence = request_.min_prominence;
  const auto model = [&](const Eigen::VectorXd& values) {
    auto system = system_at({values(0), values(1)});
    if (!system) throw foundation::NotComputable(foundation::error_of(system.error()).finding);
    return std::move(*system);
  };
  batch_.emplace(DesignNumbers{{{request_.x.from, request_.x.to, request_.x.name},
                                {request_.y.from, request_.y.to, request_.y.name}},
                               model,
                               design::SumFamily::Compared::grid,
                               true},
                 case_, analyses, results);
  no_family_ = batch_->reason();
}

std::vector<RequirementResult> MapCase::requirements(const model::System& system,
                                                     foundation::Problems& warnings) const {
  const bool required = required_.requirements && !required_.requirements->is_empty();
  if (!required && system.description().clearances.empty() && !judges_operation(required_)) return {};
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  std::vector<RequirementResult> results = requirement_values(context, required_, warnings);
  if (at_once_ > 0) std::ranges::stable_partition(results, std::not_fn(is_on_frequencies));
  return results;
}

std::size_t MapCase::piece() const {
  // From models a design takes milliseconds, and a step of the boundary search has few designs. The matrices of many
  // fit in the cache; 15 lines of it for each number, so that they do not displace each other.
  constexpr std::size_t from_models = 1, from_both = 8, at_once = 120;
  if (!has_family()) return from_models;
  return is_quick() ? at_once : from_both;
}

PieceReport MapCase::judge(std::size_t first, const std::vector<DesignPoint>& points, Margins margins,
                           DesignOutcome* outcomes) const {
  PieceReport report;
  margins.setConstant(no_margin);
  if (has_family()) judge_at_once(points, margins, outcomes, report);
  for (std::size_t d = 0; d < points.size(); ++d)
    if (margins.row(to_index(d)).isNaN().any())
      judge_from_model(first + d, points[d], margins, to_index(d), outcomes[d], report);
  return report;
}

void MapCase::judge_at_once(const std::vector<DesignPoint>& points, Margins margins, DesignOutcome* outcomes,
                            PieceReport& report) const {
  const CaseVector::Unpacked designs = batch_->designs(rows_of(points));
  if (at_once_ > 0)
    margins.rightCols(to_index(at_once_)) = quick_margins(batch_->packed(), designs).rightCols(to_index(at_once_));
  if (own() == 0) return;
  const auto [of_curves, status] = curve_margins(batch_->packed(), designs);
  Eigen::ArrayXXd squared_frequencies;
  if (counts_modes_)
    squared_frequencies =
        numerics::design_modes(batch_->packed().free(designs), {.shapes = false, .threads = 1}).lambda;
  for (Eigen::Index d = 0; d < margins.rows(); ++d) {
    const numerics::DesignStatus found = status[to_size(d)];
    if (found != numerics::DesignStatus::proven && found != numerics::DesignStatus::fallback) continue;
    margins.row(d).head(to_index(own())) = of_curves.row(d).head(to_index(own()));
    for (Eigen::Index k = 0; k < squared_frequencies.cols(); ++k) count_mode(squared_frequencies(d, k), outcomes[d]);
    ++(found == numerics::DesignStatus::proven ? report.proven : report.fallback);
  }
}

void MapCase::judge_from_model(std::size_t index, const DesignPoint& point, Margins margins, Eigen::Index d,
                               DesignOutcome& outcome, PieceReport& report) const {
  const auto refuse = [&](const std::string& rule, const std::string& words, std::uint8_t kind) {
    report.missing.note(index, rule + of_case_, words + of_case_);
    if (outcome.known()) outcome = {0, kind};
  };
  const auto n = to_index(own());
  const bool wants_own = margins.row(d).head(n).isNaN().any();
  if (!wants_own && !outcome.known()) return;
  report.assembled_separately += wants_own;
  const auto system = system_at(point);
  if (!system) {
    const foundation::Problem& first = foundation::error_of(system.error());
    return refuse(first.subject + ": " + first.rule, foundation::first_reason(system.error()), DesignOutcome::no_model);
  }
  try {
    if (wants_own) {
      const design::JudgedDesign found = own_rules(*system);
      for (Eigen::Index r = 0; r < n; ++r) margins(d, r) = found.margins[to_size(r)];
      for (const double squared : found.natural_frequencies_squared) count_mode(squared, outcome);
    }
    if (!outcome.known() || !margins.row(d).isNaN().any()) return;
    ++report.with_requirements;
    foundation::Problems of_design;  // the warnings of the model itself are enough
    const std::vector<RequirementResult> results = requirements(*system, of_design);
    for (std::size_t r = 0; r < results.size(); ++r) {
      if (!results[r].value) {
        const std::string words = results[r].words_for_people(case_.display) + ": " + results[r].reason;
        return refuse(words, words, DesignOutcome::not_computed);
      }
      double& margin = margins(d, n + to_index(r));
      if (std::isnan(margin)) margin = results[r].margin;
    }
  } catch (const foundation::NotComputable& reason) {
    refuse(reason.what(), reason.what(), DesignOutcome::not_computed);
  } catch (const foundation::InvalidInput& reason) {
    refuse(reason.what(), reason.what(), DesignOutcome::not_computed);
  }
}

void MapCase::count_mode(double squared, DesignOutcome& outcome) const {
  if (!counts_modes_) return;
  if (squared < set_.band.from * set_.band.from)
    outcome.modes_below += outcome.modes_below < std::numeric_limits<std::uint16_t>::max();
  else if (squared <= set_.band.to * set_.band.to)
    outcome.modes_in_band += outcome.modes_in_band < std::numeric_limits<std::uint8_t>::max();
}

std::size_t MapCase::channel_of(const std::string& name, assembly::MotionQuantity quantity) {
  for (std::size_t i = 0; i < channels_.size(); ++i)
    if (channels_[i].name == name && channels_[i].quantity == quantity) return i;
  channels_.push_back({name, quantity});
  return channels_.size() - 1;
}

foundation::Expected<model::System> MapCase::system_at(const DesignPoint& point) const {
  return judging::changed_system(case_, {{x_, point.x}, {y_, point.y}});
}

bool MapCase::is_at(const model::System& system, const DesignPoint& point) const {
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

design::JudgedDesign MapCase::own_rules(const model::System& system) const {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const modal::Roots roots = modal::roots(system, assembled, modes);
  std::vector<assembly::Channel> channels;
  for (const NamedChannel& one : channels_)
    channels.push_back(assembly::channels(system, assembled, {one.name}, one.quantity).front());
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled, request_.excitations);
  const double search_to = std::isfinite(set_.band.to) ? set_.band.to : 0;
  design::JudgedDesign result;
  result.peaks = response::peaks(assembled, channels, loading, modes, roots,
                                 {.min_prominence = set_.min_prominence, .search_to = search_to});
  result.rules = design::rule_values(assembled, channels, loading, result.peaks, set_);
  for (std::size_t r = 0; r < own(); ++r)
    result.margins.push_back(design::margin(set_.rules[r], result.rules.values[r]));
  for (const modal::Mode& mode : modes.list) result.natural_frequencies_squared.push_back(mode.eigenvalue_squared);
  return result;
}

void MapCase::add_judged(const model::System& system, design::JudgedDesign& result) const {
  if (own() > 0) {
    design::JudgedDesign judged = own_rules(system);
    if (result.margins.empty()) {
      result = std::move(judged);
    } else {
      const auto add = [](std::vector<double>& all, const std::vector<double>& more) {
        all.insert(all.end(), more.begin(), more.end());
      };
      add(result.rules.values, judged.rules.values);
      add(result.rules.angular_frequencies, judged.rules.angular_frequencies);
      add(result.margins, judged.margins);
    }
  }
  if (own() == rules_.size()) return;
  foundation::Problems of_design;
  for (const RequirementResult& requirement : requirements(system, of_design)) {
    if (!requirement.value)
      throw foundation::NotComputable(requirement.words_for_people(case_.display) + ": " + requirement.reason);
    result.rules.values.push_back(*requirement.value);
    result.rules.angular_frequencies.push_back(requirement.angular_frequency.value_or(no_margin));
    result.margins.push_back(requirement.margin);
  }
}

design::EvaluationReport MapCase::report(const PieceReport& judged) const {
  design::EvaluationReport report;
  report.proven = judged.proven;
  report.fallback = judged.fallback;
  report.assembled_separately = judged.assembled_separately;
  report.with_requirements = judged.with_requirements;
  report.missing = judged.missing.list();
  report.no_family = no_family_;
  if (has_family()) report.family = "matrices as " + batch_->family().words();
  if (!of_case_.empty() && own() > 0) report.further.push_back(of_case_.substr(1) + ": " + report.summary());
  const std::size_t at_once = rules_.size() - at_once_;
  if (at_once_ > 0)
    report.further.push_back(fmt::format("natural frequencies{} of the {}: {}", of_case_,
                                         own() == 0 ? report.family : "matrices as sums",
                                         words_of(rules_, at_once, rules_.size())));
  if (own() < at_once)
    report.further.push_back(fmt::format("judged design by design{}: {}", of_case_, words_of(rules_, own(), at_once)));
  return report;
}

}  // namespace trivet::study
