// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "trivet/assembly/band_ends.h"
#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/study/analyses/band_lines.h"
#include "trivet/study/requirements/band_words.h"
#include "trivet/study/requirements/nearest_to_line.h"
#include "trivet/study/requirements/requirement_list.h"

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
      limits.push_back({.name = limit.name,
                        .quantity = response ? response->selection.quantity : MotionQuantity::displacement,
                        .amplitude = limit.amplitude,
                        .place = {"limits", limit.name}});
    const assembly::Band all{0, infinity};
    add_amplitudes(limits, response ? response->band.value_or(all) : all,
                   response ? response->selection.excitations : std::vector<std::string>());
  }

  void add_amplitudes(const std::vector<project::AmplitudeLimit>& limits, const assembly::Band& band,
                      const std::vector<std::string>& excitations) {
    for (const project::AmplitudeLimit& limit : limits)
      if (limit.speed) add_under_orders(limit);
    std::vector<project::AmplitudeLimit> harmonic;
    std::ranges::copy_if(limits, std::back_inserter(harmonic),
                         [](const project::AmplitudeLimit& limit) { return !limit.speed; });
    if (harmonic.empty()) return;
    const std::size_t first = list_.size();
    list_.add_bounds(c_, RequirementKind::amplitude, harmonic, "");
    for (std::size_t i = 0; i < harmonic.size(); ++i)
      if (!harmonic[i].has_common_scope()) list_[first + i].words.scope += scope_words(harmonic[i]);
    set_amplitudes(first, harmonic, band, excitations);
  }

  /// One requirement for each order of the shaft; one that is not judged if no order acts.
  void add_under_orders(const project::AmplitudeLimit& limit) {
    const std::vector<std::string> excitations = limit.excitations.value_or(std::vector<std::string>());
    constexpr double rpm = foundation::rpm_per_rad_s;
    const std::string speeds = fmt::format("{:.5g} … {:.5g} rpm", limit.speed->from * rpm, limit.speed->to * rpm);
    const std::size_t first = list_.size();
    list_.add_bounds(c_, RequirementKind::amplitude, {limit}, "");
    list_[first].words.scope += " in the orders of " + speeds;
    list_[first].excitations = excitations;
    std::vector<double> orders;
    list_.attempt(first, [&] {
      for (const response::OrderLoading& one : response::order_loadings(c_.system, c_.assembled, excitations))
        if (!one.loading.vanishes()) orders.push_back(one.order);
      if (orders.empty()) throw foundation::NotComputable("no order acts: every excitation by the shaft is zero");
    });
    for (std::size_t i = 0; i < orders.size(); ++i) {
      const std::size_t place = first + i;
      if (i > 0) list_.add_bounds(c_, RequirementKind::amplitude, {limit}, "");
      RequirementResult& result = list_[place];
      result.words.scope = fmt::format(" in order {:.6g} of ", orders[i]) + speeds;
      result.order = orders[i];
      result.band = {orders[i] * limit.speed->from, orders[i] * limit.speed->to};
      result.excitations = excitations;
      list_.attempt(place, [&] { set_amplitudes_together({place}, {limit}); });
    }
  }

  /// Those with the same drive and band together.
  void set_amplitudes(std::size_t first, const std::vector<project::AmplitudeLimit>& limits, const assembly::Band& band,
                      const std::vector<std::string>& excitations) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      RequirementResult& result = list_[first + i];
      result.band = limits[i].band.value_or(band);
      result.excitations = limits[i].excitations.value_or(excitations);
    }
    std::vector<bool> is_set(limits.size(), false);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      std::vector<std::size_t> places;
      std::vector<project::AmplitudeLimit> same;
      for (std::size_t j = i; j < limits.size(); ++j) {
        if (is_set[j] || !have_same_drive(list_[first + i], list_[first + j])) continue;
        is_set[j] = true;
        places.push_back(first + j);
        same.push_back(limits[j]);
      }
      if (!places.empty()) list_.attempt(places, [&] { set_amplitudes_together(places, same); });
    }
  }

  void set_amplitudes_together(const std::vector<std::size_t>& places,
                               const std::vector<project::AmplitudeLimit>& limits) {
    std::vector<assembly::Channel> channels;
    std::vector<MotionQuantity> quantities;
    design::RuleSet set;
    set.band = list_[places.front()].band;
    for (const project::AmplitudeLimit& limit : limits) {
      quantities.push_back(limit.quantity);
      set.rules.push_back({design::DesignRule::Kind::amplitude, channels.size(), limit.amplitude});
      channels.push_back(assembly::channels(c_.system, c_.assembled, {limit.name}, limit.quantity).front());
    }
    set_rule_values(places, set, channels, quantities);
  }

  void add_no_peak(const project::Requirements& required) {
    if (required.no_peak.empty()) return;
    const std::size_t first = list_.size();
    const std::vector<assembly::Channel> channels =
        assembly::channels(c_.system, c_.assembled, required.no_peak, required.quantity);
    std::vector<std::size_t> places;
    design::RuleSet set;
    set.min_prominence = required.min_prominence;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      set.rules.push_back({design::DesignRule::Kind::no_peak, i, required.peak_tolerance});
      list_.add(RequirementKind::no_peak, channels[i].name, "no peak of " + channels[i].name, "1",
                required.peak_tolerance);
      list_[first + i].band = {0, infinity};
      list_[first + i].excitations = required.excitations;
      places.push_back(first + i);
    }
    list_.attempt(places,
                  [&] { set_rule_values(places, set, channels, std::vector(channels.size(), required.quantity)); });
  }

  void add_limit_lines(const project::Requirements& required) {
    for (const project::LimitLineRequest& line : analyses_.limit_lines) {
      const auto& named = required.limit_lines;
      const bool request = !analyses_.requirements || std::ranges::find(named, line.line.name) != named.end();
      const auto& response = analyses_.response;
      if (!request) continue;
      if (line.bands) {
        add_band_line(line);
        continue;
      }
      if (!(response || required.band)) continue;
      const std::size_t first = list_.size();
      RequirementResult& result =
          list_.add(RequirementKind::limit_line, line.of, {line.of, "within \"" + line.line.name + "\""}, "1", 1);
      result.line = line.line.name;
      list_.attempt(first, [&] {
        const assembly::Band band = required.band ? *required.band
            : response->band                      ? *response->band
                                                  : default_band(c_);
        project::ChannelSelection selection{.excitations = required.excitations};
        if (response) selection = response->selection;
        const LimitLineResult found = limit_line_results(c_, {line}, selection, band).front();
        result.margin = found.comparison.least_margin;
        result.value = result.margin > 0 ? 1 / result.margin : infinity;  // share of the line
        result.angular_frequency = found.comparison.least_margin_at;
        result.quantity = quantity_of(line.line);
        result.excitations = selection.excitations;
        const std::vector<double>& points = line.line.angular_frequency;
        result.band = {std::max(band.from, points.front()), std::min(band.to, points.back())};
        result.on_line = on_line(line.line, found.comparison.least_margin_at);
        result.candidates = maxima_below_line(result, line.line, found.comparison);
      });
    }
  }

 private:
  void add_band_line(const project::LimitLineRequest& line) {
    const std::size_t place = list_.size();
    list_.add(RequirementKind::band_line, line.of, {line.of, "within \"" + line.line.name + "\""}, "1", 1).line =
        line.line.name;
    list_.attempt(place, [&] {
      const LimitLineResult found = band_line_result(c_, line);
      RequirementResult& result = list_[place];
      result.margin = found.comparison.least_margin;
      result.value = result.margin > 0 ? 1 / result.margin : infinity;  // share of the line
      result.angular_frequency = found.comparison.least_margin_at;
      result.quantity = quantity_of(line.line);
      result.excitations = line.excitations;
      result.detail = judged_part(line, found);
      if (const std::string partly = partly_excited(c_, line, found.bands); !partly.empty())
        result.detail += (result.detail.empty() ? "" : "; ") + partly;
      result.on_line = on_line(line.line, found.comparison.least_margin_at);
    });
  }

  static RequirementResult::OnLine on_line(const assembly::LimitLine& line, double at) {
    const double limit = response::zero_to_peak_limit(line, at);
    return {line.rms ? limit / std::numbers::sqrt2 : limit, line.unit, line.rms};
  }

  /// "judged in 50 … 63 Hz of 1 … 80 Hz" if the bands do not cover the line; else empty.
  static std::string judged_part(const project::LimitLineRequest& line, const LimitLineResult& found) {
    using assembly::same_end;
    const auto& points = line.line.angular_frequency;
    const auto& bands = found.bands;
    const double from = points.front() / foundation::two_pi, to = points.back() / foundation::two_pi;
    const auto beside = [&](int by) {
      return excitation::FrequencyBand{bands.front().width, (by < 0 ? bands.front() : bands.back()).index + by}
          .nominal_hz();
    };
    if (beside(-1) < from * (1 - same_end) && beside(1) > to * (1 + same_end)) return "";
    return fmt::format("judged in {:.4g} … {:.4g} Hz of {:.4g} … {:.4g} Hz", bands.front().nominal_hz(),
                       bands.back().nominal_hz(), from, to);
  }

  /// " in 20 … 26 Hz under run"
  static std::string scope_words(const project::AmplitudeLimit& limit) {
    std::string words;
    if (limit.band) words += " in " + hertz_words(*limit.band);
    if (limit.excitations) words += " under " + foundation::comma_separated(*limit.excitations);
    return words;
  }

  /// @param places  of results with the same drive
  void set_rule_values(const std::vector<std::size_t>& places, const design::RuleSet& set,
                       const std::vector<assembly::Channel>& channels, const std::vector<MotionQuantity>& quantities) {
    const assembly::Loading loading = requirement_curve(c_.system, c_.assembled, list_[places.front()]).loading;
    if (loading.vanishes()) throw without_excitation("response, peaks");
    const response::Peaks found = peaks_of(channels, loading, set.band, set.min_prominence);
    const design::RuleValues values = design::rule_values(c_.assembled, channels, loading, found, set);
    for (std::size_t i = 0; i < set.rules.size(); ++i) {
      RequirementResult& result = list_[places[i]];
      result.value = values.values[i];
      result.margin = design::margin(set.rules[i], values.values[i]);
      if (std::isfinite(values.angular_frequencies[i])) result.angular_frequency = values.angular_frequencies[i];
      result.quantity = quantities[i];
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
                                                              const assembly::LimitLine& line,
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
                           const assembly::Band& band, double min_prominence) const {
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
      .set_amplitudes(first, limits, required.band.value_or(assembly::Band{0, infinity}), required.excitations);
}

void add_curve_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list) {
  const project::Requirements none;
  const project::Requirements& required = analyses.requirements ? *analyses.requirements : none;
  CurveRequirements curves(context, analyses, list);
  curves.add_limits_of_file();
  curves.add_amplitudes(required.limits, required.band.value_or(assembly::Band{0, infinity}), required.excitations);
  curves.add_no_peak(required);
  curves.add_limit_lines(required);
}

}  // namespace trivet::study
