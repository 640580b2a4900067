// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/sample_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/amplitude_range.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/report/figures/design_lines_figure.h"
#include "trivet/report/figures/share_figure.h"

namespace trivet::report {
namespace {

using study::SampledBand;
using study::Spread;

constexpr const char *shade = "#b9d7ea", *of_median = "stroke=\"#0072B2\" stroke-width=\"2\"",
                     *of_extremes = "stroke=\"#0072B2\" stroke-width=\"0.8\"",
                     *of_given = "stroke=\"#000000\" stroke-width=\"1.2\" stroke-dasharray=\"4,5\"",
                     *of_limit = "stroke=\"#D55E00\" stroke-width=\"1.5\"";

template <typename Number>
std::vector<double> list(const SampledBand& band, const Number& number) {
  std::vector<double> numbers;
  for (const Spread& one : band.spread) numbers.push_back(number(one));
  return numbers;
}

std::vector<double> low(const SampledBand& band) {
  return list(band, [](const Spread& one) { return one.low; });
}
std::vector<double> high(const SampledBand& band) {
  return list(band, [](const Spread& one) { return one.high; });
}
std::vector<double> median(const SampledBand& band) {
  return list(band, [](const Spread& one) { return one.median; });
}
std::vector<double> least(const SampledBand& band) {
  return list(band, [](const Spread& one) { return one.extremes.least; });
}
std::vector<double> largest(const SampledBand& band) {
  return list(band, [](const Spread& one) { return one.extremes.largest; });
}

std::vector<double> scaled(std::vector<double> numbers, double factor) {
  for (double& one : numbers) one *= factor;
  return numbers;
}

/// Of all curves of a panel; limits count if they are near.
AmplitudeRange range_of(const SampledBand& band) {
  const std::vector<double> lists[] = {least(band), low(band), median(band), high(band), largest(band), band.given};
  std::vector<DrawnAmplitudes> drawn;
  for (const std::vector<double>& one : lists) drawn.push_back({band.angular_frequency, one});
  AmplitudeRange range = amplitude_range(drawn);
  constexpr double near = 2;
  for (const study::BandLimit& limit : band.limits)
    if (limit.amplitude <= near * range.largest) range.largest = std::max(range.largest, limit.amplitude);
  return range;
}

Axis amplitude_axis(const AmplitudeRange& range, const UnitPrefix& unit, const std::string& name) {
  Axis axis{0, 1.06 * unit.factor * range.largest, range.is_wide(), fmt::format("{} [{}]", name, unit.unit)};
  if (axis.logarithmic) axis.from = 0.8 * unit.factor * range.bottom, axis.to = 1.6 * unit.factor * range.largest;
  if (!(axis.to > axis.from)) axis.to = axis.from + 1;
  return axis;
}

/// The part of a limit inside the panel.
PanelCurve limit_curve(const SampledBand& band, const study::BandLimit& limit, double factor,
                       const project::DisplayUnits& display) {
  const double from = std::max(limit.band.from, band.angular_frequency.front()),
               to = std::min(limit.band.to, band.angular_frequency.back());
  PanelCurve curve{{"limit"}, {}, {}, of_limit};
  if (from >= to) return {};
  for (const double omega : {from, to}) {
    curve.x.push_back(results::shown_frequency(display, omega));
    curve.y.push_back(factor * limit.amplitude);
  }
  return curve;
}

PanelRow panel_of(const SampledBand& band, const std::string& case_name, const project::DisplayUnits& display) {
  const AmplitudeRange range = range_of(band);
  const UnitPrefix unit = unit_prefix(range.largest, results::amplitude_unit(display, band.unit));
  PanelRow row;
  std::vector<double> x;
  for (const double omega : band.angular_frequency) x.push_back(results::shown_frequency(display, omega));
  row.x = {x.front(), x.back(), band.is_logarithmic, results::frequency_heading(display)};
  row.y = amplitude_axis(range, unit, quantity_name(band.unit));
  row.title = case_name.empty() ? band.name : band.name + ", case " + case_name;
  row.areas.push_back({x, scaled(low(band), unit.factor), scaled(high(band), unit.factor), shade});
  row.curves.push_back({{"5 … 95 % of the designs"}, {}, {}, fmt::format("stroke=\"{}\" stroke-width=\"9\"", shade)});
  row.curves.push_back({{"least and largest"}, x, scaled(largest(band), unit.factor), of_extremes});
  row.curves.push_back({{}, x, scaled(least(band), unit.factor), of_extremes});
  row.curves.push_back({{"median"}, x, scaled(median(band), unit.factor), of_median});
  row.curves.push_back({{"design of the file"}, x, scaled(band.given, unit.factor), of_given});
  bool has_key = false;
  for (const study::BandLimit& limit : band.limits) {
    PanelCurve curve = limit_curve(band, limit, unit.factor, display);
    if (curve.x.empty() || !(curve.y.front() <= row.y.to)) continue;
    if (has_key) curve.key.clear();
    has_key = true;
    row.curves.push_back(std::move(curve));
  }
  return row;
}

}  // namespace

std::optional<Figure> band_figure(const study::Sample& sample, const std::optional<project::DisplayUnits>& display) {
  std::vector<PanelRow> panels;
  for (const study::SampledCaseResult& one : sample.cases)
    for (const SampledBand& band : one.bands)
      if (band.angular_frequency.size() > 1)
        panels.push_back(panel_of(band, one.case_name, display.value_or(one.display)));
  if (panels.empty()) return std::nullopt;
  const std::string count = std::to_string(sample.request.designs - sample.failed);
  const std::string title = panels.size() == 1 ? fmt::format("Band of {} over {} designs", panels.front().title, count)
                                               : fmt::format("Bands over {} designs", count);
  return panel_figure(title, "bands.svg", panels);
}

std::vector<Figure> sample_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  if (!results.sample) return figures;
  if (auto bands = band_figure(*results.sample)) figures.push_back(std::move(*bands));
  if (auto shares = share_figure(*results.sample)) figures.push_back(std::move(*shares));
  if (auto lines = design_lines_figure(*results.sample)) figures.push_back(std::move(*lines));
  return figures;
}

}  // namespace trivet::report
