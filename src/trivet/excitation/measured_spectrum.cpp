// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/measured_spectrum.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {
namespace {

constexpr std::size_t fewest_samples = 8;

bool has_small_factors(std::size_t n) {
  for (const std::size_t factor : {2, 3, 5})
    while (n % factor == 0) n /= factor;
  return n == 1;
}

/// Even, so that neighbours overlap by half.
std::size_t segment_length(double least) {
  std::size_t n = 2 * static_cast<std::size_t>(std::ceil(least / 2 * (1 - 1e-12)));  // 1/(0.1 · 0.01) is 1000
  while (!has_small_factors(n)) n += 2;
  return n;
}

/// Periodic Hann window: its neighbours that overlap by half add up to one.
Eigen::VectorXd hann_window(Eigen::Index n) {
  const auto phases =
      Eigen::VectorXd::LinSpaced(n, 0, 2 * std::numbers::pi * static_cast<double>(n - 1) / static_cast<double>(n));
  return 0.5 * (1 - phases.array().cos());
}

/// Squares of neighbouring segments under Hann windows that overlap by half have the correlation (1/6)² [Welch 1967].
double error_of_line(std::size_t segments) {
  const double k = static_cast<double>(segments);
  return std::sqrt((1 + 2 * (k - 1) / k / 36) / k);
}

}  // namespace

MeasuredSpectrum measured_spectrum(const std::vector<double>& values, double step, double resolution_hz) {
  const double available = static_cast<double>(values.size());
  const auto refuse = [&](double samples, const std::string& why) {
    throw foundation::InvalidInput(fmt::format("lines every {:.6g} Hz need segments of {:.6g} s, {:.0f} samples; {}",
                                               resolution_hz, samples * step, samples, why));
  };
  const auto too_short = [&](double samples) {
    refuse(samples, fmt::format("the record has {:.6g} s", available * step));
  };
  const double least = 1 / (step * resolution_hz);
  if (!(least <= available + 1)) too_short(std::ceil(least));
  const std::size_t length = segment_length(least);
  if (length > values.size()) too_short(static_cast<double>(length));
  if (length < fewest_samples)
    refuse(static_cast<double>(length), fmt::format("at least {} are needed", fewest_samples));
  const Eigen::Index n = to_index(length);
  const Eigen::VectorXd window = hann_window(n);
  const Eigen::Map<const Eigen::VectorXd> record(values.data(), to_index(values.size()));
  Eigen::FFT<double> transform;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(n / 2);
  MeasuredSpectrum spectrum;
  for (Eigen::Index start = 0; start + n <= record.size(); start += n / 2) {
    const auto segment = record.segment(start, n);
    const Eigen::VectorXd weighted = window.cwiseProduct((segment.array() - segment.mean()).matrix());
    Eigen::VectorXcd lines;
    transform.fwd(lines, weighted);
    squares += lines.head(n / 2).cwiseAbs2();
    ++spectrum.segments;
  }
  const double density = 2 * step / (window.squaredNorm() * static_cast<double>(spectrum.segments));
  spectrum.resolution_hz = 1 / (step * static_cast<double>(length));
  spectrum.line_error = error_of_line(spectrum.segments);
  spectrum.table.interpolation = SpectrumTable::Interpolation::linear;
  const auto add = [&](double place, Eigen::Index line) {
    spectrum.table.frequencies_hz.push_back(place * spectrum.resolution_hz);
    spectrum.table.densities_per_hz.push_back(density * squares(line));
  };
  const Eigen::Index last = n / 2 - 1;  // the line at half the sampling rate is left out
  add(0.5, 1);
  for (Eigen::Index k = 1; k <= last; ++k) add(static_cast<double>(k), k);
  add(static_cast<double>(last) + 0.5, last);
  return spectrum;
}

}  // namespace trivet::excitation
