// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/curve_requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/study/nearest_to_line.h"

namespace trivet::study {
namespace {

using assembly::MotionQuantity;
using foundation::infinity;

class CurveRequirements {
 public:
  CurveRequirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list)
      : c_(context), analyses_(analyses), list_(list) {}

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

  void add_amplitudes(const std::vector<project::AmplitudeLimit>& limits, const response::Band& band,
                      const std::vector<std::string>& excitations) {
    if (limits.empty()) return;
    const std::size_t first = list_.size();
    list_.add_bounds(c_, RequirementKind::amplitude, limits, "");
    list_.attempt(first, [&] { set_amplitudes(first, limits, band, excitations); });
  }

  void set_amplitudes(std::size_t first, const std::vector<project::AmplitudeLimit>& limits, const response::Band& band,
                      const std::vector<std::string>& excitations) {
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
  }

  void add_no_peak(const project::Requirements& required) {
    if (required.no_peak.empty()) return;
    const std::size_t first = list_.size();
    const std::vector<assembly::Channel> channels =
        assembly::channels(c_.system, c_.assembled, required.no_peak, required.quantity);
    design::RuleSet set;
    set.min_prominence = required.min_prominence;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      set.rules.push_back({design::DesignRule::Kind::no_peak, i, required.peak_tolerance});
      list_.add(RequirementKind::no_peak, channels[i].name, "no peak of " + channels[i].name, "1",
                required.peak_tolerance);
    }
    list_.attempt(first, [&] {
      set_rule_values(first, set, channels, std::vector(channels.size(), required.quantity), required.excitations);
    });
  }

  void add_limit_lines(const project::Requirements& required) {
    for (const project::LimitLineRequest& line : analyses_.limit_lines) {
      const auto& named = required.limit_lines;
      const bool asked =
          !analyses_.requirements || std::find(named.begin(), named.end(), line.line.name) != named.end();
      if (!asked || !analyses_.response) continue;
      const std::size_t first = list_.size();
      RequirementResult& result = list_.add(RequirementKind::limit_line, line.of,
                                            fmt::format("{} within \"{}\"", line.of, line.line.name), "1", 1);
      list_.attempt(first, [&] {
        const response::Band band = required.band ? *required.band
            : analyses_.response->band            ? *analyses_.response->band
                                                  : default_band(c_);
        const LimitLineResult found = limit_line_answer(c_, {line}, analyses_.response->selection, band).front();
        result.margin = found.comparison.least_margin;
        result.value = result.margin > 0 ? 1 / result.margin : infinity;  // share of the line
        result.angular_frequency = found.comparison.least_margin_at;
        result.quantity = quantity_of(line.line);
        result.excitations = analyses_.response->selection.excitations;
        result.candidates = maxima_below_line(result, line.line, found.comparison);
      });
    }
  }

 private:
  void set_rule_values(std::size_t first, const design::RuleSet& set, const std::vector<assembly::Channel>& channels,
                       const std::vector<MotionQuantity>& quantities, const std::vector<std::string>& excitations) {
    const assembly::Loading loading = assembly::harmonic_loading(c_.system, c_.assembled, excitations);
    if (loading.vanishes()) throw without_excitation("response, peaks");
    const response::Peaks found = peaks_of(channels, loading, set.band, set.min_prominence);
    const design::RuleValues values = design::rule_values(c_.assembled, channels, loading, found, set);
    for (std::size_t i = 0; i < set.rules.size(); ++i) {
      RequirementResult& result = list_[first + i];
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

  /// The places where a curve comes near its line, refined: their frequencies decide the slopes.
  std::vector<RequirementResult::Candidate> maxima_below_line(const RequirementResult& result,
                                                              const response::LimitLine& line,
                                                              const response::LimitComparison& found) const {
    constexpr double near = 2;  // times the least margin
    const DrivenResult driven(c_.system, c_.assembled, result.subject, result.quantity, result.excitations);
    std::vector<RequirementResult::Candidate> places;
    const auto margin = [&](std::size_t i) { return found.margin(to_index(i)); };
    for (std::size_t i = 0; i < found.angular_frequency.size(); ++i) {
      const bool least = (i == 0 || margin(i) < margin(i - 1)) &&
          (i + 1 == found.angular_frequency.size() || margin(i) <= margin(i + 1));
      if (!least || !(margin(i) > 0 && margin(i) <= near * found.least_margin)) continue;
      const ComparedPlace place =
          nearest_to_line(driven, line, found.compared, {found.angular_frequency[i], margin(i)});
      places.push_back({place.margin, place.angular_frequency, 0, 0});
    }
    return places;
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

  /// Peaks of channels over the whole axis, at least over the band.
  response::Peaks peaks_of(const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                           const response::Band& band, double min_prominence) const {
    return response::peaks(c_.assembled, channels, loading, c_.modes, c_.roots(),
                           {.min_prominence = min_prominence, .search_to = std::isfinite(band.to) ? band.to : 0},
                           c_.progress);
  }

  const CaseContext& c_;
  const project::Analyses& analyses_;
  RequirementList& list_;
};

}  // namespace

void set_amplitudes(const CaseContext& context, const project::Analyses& analyses, std::size_t first,
                    const std::vector<project::AmplitudeLimit>& limits, RequirementList& list) {
  const project::Requirements required = analyses.requirements.value_or(project::Requirements());
  CurveRequirements(context, analyses, list)
      .set_amplitudes(first, limits, required.band.value_or(response::Band{0, infinity}), required.excitations);
}

void add_curve_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list) {
  const project::Requirements none;
  const project::Requirements& required = analyses.requirements ? *analyses.requirements : none;
  CurveRequirements curves(context, analyses, list);
  curves.add_limits_of_file();
  curves.add_amplitudes(required.limits, required.band.value_or(response::Band{0, infinity}), required.excitations);
  curves.add_no_peak(required);
  curves.add_limit_lines(required);
}

}  // namespace trivet::study
