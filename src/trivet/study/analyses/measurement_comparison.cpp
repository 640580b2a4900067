// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/measurement_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/peaks/peak_count.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

double decibels(double ratio) { return 20 * std::log10(ratio); }

/// True if no harmonic excitation of the response but this one acts; "" stands for those of the response.
bool is_excited_as(const model::System& system, const project::ChannelSelection& selection,
                   const std::string& excitation) {
  const auto& all = system.description().excitations;
  return excitation.empty() || std::ranges::all_of(all, [&](const model::Excitation& one) {
           const bool acts =
               model::is_selected(one, selection.excitations) && project::drives(one, project::Drive::harmonic);
           return acts == (one.name == excitation);
         });
}

/// The lines of a measured curve inside the band.
ChannelComparison lines_inside(const project::MeasuredCurve& curve, const assembly::Band& band) {
  ChannelComparison inside{.result = curve.result, .source = curve.source};
  std::vector<std::complex<double>> values;
  std::vector<double> coherence;
  for (std::size_t i = 0; i < curve.angular_frequency.size(); ++i) {
    if (!project::covers(band, curve.angular_frequency[i])) continue;
    inside.angular_frequency.push_back(curve.angular_frequency[i]);
    values.push_back(curve.value(to_index(i)));
    if (curve.coherence.size() > 0) coherence.push_back(curve.coherence(to_index(i)));
  }
  inside.measured = Eigen::Map<const Eigen::VectorXcd>(values.data(), to_index(values.size()));
  inside.coherence = Eigen::Map<const Eigen::VectorXd>(coherence.data(), to_index(coherence.size()));
  if (inside.coherence.size() > 0) inside.mean_coherence = inside.coherence.mean();
  return inside;
}

void set_differences(ChannelComparison& channel) {
  double squares = 0;
  Eigen::Index lines = 0;
  channel.largest_db = no_value;
  for (Eigen::Index i = 0; i < channel.measured.size(); ++i) {
    const double level = decibels(std::abs(channel.measured(i)) / std::abs(channel.computed(i)));
    if (!std::isfinite(level)) continue;
    squares += level * level;
    ++lines;
    if (lines > 1 && !(std::abs(level) > std::abs(channel.largest_db))) continue;
    channel.largest_db = level;
    channel.largest_at = channel.angular_frequency[i];
  }
  channel.rms_db = lines > 0 ? std::sqrt(squares / static_cast<double>(lines)) : no_value;
  channel.assurance = assurance(channel.measured, channel.computed);
}

void set_peaks(ChannelComparison& channel, const response::Peaks& computed, std::size_t curve) {
  channel.peaks = measured_peaks(channel.angular_frequency, channel.measured, channel.coherence);
  for (PeakDifference& peak : channel.peaks)
    for (const response::Peak& one : computed.list) {
      if (one.curve != curve) continue;
      const double distance = std::abs(one.angular_frequency - peak.angular_frequency);
      if (!peak.computed || distance < std::abs(peak.computed->angular_frequency - peak.angular_frequency))
        peak.computed = one;
    }
}

/// Sets the computed curves; channels with the same frequencies are solved together.
void set_computed(const CaseContext& c, const std::vector<assembly::Channel>& channels,
                  const assembly::Loading& loading, std::vector<ChannelComparison>& compared) {
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (compared[i].computed.size() > 0) continue;
    std::vector<std::size_t> together;
    std::vector<assembly::Channel> solved;
    for (std::size_t k = i; k < compared.size(); ++k)
      if (compared[k].angular_frequency == compared[i].angular_frequency) {
        together.push_back(k);
        solved.push_back(channels[k]);
      }
    const response::FrequencyResponse found =
        response::frequency_response(c.assembled, solved, loading, compared[i].angular_frequency);
    for (std::size_t k = 0; k < together.size(); ++k) compared[together[k]].computed = found.curves[k].value;
  }
}

std::vector<ChannelComparison> channel_comparisons(const CaseContext& c, const project::Measurement& measurement,
                                                   const project::ChannelSelection& selection,
                                                   const assembly::Band& band) {
  std::vector<ChannelComparison> compared;
  std::vector<std::string> names;
  for (const project::MeasuredCurve& curve : measurement.curves) {
    ChannelComparison channel = lines_inside(curve, band);
    if (channel.angular_frequency.empty()) continue;
    names.push_back(curve.result);
    compared.push_back(std::move(channel));
  }
  if (compared.empty() && !measurement.curves.empty())
    throw foundation::NotComputable(fmt::format(
        "measurements.{}: no measured frequency in the band of the response, {:.6g} to {:.6g} Hz; widen the band",
        measurement.name, band.from / foundation::two_pi, band.to / foundation::two_pi));
  if (compared.empty()) return compared;
  const std::vector<std::string> excitations =
      measurement.excitation.empty() ? selection.excitations : std::vector<std::string>{measurement.excitation};
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, excitations);
  const auto channels = assembly::channels(c.system, c.assembled, names, selection.quantity);
  const response::Peaks peaks =
      response::peaks(c.assembled, channels, loading, c.modes, c.roots(), {.search_to = band.to}, c.progress);
  set_computed(c, channels, loading, compared);
  for (std::size_t i = 0; i < compared.size(); ++i) {
    ChannelComparison& channel = compared[i];
    channel.unit = channels[i].unit;
    channel.vanishes = peaks.curves[i].vanishes;
    if (channel.vanishes) channel.rms_db = channel.largest_db = channel.assurance = no_value;
    else set_differences(channel), set_peaks(channel, peaks, i);
  }
  return compared;
}

/// The measured components of a computed mode, in ground axes.
Eigen::VectorXcd components_of(const CaseContext& c, const modal::Mode& mode,
                               const std::vector<project::ShapeComponent>& components) {
  Eigen::VectorXcd shape(to_index(components.size()));
  for (std::size_t i = 0; i < components.size(); ++i) {
    const project::ShapeComponent& one = components[i];
    const spatial::Vector6 moved =
        spatial::rigid_motion(one.at) * mode.shape.segment<6>(6 * to_index(one.body)).matrix();
    shape(to_index(i)) = (c.system.bodies()[one.body].pose.rotation * moved.head<3>())(one.axis);
  }
  return shape;
}

/// The computed mode of a measured one: that with the largest assurance; of those that are as like it as measured
/// shapes can tell, that with the nearest natural frequency.
std::optional<std::size_t> counterpart_of(const project::MeasuredMode& measured, const Eigen::RowVectorXd& likeness,
                                          const std::vector<modal::Mode>& modes) {
  constexpr double indistinct = 0.01;  // of the assurance: noise and a direction some degrees off change it by as much
  double largest = 0;                  // a mode that no measured component sees has none
  for (const double one : likeness)
    if (one > largest) largest = one;
  std::optional<std::size_t> nearest;
  double least = foundation::infinity;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    if (!(likeness(to_index(k)) > 0) || likeness(to_index(k)) < largest - indistinct) continue;
    const double ratio = modes[k].angular_frequency.value_or(0) / measured.angular_frequency;
    const double distance = ratio > 0 && std::isfinite(ratio) ? std::abs(std::log(ratio)) : foundation::infinity;
    const bool more_alike = nearest && distance == least && likeness(to_index(k)) > likeness(to_index(*nearest));
    if (nearest && !(distance < least) && !more_alike) continue;
    nearest = k;
    least = distance;
  }
  return nearest;
}

void add_shapes(const CaseContext& c, const project::Measurement& measurement, MeasurementComparison& result) {
  result.components = measurement.components.size();
  result.assurance.resize(to_index(measurement.modes.size()), to_index(c.modes.list.size()));
  for (std::size_t m = 0; m < measurement.modes.size(); ++m) {
    const project::MeasuredMode& measured = measurement.modes[m];
    ShapeComparison best{measured.number, measured.angular_frequency, measured.damping_ratio};
    for (std::size_t k = 0; k < c.modes.list.size(); ++k)
      result.assurance(to_index(m), to_index(k)) =
          assurance(measured.shape, components_of(c, c.modes.list[k], measurement.components));
    if (const auto found = counterpart_of(measured, result.assurance.row(to_index(m)), c.modes.list)) {
      best.mode = c.modes.list[*found].number;
      best.angular_frequency = c.modes.list[*found].angular_frequency;
      best.assurance = result.assurance(to_index(m), to_index(*found));
    }
    result.shapes.push_back(best);
  }
}

/// The top of a parabola through 1/|m|² at three neighbouring lines.
PeakDifference top_between_lines(const std::vector<double>& omega, const std::vector<double>& heights, std::size_t i) {
  const auto inverse = [&](std::size_t k) { return 1 / (heights[k] * heights[k]); };
  const double left = omega[i - 1] - omega[i], right = omega[i + 1] - omega[i];
  const double slope_left = (inverse(i - 1) - inverse(i)) / left, slope_right = (inverse(i + 1) - inverse(i)) / right;
  const double curvature = (slope_right - slope_left) / (right - left), slope = slope_left - curvature * left;
  PeakDifference peak{omega[i], heights[i], 0.5 * (right - left)};
  if (!(curvature > 0)) return peak;
  const double shift = -slope / (2 * curvature), lowest = inverse(i) + 0.5 * slope * shift;
  if (!(lowest > 0) || !(shift > left && shift < right)) return peak;  // a top narrower than the lines are apart
  peak.angular_frequency += shift;
  peak.amplitude = 1 / std::sqrt(lowest);
  return peak;
}

}  // namespace

double PeakDifference::frequency_difference() const {
  return computed ? angular_frequency / computed->angular_frequency - 1 : no_value;
}

double PeakDifference::height_db() const {
  return computed && std::isfinite(computed->amplitude) ? decibels(amplitude / computed->amplitude) : no_value;
}

double ShapeComparison::frequency_difference() const {
  return angular_frequency && *angular_frequency > 0 ? measured_frequency / *angular_frequency - 1 : no_value;
}

double assurance(const Eigen::VectorXcd& measured, const Eigen::VectorXcd& computed) {
  const double size = measured.norm() * computed.norm();
  if (!(size > 0) || !std::isfinite(size)) return no_value;
  return std::norm(computed.normalized().dot(measured.normalized()));
}

std::vector<PeakDifference> measured_peaks(const std::vector<double>& angular_frequency,
                                           const Eigen::VectorXcd& measured, const Eigen::VectorXd& coherence) {
  constexpr double rise = 1.2, lowest_share = 0.01, least_coherence = 0.8;
  const Eigen::VectorXd sizes = measured.cwiseAbs();
  const std::vector<double> heights(sizes.begin(), sizes.end()), prominences = numerics::prominences(heights);
  const double least = heights.empty() ? 0 : lowest_share * sizes.maxCoeff();
  std::vector<PeakDifference> peaks;
  for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
    if (!(heights[i] > heights[i - 1] && heights[i] >= heights[i + 1])) continue;
    if (heights[i] < least) continue;
    if (coherence.size() > 0 && coherence(to_index(i)) < least_coherence) continue;
    if (heights[i] < rise * (heights[i] - prominences[i])) continue;
    peaks.push_back(top_between_lines(angular_frequency, heights, i));
  }
  return peaks;
}

std::vector<MeasurementComparison> measurement_comparisons(const CaseContext& context,
                                                           const project::Analyses& analyses,
                                                           const assembly::Band& band) {
  std::vector<MeasurementComparison> results;
  for (const auto& measurement : analyses.measurements) {
    MeasurementComparison result{
        .name = measurement->name, .file = measurement->file, .excitation = measurement->excitation, .band = band};
    result.of_response = is_excited_as(context.system, analyses.response->selection, measurement->excitation);
    result.channels = channel_comparisons(context, *measurement, analyses.response->selection, band);
    add_shapes(context, *measurement, result);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace trivet::study
