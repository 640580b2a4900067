// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/band_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/random/random_bands.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::study {
namespace {

using excitation::FrequencyBand;

assembly::Band range_of(const response::RandomLoading& loading) {
  assembly::Band range{foundation::infinity, 0};
  for (const response::RandomInput& input : loading.inputs) {
    range.from = std::min(range.from, input.spectrum.from());
    range.to = std::max(range.to, input.spectrum.to());
  }
  return range;
}

/// Share of the band in which at least one spectrum has a density.
double covered_share(const response::RandomLoading& loading, const FrequencyBand& band) {
  std::vector<assembly::Band> parts;
  for (const response::RandomInput& input : loading.inputs)
    for (const excitation::SpectrumPiece& piece : input.spectrum.pieces) {
      const assembly::Band part{std::max(piece.from, band.from()), std::min(piece.to, band.to())};
      if (part.to > part.from) parts.push_back(part);
    }
  std::ranges::sort(parts, {}, &assembly::Band::from);
  double covered = 0, to = band.from();
  for (const assembly::Band& part : parts) {
    covered += std::max(0.0, part.to - std::max(part.from, to));
    to = std::max(to, part.to);
  }
  return covered / (band.to() - band.from());
}

std::vector<FrequencyBand> judged_bands(const project::LimitLineRequest& request, const assembly::Band& range) {
  constexpr double edge = 0.5;  // an octave begins at 0.7 of its midband frequency
  const auto& points = request.line.angular_frequency;
  std::vector<FrequencyBand> bands =
      excitation::bands_between(*request.bands, std::max(range.from, edge * points.front()), range.to);
  std::erase_if(bands, [&](const FrequencyBand& band) { return !covers(request.line, band); });
  if (bands.empty())
    throw foundation::NotComputable(
        fmt::format("limit line \"{}\" runs from {:.4g} to {:.4g} Hz, the random excitation from {:.4g} to {:.4g} Hz: "
                    "they have no {} band in common",
                    request.line.name, points.front() / foundation::two_pi, points.back() / foundation::two_pi,
                    range.from / foundation::two_pi, range.to / foundation::two_pi, name(*request.bands)));
  return bands;
}

}  // namespace

double read_at(const FrequencyBand& band, const assembly::LimitLine& line) {
  constexpr double rounding = 1e-9;
  const double nominal = foundation::two_pi * band.nominal_hz();
  for (const double point : line.angular_frequency)
    if (std::abs(nominal - point) <= rounding * point) return point;
  return nominal;
}

bool covers(const assembly::LimitLine& line, const FrequencyBand& band) {
  const double at = read_at(band, line);
  return at >= line.angular_frequency.front() && at <= line.angular_frequency.back();
}

std::string partly_excited(const CaseContext& c, const project::LimitLineRequest& request,
                           const std::vector<FrequencyBand>& bands) {
  constexpr double rounding = 1e-6;
  constexpr double percent = 100;
  const response::RandomLoading loading = response::random_loading(c.system, c.assembled, request.excitations);
  std::string words;
  for (const FrequencyBand& band : bands) {
    const double share = covered_share(loading, band);
    if (share >= 1 - rounding || share <= rounding) continue;
    words += words.empty() ? "excitation covers " : ", ";
    words += fmt::format("{:.2g} % of the {:.4g} Hz band", percent * share, band.nominal_hz());
  }
  return words;
}

LimitLineResult band_line_result(const CaseContext& c, const project::LimitLineRequest& request) {
  const response::RandomLoading loading = response::random_loading(c.system, c.assembled, request.excitations);
  if (loading.inputs.empty()) throw without_excitation("random");
  const std::vector<FrequencyBand> bands = judged_bands(request, range_of(loading));
  const std::vector<assembly::Channel> channel =
      assembly::channels(c.system, c.assembled, {request.of}, quantity_of(request.line));
  const response::RandomBands found = response::random_bands(c.assembled, channel, loading, bands, {}, c.progress);
  LimitLineResult result{.of = request.of, .line = request.line, .bands = bands, .source = request.source};
  response::LimitComparison& comparison = result.comparison;
  comparison.compared = {bands.front().from(), bands.back().to()};
  comparison.margin.resize(to_index(bands.size()));
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const double at = read_at(bands[b], request.line), level = found.rms.front()[b];
    if (std::isnan(level))
      throw foundation::NotComputable(
          fmt::format("limit line \"{}\": {} has no root mean square in the band of {:.4g} Hz", request.line.name,
                      request.of, bands[b].nominal_hz()));
    const double margin = response::zero_to_peak_limit(request.line, at) / (std::numbers::sqrt2 * level);
    comparison.angular_frequency.push_back(at);
    comparison.margin(to_index(b)) = margin;
    if (margin < comparison.least_margin || b == 0) {
      comparison.least_margin = margin;
      comparison.least_margin_at = at;
    }
    if (margin >= 1) continue;
    auto& exceeded = comparison.exceeded;
    if (!exceeded.empty() && exceeded.back().to == bands[b].from()) exceeded.back().to = bands[b].to();
    else exceeded.push_back({bands[b].from(), bands[b].to()});
  }
  return result;
}

}  // namespace trivet::study
