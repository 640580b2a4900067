// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/highest_peak.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/shown_table.h"
#include "trivet/nonlinear/branch/stable_motions.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/results/analyses/steady_parts.h"
#include "trivet/study/analyses/analysis_results.h"

namespace trivet::results {
namespace {

struct HighestPeak {
  double amplitude = 0;
  std::string of, at;  ///< result, and frequency with its unit
};

void keep_higher(std::optional<HighestPeak>& highest, double amplitude, const std::string& of, const std::string& at) {
  if (!highest || amplitude > highest->amplitude) highest = {amplitude, of, at};
}

std::string peak_frequency(const study::CaseResults& results, double omega) {
  return fmt::format("{:.5g} {}", shown_frequency(results.display, omega), frequency_unit(results.display));
}

std::string peak_text(const std::optional<HighestPeak>& highest, const DisplayUnit& unit) {
  if (!highest) return "no peak";
  const std::string amplitude = std::isinf(highest->amplitude) ? "∞" : value_text(highest->amplitude, unit);
  return fmt::format("{} {} at {}", amplitude, highest->of, highest->at);
}

std::string highest_resonance(const study::CaseResults& results, const response::Peaks& peaks) {
  const std::string& kind = peaks.curves.front().unit;
  std::optional<HighestPeak> highest;
  for (const response::Peak& peak : peaks.list)
    if (const response::CurveSummary& curve = peaks.curves[peak.curve]; curve.unit == kind)
      keep_higher(highest, peak.amplitude, curve.name, peak_frequency(results, peak.angular_frequency));
  return peak_text(highest, amplitude_unit(results.display, kind));
}

std::string highest_maximum(const study::CaseResults& results, const study::ResponseResult& response) {
  const std::string& kind = response.curves.curves.front().unit;
  std::optional<HighestPeak> highest;
  for (std::size_t c = 0; c < response.extrema.size(); ++c)
    for (const response::Extremum& extremum : response.extrema[c])
      if (const response::Curve& curve = response.curves.curves[c]; extremum.maximum && curve.unit == kind)
        keep_higher(highest, extremum.amplitude, curve.name, peak_frequency(results, extremum.angular_frequency));
  return peak_text(highest, amplitude_unit(results.display, kind));
}

std::string farthest_motion(const study::CaseResults& results, const nonlinear::SteadyBranch& branch) {
  std::optional<HighestPeak> highest;
  const std::vector<nonlinear::StableExtremes> extremes = nonlinear::stable_extremes(branch);
  for (std::size_t r = 0; r < extremes.size(); ++r)
    if (branch.units[r] == branch.units.front())
      keep_higher(highest, std::fmax(std::abs(extremes[r].largest), std::abs(extremes[r].smallest)), branch.results[r],
                  shown_quantity(varied_quantity(branch, branch.parameter(*extremes[r].at), 5), results.display));
  DisplayUnit unit = display_unit(results.display, branch.units.front());
  unit.level = " 0-p";  // the farthest from rest, to either side
  return peak_text(highest, unit);
}

}  // namespace

std::string highest_peak(const study::CaseResults& results) {
  const auto& branch = results.steady;
  if (branch && !branch->results.empty()) return farthest_motion(results, *branch);
  if (results.peaks && !results.peaks->peaks.curves.empty()) return highest_resonance(results, results.peaks->peaks);
  const bool has_curves = results.response && results.response->model && !results.response->curves.curves.empty();
  return has_curves ? highest_maximum(results, *results.response) : "";
}

std::string largest_random(const study::CaseResults& results) {
  if (!results.random || results.random->response.channels.empty()) return "";
  const auto& channels = results.random->response.channels;
  const response::RandomChannel* largest = nullptr;
  for (const response::RandomChannel& one : channels)
    if (one.unit == channels.front().unit && one.rms && (!largest || *one.rms > *largest->rms)) largest = &one;
  if (!largest) return channels.front().infinite_rms ? "∞ " + channels.front().name : "";
  return value_text(*largest->rms, root_mean_square_unit(results.display, largest->unit)) + " " + largest->name;
}

std::string largest_in_time(const study::CaseResults& results) {
  if (!results.transient || results.transient->response.curves.empty()) return "";
  const auto& curves = results.transient->response.curves;
  const response::TimeCurve* farthest = nullptr;
  response::Extreme extreme;
  for (const response::TimeCurve& one : curves)
    for (const response::Extreme& end : {one.largest, one.smallest})
      if (one.unit == curves.front().unit && (!farthest || std::abs(end.value) > std::abs(extreme.value)))
        farthest = &one, extreme = end;
  DisplayUnit unit = display_unit(results.display, farthest->unit);
  unit.level = " 0-p";
  return fmt::format("{} {} at {:.4g} s", value_text(std::abs(extreme.value), unit), farthest->name, extreme.time);
}

std::string largest_of_shocks(const study::CaseResults& results) {
  if (!results.shock_spectrum) return "";
  std::optional<HighestPeak> highest;
  std::string unit;
  for (const study::ShockSpectrumResult& one : *results.shock_spectrum)
    for (const excitation::ShockResponse& response : one.spectrum) {
      keep_higher(highest, response.maximax(), one.excitation, peak_frequency(results, response.angular_frequency));
      unit = one.unit;
    }
  return highest ? peak_text(highest, display_unit(results.display, unit)) : "";
}

}  // namespace trivet::results
