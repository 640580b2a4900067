// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/design_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/pieces.h"
#include "trivet/study/changes.h"
#include "trivet/study/design_parameter.h"

namespace trivet::study {
namespace {

constexpr std::size_t assembled_piece = 4;  // designs, each of milliseconds

std::mutex reading;   // the unit database and the files behind elements serve one reader at a time
std::mutex noting;

std::string amplitude_words(const std::string& name, double amplitude, const std::string& unit) { return fmt::format("{} ≤ {:.6g} {}", name, amplitude, unit); }

}  // namespace

DesignEvaluation::DesignEvaluation(const Case& variant, const MapRequest& request, const Options& options)
    : case_(variant), request_(request), options_(options), x_keys_(path_keys(request.x.parameter)), y_keys_(path_keys(request.y.parameter)) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  for (const MapLimit& limit : request.limits) {
    const std::size_t channel = channel_of(limit.name, limit.quantity);
    set_.rules.push_back({response::DesignRule::Kind::amplitude, channel, limit.amplitude});
  }
  for (const assembly::Channel& channel : assembly::channels(variant.system, assembled, request.no_peak, request.quantity))
    set_.rules.push_back({response::DesignRule::Kind::no_peak, channel_of(channel.name, request.quantity), request.peak_tolerance});
  if (set_.rules.size() > DesignOutcome::most_rules)
    throw foundation::NotComputable(fmt::format("map: {} rules; a map judges at most {}", set_.rules.size(), DesignOutcome::most_rules));
  set_.band = request.band.value_or(response::Band{0, std::numeric_limits<double>::infinity()});
  set_.min_prominence = request.min_prominence;
  const std::vector<assembly::Channel> all = channels(variant.system, assembled);
  for (const response::DesignRule& rule : set_.rules) {
    const assembly::Channel& channel = all[rule.channel];
    const bool amplitude = rule.kind == response::DesignRule::Kind::amplitude;
    rules_.push_back({rule.kind, channel.name, channel.unit, rule.allowed, amplitude ? amplitude_words(channel.name, rule.allowed, channel.unit) : "no peak of " + channel.name});
  }
}

std::size_t DesignEvaluation::channel_of(const std::string& name, assembly::Quantity quantity) {
  for (std::size_t i = 0; i < answers_.size(); ++i)
    if (answers_[i].name == name && answers_[i].quantity == quantity) return i;
  answers_.push_back({name, quantity});
  return answers_.size() - 1;
}

std::vector<assembly::Channel> DesignEvaluation::channels(const model::System& system, const assembly::Assembled& assembled) const {
  std::vector<assembly::Channel> result;
  for (const Answer& answer : answers_) result.push_back(assembly::channels(system, assembled, {answer.name}, answer.quantity).front());
  return result;
}

foundation::Expected<model::System> DesignEvaluation::system_at(const DesignPoint& point) const {
  Node changes = change_of(x_keys_, point.x, request_.x.unit);
  foundation::Problems problems;
  apply_changes(changes, change_of(y_keys_, point.y, request_.y.unit), "", problems);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  const std::lock_guard lock(reading);
  return changed_system(case_, changes);
}

JudgedDesign DesignEvaluation::judged(const model::System& system) const {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const modal::Roots roots = modal::roots(system, assembled, modes);
  const std::vector<assembly::Channel> asked = channels(system, assembled);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled, request_.excitations);
  const double search_to = std::isfinite(set_.band.to) ? set_.band.to : 0;
  JudgedDesign result;
  result.peaks = response::peaks(assembled, asked, loading, modes, roots, {set_.min_prominence, search_to});
  result.values = response::rule_values(assembled, asked, loading, result.peaks, set_);
  result.governing = response::governing(set_, result.values);
  return result;
}

void DesignEvaluation::note_missing(std::size_t index, std::uint8_t outcome, const std::string& kind, const std::string& words) {
  const std::lock_guard lock(noting);
  const auto known = static_cast<std::size_t>(std::find(missing_kinds_.begin(), missing_kinds_.end(), kind) - missing_kinds_.begin());
  if (known == missing_kinds_.size()) {
    missing_kinds_.push_back(kind);
    report_.missing.push_back({outcome, words, 0, index});
  }
  MissingReason& reason = report_.missing[known];
  ++reason.designs;
  if (index < reason.first) {
    reason.first = index;
    reason.words = words;
  }
}

DesignOutcome DesignEvaluation::assembled_outcome(std::size_t index, const DesignPoint& point) {
  const auto system = system_at(point);
  if (!system) {
    const auto& list = system.error().list();
    const auto first = std::find_if(list.begin(), list.end(), [](const foundation::Problem& p) { return p.severity == foundation::Severity::error; });
    note_missing(index, DesignOutcome::no_model, first->subject + first->rule, fmt::format("{} = {}; {}", first->subject, first->finding, first->rule));
    return {0, DesignOutcome::no_model};
  }
  try {
    const response::Governing least = judged(*system).governing;
    return {static_cast<float>(least.margin), static_cast<std::uint8_t>(least.rule)};
  } catch (const foundation::NotComputable& reason) {
    note_missing(index, DesignOutcome::not_computed, "not computed", reason.what());
  } catch (const foundation::InvalidInput& reason) {
    note_missing(index, DesignOutcome::not_computed, "not computed", reason.what());
  }
  return {0, DesignOutcome::not_computed};
}

std::vector<DesignOutcome> DesignEvaluation::evaluate(std::size_t count, const std::function<DesignPoint(std::size_t)>& point, const foundation::Progress& progress) {
  std::vector<DesignOutcome> outcomes(count);
  report_.way = "every design assembled from the changed project and searched by itself";
  report_.assembled += count;
  foundation::for_each_piece(count, {assembled_piece, options_.threads, progress, "designs"}, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) outcomes[i] = assembled_outcome(i, point(i));
  });
  std::vector<std::size_t> order(report_.missing.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return report_.missing[a].first < report_.missing[b].first; });
  std::vector<MissingReason> sorted;
  std::vector<std::string> kinds;
  for (const std::size_t i : order) {
    sorted.push_back(report_.missing[i]);
    kinds.push_back(missing_kinds_[i]);
  }
  report_.missing = std::move(sorted);
  missing_kinds_ = std::move(kinds);
  return outcomes;
}

}  // namespace trivet::study
