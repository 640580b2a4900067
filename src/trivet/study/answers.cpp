// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/free_motions.h"

namespace trivet::study {
namespace {

constexpr int deep_check_frequencies = 64;
constexpr double default_band_factor = 1.3;

/// What every question about harmonic forces shares.
struct Loaded {
  std::vector<assembly::Channel> channels;
  Eigen::VectorXcd load;
};

Loaded loaded(const model::System& system, const assembly::Assembled& assembled, const Wanted& wanted) {
  if (system.description().harmonic_forces.empty())
    throw foundation::NotComputable("response, peaks: the model has no harmonic excitation; add [excitations.NAME] with type = \"harmonic\"");
  return {assembly::channels(system, assembled, wanted.of, wanted.quantity), assembly::harmonic_load(system, assembled.layout, wanted.excitations)};
}

response::Band default_band(const modal::Modes& modes) {
  double highest = 0;
  for (const modal::Mode& mode : modes.list) highest = std::max(highest, mode.angular_frequency.value_or(0));
  return {0, highest > 0 ? default_band_factor * highest : 1.0};
}

std::vector<Eigen::VectorXd> phases(const assembly::Assembled& assembled, const Loaded& asked, const response::FrequencyResponse& response,
                                    const modal::Roots& roots, const response::Peaks& peaks, bool continuous) {
  std::vector<Eigen::VectorXd> result;
  if (!continuous) {
    for (const response::Curve& curve : response.curves) result.push_back(curve.value.unaryExpr([](const std::complex<double>& z) { return response::phase(z); }).real());
    return result;
  }
  // Counted from ω = 0 along a grid that no turn can hide in, whatever points were asked for.
  const auto& asked_at = response.angular_frequency;
  const double top = *std::max_element(asked_at.begin(), asked_at.end());
  std::vector<double> grid = response::automatic_grid(assembled, asked.channels, asked.load, roots.poles, peaks, {0, top});
  grid.insert(grid.end(), asked_at.begin(), asked_at.end());
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  const response::FrequencyResponse dense = response::frequency_response(assembled, asked.channels, asked.load, grid);
  for (const response::Curve& curve : dense.curves) {
    const Eigen::VectorXd along = response::continuous_phase(curve.value);
    Eigen::VectorXd at(static_cast<Eigen::Index>(asked_at.size()));
    for (std::size_t i = 0; i < asked_at.size(); ++i)
      at(static_cast<Eigen::Index>(i)) = along(std::lower_bound(grid.begin(), grid.end(), asked_at[i]) - grid.begin());
    result.push_back(at);
  }
  return result;
}

class CaseStudy {
 public:
  CaseStudy(const Case& variant, const foundation::Progress& progress)
      : system_(variant.system), progress_(progress), assembled_(assembly::assemble(variant.system)), modes_(modal::modes(system_, assembled_)),
        roots_(modal::roots(system_, assembled_, modes_)) {}

  Answers answer(const Case& variant, const Analyses& analyses) {
    Answers result;
    result.case_name = variant.name;
    result.changes = variant.changes;
    result.free_motions = modal::free_motions(system_, assembled_, modes_);
    result.modes = modes_;
    result.roots = roots_;
    result.warnings = variant.warnings;
    result.warnings.add(modes_.warnings);
    result.warnings.add(roots_.warnings);
    if (analyses.peaks) result.peaks = PeaksAnswer{peaks_of(analyses.peaks->wanted, analyses.peaks->min_prominence), analyses.peaks->min_prominence, analyses.peaks->peak_tolerance};
    if (analyses.response) {
      result.response = response_of(*analyses.response);
      result.limits = limits_of(analyses, *result.response);
    }
    if (analyses.static_of)
      result.statics = response::static_response(system_, assembled_, assembly::channels(system_, assembled_, *analyses.static_of, assembly::Quantity::displacement));
    return result;
  }

 private:
  response::Peaks peaks_of(const Wanted& wanted, double min_prominence) const {
    const Loaded asked = loaded(system_, assembled_, wanted);
    return response::peaks(assembled_, asked.channels, asked.load, modes_, roots_, {min_prominence}, progress_);
  }

  ResponseAnswer response_of(const ResponseRequest& request) const {
    const Loaded asked = loaded(system_, assembled_, request.wanted);
    ResponseAnswer result;
    result.quantity = request.wanted.quantity;
    const bool needs_peaks = request.at.empty() ? request.spacing == response::Spacing::automatic : request.continuous_phase;
    const response::Peaks peaks = needs_peaks || request.continuous_phase
                                      ? response::peaks(assembled_, asked.channels, asked.load, modes_, roots_, {}, progress_)
                                      : response::Peaks{};
    std::vector<double> grid = request.at;
    if (grid.empty()) {
      result.band = request.band ? *request.band : default_band(modes_);
      if (request.spacing == response::Spacing::linear) grid = response::linear_grid(result.band, request.points);
      else if (request.spacing == response::Spacing::automatic)
        grid = response::automatic_grid(assembled_, asked.channels, asked.load, roots_.poles, peaks, result.band);
      else {
        if (!(result.band.from > 0)) throw foundation::NotComputable("response: a logarithmic grid needs a band that starts above 0");
        grid = response::logarithmic_grid(result.band, request.points);
      }
    } else {
      result.band = {*std::min_element(grid.begin(), grid.end()), *std::max_element(grid.begin(), grid.end())};
    }
    foundation::report_progress(progress_, "response", 0.5);
    result.curves = response::frequency_response(assembled_, asked.channels, asked.load, grid);
    result.phase = phases(assembled_, asked, result.curves, roots_, peaks, request.continuous_phase);
    foundation::report_progress(progress_, "check by a second solver", 0.8);
    const std::vector<double> samples = request.at.empty()
                                            ? response::check_frequencies(roots_.poles, result.band.from, result.band.to, deep_check_frequencies)
                                            : std::vector<double>(grid.begin(), grid.begin() + std::min<std::ptrdiff_t>(std::ssize(grid), deep_check_frequencies));
    result.deep = response::deep_check(system_, assembled_, asked.load, samples);
    return result;
  }

  std::vector<LimitAnswer> limits_of(const Analyses& analyses, const ResponseAnswer& response) const {
    std::vector<LimitAnswer> result;
    for (const Limit& limit : analyses.limits) {
      const Wanted wanted{{limit.name}, response.quantity, analyses.response->wanted.excitations};
      const Loaded asked = loaded(system_, assembled_, wanted);
      const response::Peaks found = response::peaks(assembled_, asked.channels, asked.load, modes_, roots_, {}, progress_);
      LimitAnswer answer{limit.name, asked.channels[0].unit, limit.amplitude, 0, 0, found.curves[0].highest, true};
      std::vector<double> candidates = {response.band.from, response.band.to};
      for (const response::Peak& peak : found.list)
        if (peak.angular_frequency > response.band.from && peak.angular_frequency < response.band.to) {
          candidates.push_back(peak.angular_frequency);
          if (std::isinf(peak.amplitude)) answer.in_band = peak.amplitude, answer.in_band_at = peak.angular_frequency;
        }
      const auto values = response::frequency_response(assembled_, asked.channels, asked.load, candidates);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double amplitude = std::abs(values.curves[0].value(static_cast<Eigen::Index>(i)));
        if (amplitude > answer.in_band) answer.in_band = amplitude, answer.in_band_at = candidates[i];
      }
      answer.kept = answer.in_band <= answer.limit;
      result.push_back(answer);
    }
    return result;
  }

  const model::System& system_;
  const foundation::Progress& progress_;
  assembly::Assembled assembled_;
  modal::Modes modes_;
  modal::Roots roots_;
};

}  // namespace

Answers answers(const Case& variant, const Analyses& analyses, const foundation::Progress& progress) {
  return CaseStudy(variant, progress).answer(variant, analyses);
}

response::DeepCheck deep_check(const Case& variant) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  const modal::Modes modes = modal::modes(variant.system, assembled);
  const modal::Roots roots = modal::roots(variant.system, assembled, modes);
  const auto& request = variant.analyses.response;
  const response::Band band = request && request->band ? *request->band : default_band(modes);
  Eigen::VectorXcd load = assembly::harmonic_load(variant.system, assembled.layout);
  if (load.cwiseAbs().maxCoeff() == 0) load = numerics::unit_scale(assembled.matrices.A).cwiseInverse().cast<std::complex<double>>();
  return response::deep_check(variant.system, assembled, load, response::check_frequencies(roots.poles, band.from, band.to, deep_check_frequencies));
}

double relative_prominence(const response::Peak& peak) {
  const double minimum = peak.amplitude - peak.prominence;
  return std::isinf(peak.amplitude) || !(minimum > 0) ? std::numeric_limits<double>::infinity() : peak.prominence / minimum;
}

}  // namespace trivet::study
