// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/panel_figure.h"
#include "trivet/report/drawing/result_figures.h"

/// Measured curves over the computed ones.
namespace trivet::report {
namespace {

using study::ChannelComparison;
using study::MeasurementComparison;
using study::PeakDifference;

constexpr const char* measured_stroke =
    "stroke=\"#222\" stroke-width=\"2.4\" stroke-linecap=\"round\" "
    "stroke-dasharray=\"0.1,4\"";

/// The computed curve as the response draws it, or at the measured frequencies.
response::Curve computed_curve(const study::CaseResults& results, const MeasurementComparison& measurement,
                               const ChannelComparison& channel, std::vector<double>& omega) {
  if (measurement.of_response)
    for (const response::Curve& curve : results.response->curves.curves)
      if (curve.name == channel.result && curve.unit == channel.unit) {
        omega = results.response->curves.angular_frequency;
        return curve;
      }
  omega = channel.angular_frequency;
  return {channel.result, channel.unit, channel.computed};
}

PanelCurve amplitudes(std::string key, std::string stroke, const std::vector<double>& x, const Eigen::VectorXcd& values,
                      double factor) {
  const Eigen::VectorXd sizes = factor * values.cwiseAbs();
  return {{std::move(key)}, x, {sizes.begin(), sizes.end()}, std::move(stroke)};
}

/// Phase in degrees, with a gap where it wraps at ±180°.
PanelCurve phases(std::string key, std::string stroke, const std::vector<double>& x, const Eigen::VectorXcd& values) {
  PanelCurve curve{{std::move(key)}, {}, {}, std::move(stroke)};
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double degrees = response::phase(values(i)) * 180 / std::numbers::pi;
    if (!curve.y.empty() && std::abs(degrees - curve.y.back()) > 180) {
      curve.x.push_back(x[i]);
      curve.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    curve.x.push_back(x[i]);
    curve.y.push_back(degrees);
  }
  return curve;
}

Figure channel_figure(const study::CaseResults& results, const MeasurementComparison& measurement,
                      const ChannelComparison& channel) {
  constexpr double invisible = 1e-4;  // of the highest value
  std::vector<double> computed_at;
  const response::Curve computed = computed_curve(results, measurement, channel, computed_at);
  const auto shown = [&](const std::vector<double>& omega) {
    std::vector<double> list;
    for (const double w : omega) list.push_back(results::shown_frequency(results.display, w));
    return list;
  };
  const std::vector<double> x = shown(channel.angular_frequency), computed_x = shown(computed_at);
  const UnitPrefix unit =
      unit_prefix(channel.measured.cwiseAbs().maxCoeff(), results::amplitude_unit(results.display, channel.unit));
  const std::string measured_key = "measured " + measurement.name, computed_key = "computed " + channel.result;
  PanelRow amplitude, phase;
  amplitude.curves = {amplitudes(computed_key, series_stroke(0), computed_x, computed.value, unit.factor),
                      amplitudes(measured_key, measured_stroke, x, channel.measured, unit.factor)};
  amplitude.curves[1].key.push_back(fmt::format("FRAC {:.3f}, {:.2f} dB rms", channel.assurance, channel.rms_db));
  for (const PeakDifference& peak : channel.peaks)
    amplitude.marks.push_back(
        {results::shown_frequency(results.display, peak.angular_frequency), unit.factor * peak.amplitude, "#222",
         peak.computed ? fmt::format("{:+.1f} %", 100 * peak.frequency_difference()) : "– (no computed peak)"});
  phase.curves = {phases(computed_key, series_stroke(0), computed_x, computed.value),
                  phases(measured_key, measured_stroke, x, channel.measured)};
  amplitude.x = phase.x = {x.front(), x.back(), false, results::frequency_heading(results.display)};
  amplitude.y =
      logarithmic_axis(amplitude.curves, invisible, fmt::format("{} [{}]", quantity_name(channel.unit), unit.unit));
  phase.y = {-180, 180, false, "phase [°]"};
  const std::string title = case_title(channel.result + " and measurement " + measurement.name, results);
  return panel_figure(title, "measured-" + file_part(channel.result) + ".svg", {amplitude, phase});
}

}  // namespace

std::vector<Figure> measurement_figures(const study::CaseResults& results) {
  std::vector<Figure> figures;
  for (const MeasurementComparison& measurement : results.measurements)
    for (const ChannelComparison& channel : measurement.channels)
      if (channel.angular_frequency.size() >= 2 && !channel.vanishes)
        figures.push_back(channel_figure(results, measurement, channel));
  return figures;
}

}  // namespace trivet::report
