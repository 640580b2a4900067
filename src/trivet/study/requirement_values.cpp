// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirement_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "trivet/assembly/loads.h"
#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/suspension.h"
#include "trivet/project/analyses/random_question.h"
#include "trivet/project/analyses/transient_question.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/explanation.h"
#include "trivet/study/margin.h"
#include "trivet/study/mount_loads.h"
#include "trivet/study/mount_sums.h"
#include "trivet/study/question_answer.h"
#include "trivet/study/transient_answer.h"

namespace trivet::study {
namespace {

using assembly::MotionQuantity;
using foundation::infinity;
using foundation::two_pi;

constexpr MotionQuantity motion_quantities[] = {MotionQuantity::displacement, MotionQuantity::velocity,
                                                MotionQuantity::acceleration};

class Judge {
 public:
  Judge(const CaseContext& context, const project::Analyses& analyses, foundation::Problems& warnings)
      : c_(context), analyses_(analyses), warnings_(warnings) {}

  std::vector<RequirementResult> judge() {
    const project::Requirements none;
    const project::Requirements& required = analyses_.requirements ? *analyses_.requirements : none;
    add_limits_of_file();
    add_amplitudes(required.limits, required.band.value_or(response::Band{0, infinity}), required.excitations);
    add_no_peak(required);
    add_limit_lines(required);
    add_natural_frequencies(required);
    add_damping_ratio(required);
    add_decoupling(required);
    add_rms(required.rms);
    add_largest(required.largest);
    add_static(required.statics);
    if (required.mount_load)
      for (RequirementResult& one : mount_loads(c_)) results_.push_back(std::move(one));
    for (RequirementResult& one : mount_sums(c_.system, required)) results_.push_back(std::move(one));
    return std::move(results_);
  }

 private:
  RequirementResult& add(RequirementKind kind, const std::string& subject, std::string words, const std::string& unit,
                         double allowed) {
    RequirementResult& result = results_.emplace_back();
    result.kind = kind;
    result.subject = subject;
    result.words = std::move(words);
    result.unit = unit;
    result.allowed = allowed;
    return result;
  }

  /// Computes values of results from `first` on; if that is impossible, these have the reason.
  void attempt(std::size_t first, const std::function<void()>& compute) {
    std::string reason;
    try {
      compute();
      return;
    } catch (const foundation::NotComputable& refused) {
      reason = refused.what();
    } catch (const foundation::InvalidInput& refused) {
      reason = refused.what();
    }
    for (std::size_t i = first; i < results_.size(); ++i) {
      results_[i].value.reset();
      results_[i].margin = 0;
      results_[i].reason = reason;
    }
  }

  void add_limits_of_file() {
    std::vector<project::AmplitudeLimit> limits;
    const auto& response = analyses_.response;
    for (const project::Limit& limit : analyses_.limits)
      limits.push_back(
          {limit.name, response ? response->selection.quantity : MotionQuantity::displacement, limit.amplitude});
    const response::Band all{0, infinity};
    add_amplitudes(limits, response ? response->band.value_or(all) : all,
                   response ? response->selection.excitations : std::vector<std::string>());
  }

  /// Peaks of channels over the whole axis, at least over the band.
  response::Peaks peaks_of(const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                           const response::Band& band, double min_prominence) const {
    return response::peaks(c_.assembled, channels, loading, c_.modes, c_.roots(),
                           {.min_prominence = min_prominence, .search_to = std::isfinite(band.to) ? band.to : 0},
                           c_.progress);
  }

  /// Bounds of single results, all with the same kind and words: "NAME ≤ 0.5 mm".
  void add_bounds(RequirementKind kind, const std::vector<project::AmplitudeLimit>& limits, const std::string& of,
                  const std::function<std::string(const project::AmplitudeLimit&)>& unit) {
    for (const project::AmplitudeLimit& limit : limits) {
      const std::string in = unit(limit);
      add(kind, limit.name, fmt::format("{}{} ≤ {}", of, limit.name, value_words(limit.amplitude, in)), in,
          limit.amplitude);
    }
  }

  std::string unit_of(const project::AmplitudeLimit& limit) const {
    return assembly::channels(c_.system, c_.assembled, {limit.name}, limit.quantity).front().unit;
  }

  void add_amplitudes(const std::vector<project::AmplitudeLimit>& limits, const response::Band& band,
                      const std::vector<std::string>& excitations) {
    if (limits.empty()) return;
    const std::size_t first = results_.size();
    add_bounds(RequirementKind::amplitude, limits, "", [&](const auto& limit) { return unit_of(limit); });
    attempt(first, [&] {
      std::vector<assembly::Channel> channels;
      std::vector<MotionQuantity> quantities;
      design::RuleSet set;
      set.band = band;
      for (const project::AmplitudeLimit& limit : limits) {
        quantities.push_back(limit.quantity);
        set.rules.push_back({design::DesignRule::Kind::amplitude, channels.size(), limit.amplitude});
        channels.push_back(assembly::channels(c_.system, c_.assembled, {limit.name}, limit.quantity).front());
      }
      set_rule_values(first, set, channels, quantities, excitations);
    });
  }

  void add_no_peak(const project::Requirements& required) {
    if (required.no_peak.empty()) return;
    const std::size_t first = results_.size();
    const std::vector<assembly::Channel> channels =
        assembly::channels(c_.system, c_.assembled, required.no_peak, required.quantity);
    design::RuleSet set;
    set.min_prominence = required.min_prominence;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      set.rules.push_back({design::DesignRule::Kind::no_peak, i, required.peak_tolerance});
      add(RequirementKind::no_peak, channels[i].name, "no peak of " + channels[i].name, "1", required.peak_tolerance);
    }
    attempt(first, [&] {
      set_rule_values(first, set, channels, std::vector(channels.size(), required.quantity), required.excitations);
    });
  }

  void set_rule_values(std::size_t first, const design::RuleSet& set, const std::vector<assembly::Channel>& channels,
                       const std::vector<MotionQuantity>& quantities, const std::vector<std::string>& excitations) {
    const assembly::Loading loading = assembly::harmonic_loading(c_.system, c_.assembled, excitations);
    if (loading.vanishes()) throw without_excitation("response, peaks");
    const response::Peaks found = peaks_of(channels, loading, set.band, set.min_prominence);
    const design::RuleValues values = design::rule_values(c_.assembled, channels, loading, found, set);
    for (std::size_t i = 0; i < set.rules.size(); ++i) {
      RequirementResult& result = results_[first + i];
      result.value = values.values[i];
      result.margin = design::margin(set.rules[i], values.values[i]);
      if (std::isfinite(values.angular_frequencies[i])) result.angular_frequency = values.angular_frequencies[i];
      result.quantity = quantities[i];
      result.excitations = excitations;
      result.candidates = set.rules[i].kind == design::DesignRule::Kind::amplitude
          ? maxima(set, i, channels, loading, found)
          : peaks_beside_minima(set.rules[i], i, found);
    }
  }

  std::vector<RequirementResult::Candidate> maxima(const design::RuleSet& set, std::size_t rule,
                                                   const std::vector<assembly::Channel>& channels,
                                                   const assembly::Loading& loading,
                                                   const response::Peaks& found) const {
    std::vector<RequirementResult::Candidate> result;
    for (const design::LargestAmplitude& one :
         design::maxima_in_band(c_.assembled, channels, loading, found, rule, set.band))
      if (std::isfinite(one.angular_frequency))
        result.push_back({design::margin(set.rules[rule], one.amplitude), one.angular_frequency, 0, 0});
    return result;
  }

  static std::vector<RequirementResult::Candidate> peaks_beside_minima(const design::DesignRule& rule,
                                                                       std::size_t curve,
                                                                       const response::Peaks& found) {
    std::vector<RequirementResult::Candidate> result;
    for (const response::Peak& peak : found.list) {
      if (peak.curve != curve || !std::isfinite(peak.amplitude)) continue;
      const double height = peak.amplitude - peak.prominence;
      constexpr double near_rest = 1e-6;  // of the peak's ω: the slopes of |y| are those at 0 to 1e-12
      double at = near_rest * peak.angular_frequency;
      double nearest = std::abs(found.curves[curve].static_amplitude.value_or(infinity) - height);
      for (const response::Extremum& turning : found.turnings[curve])
        if (const double apart = std::abs(turning.amplitude - height); !turning.maximum && apart < nearest) {
          nearest = apart;
          at = turning.angular_frequency;
        }
      result.push_back({design::margin(rule, response::relative_prominence(peak)), peak.angular_frequency, at, 0});
    }
    return result;
  }

  void add_limit_lines(const project::Requirements& required) {
    for (const project::LimitLineRequest& line : analyses_.limit_lines) {
      const auto& named = required.limit_lines;
      const bool asked =
          !analyses_.requirements || std::find(named.begin(), named.end(), line.line.name) != named.end();
      if (!asked || !analyses_.response) continue;
      const std::size_t first = results_.size();
      RequirementResult& result =
          add(RequirementKind::limit_line, line.of, fmt::format("{} within \"{}\"", line.of, line.line.name), "1", 1);
      attempt(first, [&] {
        const response::Band band = required.band ? *required.band
            : analyses_.response->band            ? *analyses_.response->band
                                                  : default_band(c_);
        const LimitLineResult found = limit_line_answer(c_, {line}, analyses_.response->selection, band).front();
        result.margin = found.comparison.least_margin;
        result.value = result.margin > 0 ? 1 / result.margin : infinity;  // share of the line
        result.angular_frequency = found.comparison.least_margin_at;
      });
    }
  }

  void add_natural_frequencies(const project::Requirements& required) {
    std::vector<const modal::Mode*> oscillating;
    for (const modal::Mode& mode : c_.modes.list)
      if (mode.angular_frequency.value_or(0) > 0) oscillating.push_back(&mode);
    for (const response::Band& window : required.avoided) {
      RequirementResult& result =
          add(RequirementKind::avoided_frequencies, "",
              fmt::format("no natural frequency in {:.6g} … {:.6g} Hz", window.from / two_pi, window.to / two_pi),
              "rad/s", window.to);
      result.margin = result.value.emplace(infinity);
      for (const modal::Mode* mode : oscillating) {
        const double omega = *mode->angular_frequency, margin = margin_outside(window, omega);
        const bool below = window.from / omega > omega / window.to;
        result.candidates.push_back({margin, omega, 0, mode->number, below});
        if (margin >= result.margin) continue;
        result.margin = margin;
        result.value = result.angular_frequency = omega;
        result.allowed = below ? window.from : window.to;
        result.detail = fmt::format("mode {}", mode->number);
      }
    }
    if (required.separation == 0) return;
    RequirementResult& result =
        add(RequirementKind::separation, "", fmt::format("natural frequencies apart by {:.4g}", required.separation),
            "1", required.separation);
    result.margin = result.value.emplace(infinity);
    for (std::size_t i = 0; i + 1 < oscillating.size(); ++i) {
      const double ratio = *oscillating[i + 1]->angular_frequency / *oscillating[i]->angular_frequency;
      result.candidates.push_back(
          {margin_of_least(required.separation, ratio), *oscillating[i]->angular_frequency, 0, oscillating[i]->number});
      if (ratio >= *result.value) continue;
      result.value = ratio;
      result.margin = margin_of_least(required.separation, ratio);
      result.angular_frequency = oscillating[i]->angular_frequency;
      result.detail = fmt::format("modes {} and {}", oscillating[i]->number, oscillating[i + 1]->number);
    }
  }

  void add_damping_ratio(const project::Requirements& required) {
    if (required.damping_ratio == 0) return;
    const std::size_t first = results_.size();
    RequirementResult& result =
        add(RequirementKind::damping_ratio, "", fmt::format("every damping ratio ≥ {:.4g}", required.damping_ratio),
            "1", required.damping_ratio);
    attempt(first, [&] {
      result.margin = result.value.emplace(infinity);
      for (const modal::Root& root : c_.roots().list) {
        const bool grows = root.kind == modal::RootKind::growing;
        if (!grows && !(root.kind == modal::RootKind::oscillating && root.damping_ratio)) continue;
        const double ratio = root.damping_ratio.value_or(-1);
        result.candidates.push_back({margin_of_least(required.damping_ratio, ratio), root.angular_frequency.value_or(0),
                                     0, static_cast<int>(result.candidates.size()) + 1, false});
        if (ratio >= *result.value) continue;
        result.value = ratio;
        result.margin = margin_of_least(required.damping_ratio, ratio);
        result.angular_frequency = root.angular_frequency;
        if (root.nearest_mode) result.detail = fmt::format("mode {}", *root.nearest_mode);
      }
    });
  }

  void add_decoupling(const project::Requirements& required) {
    for (const project::Requirements::Decoupling& wanted : required.decoupling) {
      const std::size_t first = results_.size();
      RequirementResult& result =
          add(RequirementKind::decoupling, wanted.body,
              fmt::format("{} decoupled by {:.4g} %", wanted.body, 100 * wanted.least), "1", wanted.least);
      attempt(first, [&] {
        const auto& bodies = c_.system.bodies();
        const auto at =
            std::find_if(bodies.begin(), bodies.end(), [&](const auto& b) { return b.name == wanted.body; });
        const modal::BodySuspension suspension =
            modal::body_suspension(c_.system, c_.assembled, to_size(at - bodies.begin()));
        result.margin = result.value.emplace(infinity);
        for (std::size_t i = 0; i < suspension.modes.size(); ++i) {
          const double share = suspension.modes[i].decoupling();
          result.candidates.push_back({margin_of_least(wanted.least, share),
                                       suspension.modes[i].angular_frequency.value_or(0), 0, static_cast<int>(i) + 1,
                                       false});
          if (share >= *result.value) continue;
          result.value = share;
          result.margin = margin_of_least(wanted.least, share);
          result.angular_frequency = suspension.modes[i].angular_frequency;
          result.detail = fmt::format("its mode {}", i + 1);
        }
      });
    }
  }

  void add_rms(const std::vector<project::AmplitudeLimit>& limits) {
    if (limits.empty()) return;
    const std::size_t first = results_.size();
    add_bounds(RequirementKind::rms, limits, "rms of ", [&](const auto& limit) { return unit_of(limit); });
    attempt(first, [&] {
      const auto* asked = analyses_.find<project::RandomQuestion>("random");
      const response::RandomLoading loading = response::random_loading(
          c_.system, c_.assembled, asked ? asked->selection.excitations : std::vector<std::string>());
      if (loading.inputs.empty()) throw without_excitation("random");
      std::vector<assembly::Channel> channels;
      for (const project::AmplitudeLimit& limit : limits)
        channels.push_back(assembly::channels(c_.system, c_.assembled, {limit.name}, limit.quantity).front());
      const response::RandomResponse found =
          response::random_response(c_.assembled, channels, loading, {}, c_.progress);
      for (std::size_t i = 0; i < limits.size(); ++i) {
        const response::RandomAnswer& answer = found.answers[i];
        RequirementResult& result = results_[first + i];
        if (answer.rms || answer.vanishes || answer.infinite_rms) {
          result.value = answer.infinite_rms ? infinity : answer.rms.value_or(0);
          result.margin = margin_of(result.allowed, *result.value);
        } else {
          result.reason = answer.reason;
        }
      }
    });
  }

  void add_largest(const std::vector<project::AmplitudeLimit>& limits) {
    for (const MotionQuantity quantity : motion_quantities) {
      std::vector<project::AmplitudeLimit> same;
      std::copy_if(limits.begin(), limits.end(), std::back_inserter(same),
                   [&](const auto& limit) { return limit.quantity == quantity; });
      if (same.empty()) continue;
      const std::size_t first = results_.size();
      add_bounds(RequirementKind::largest, same, "largest ", [&](const auto& limit) { return unit_of(limit); });
      attempt(first, [&] { set_largest(first, same, quantity); });
    }
  }

  void set_largest(std::size_t first, const std::vector<project::AmplitudeLimit>& limits, MotionQuantity quantity) {
    const auto* of_file = analyses_.find<project::TransientQuestion>("transient");
    project::TransientQuestion asked = of_file ? *of_file : project::TransientQuestion();
    asked.selection.quantity = quantity;
    asked.selection.of.clear();
    for (const project::AmplitudeLimit& limit : limits) asked.selection.of.push_back(limit.name);
    const auto found = std::any_cast<TransientResult>(transient_answer.answer(c_, asked, warnings_));
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const response::TimeCurve& curve = found.response.curves[i];
      const bool upwards = std::abs(curve.largest.value) >= std::abs(curve.smallest.value);
      const response::Extreme& extreme = upwards ? curve.largest : curve.smallest;
      RequirementResult& result = results_[first + i];
      result.value = std::abs(extreme.value);
      result.time = extreme.time;
      result.margin = margin_of(result.allowed, extreme.value);
    }
  }

  void add_static(const std::vector<project::AmplitudeLimit>& limits) {
    if (limits.empty()) return;
    const std::size_t first = results_.size();
    add_bounds(RequirementKind::static_value, limits, "at rest ", [&](const auto& limit) { return unit_of(limit); });
    attempt(first, [&] {
      std::vector<std::string> words;
      for (const project::AmplitudeLimit& limit : limits) words.push_back(limit.name);
      const response::StaticResponse rest = response::static_response(
          c_.system, c_.assembled, assembly::channels(c_.system, c_.assembled, words, MotionQuantity::displacement));
      for (std::size_t i = 0; i < limits.size(); ++i) {
        results_[first + i].value = std::abs(rest.values[i].value);
        results_[first + i].margin = margin_of(results_[first + i].allowed, rest.values[i].value);
      }
    });
  }

  const CaseContext& c_;
  const project::Analyses& analyses_;
  foundation::Problems& warnings_;
  std::vector<RequirementResult> results_;
};

}  // namespace

std::vector<RequirementResult> requirement_values(const CaseContext& context, const project::Analyses& analyses,
                                                  foundation::Problems& warnings) {
  return Judge(context, analyses, warnings).judge();
}

}  // namespace trivet::study
