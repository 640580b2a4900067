// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/frequency_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/response/frequency_response.h"

namespace trivet::response {
namespace {

constexpr std::size_t most_points = 6000;
constexpr int most_rounds = 10;
constexpr double amplitude_tolerance = 0.003;
constexpr double phase_step = std::numbers::pi / 9;
constexpr double invisible = 1e-6;  // of a curve's largest amplitude: its shape there shows in no picture

void keep_inside(std::vector<double>& grid, const Band& band) {
  std::erase_if(grid, [&](double w) { return !(w >= band.from && w <= band.to); });
  std::sort(grid.begin(), grid.end());
  const double least = 1e-9 * (band.to - band.from);
  std::vector<double> apart;
  for (const double w : grid)
    if (apart.empty() || w - apart.back() > std::min(least, 1e-9 * w)) apart.push_back(w);
  grid = std::move(apart);
}

std::vector<double> first_guess(const Eigen::VectorXcd& poles, const Peaks& peaks, const Band& band) {
  std::vector<double> grid = linear_grid(band, 101);
  if (band.from > 0) {
    const std::vector<double> decades = logarithmic_grid(band, 61);
    grid.insert(grid.end(), decades.begin(), decades.end());
  }
  for (Eigen::Index k = 0; k < poles.size(); ++k) {
    const double centre = poles(k).imag();
    if (!(centre > 0)) continue;
    const double width = std::max(std::abs(poles(k).real()), 1e-6 * centre);
    for (const double t : {0.0, 0.25, 0.5, 0.8, 1.2, 1.8, 2.8, 4.5, 8.0, 16.0, 40.0}) {
      grid.push_back(centre - t * width);
      grid.push_back(centre + t * width);
    }
  }
  for (const Peak& peak : peaks.list)
    if (std::isfinite(peak.amplitude)) grid.push_back(peak.angular_frequency);
  for (const auto& turnings : peaks.turnings)
    for (const Turning& t : turnings)
      if (std::isfinite(t.amplitude)) grid.push_back(t.angular_frequency);
  keep_inside(grid, band);
  return grid;
}

/// All curves at one frequency.
struct Sample {
  double omega = 0;
  Eigen::VectorXcd values;
  bool settled = false;  ///< the interval that starts here needs no further look
};

std::vector<Sample> sampled(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                            const std::vector<double>& omega) {
  const FrequencyResponse response = frequency_response(assembled, channels, loading, omega);
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    Sample sample{omega[i], Eigen::VectorXcd(static_cast<Eigen::Index>(channels.size())), false};
    for (std::size_t c = 0; c < channels.size(); ++c) sample.values(static_cast<Eigen::Index>(c)) = response.curves[c].value(static_cast<Eigen::Index>(i));
    samples.push_back(std::move(sample));
  }
  return samples;
}

/// Largest finite amplitude of each curve; infinite for one that is zero but for round-off, whose shape nobody wants to see.
Eigen::VectorXd largest(const std::vector<Sample>& samples, const Peaks& peaks) {
  Eigen::VectorXd top = Eigen::VectorXd::Zero(samples.front().values.size());
  for (const Sample& sample : samples)
    for (Eigen::Index c = 0; c < top.size(); ++c)
      if (const double amplitude = std::abs(sample.values(c)); std::isfinite(amplitude)) top(c) = std::max(top(c), amplitude);
  for (std::size_t c = 0; c < peaks.curves.size() && c < static_cast<std::size_t>(top.size()); ++c)
    if (peaks.curves[c].vanishes) top(static_cast<Eigen::Index>(c)) = std::numeric_limits<double>::infinity();
  return top;
}

/// Does any curve leave the straight line from a to b in their middle, or turn its phase too fast?
bool bends(const Sample& from, const Sample& middle, const Sample& to, const Eigen::VectorXd& top) {
  for (Eigen::Index c = 0; c < top.size(); ++c) {
    const std::complex<double> a = from.values(c), m = middle.values(c), b = to.values(c);
    const double size = std::max({std::abs(a), std::abs(b), std::abs(m)});
    if (!std::isfinite(size) || size <= invisible * top(c)) continue;
    if (std::abs(std::abs(m) - 0.5 * (std::abs(a) + std::abs(b))) > amplitude_tolerance * std::max(std::abs(m), 1e-3 * size)) return true;
    if (std::abs(std::arg(m * std::conj(a))) > phase_step || std::abs(std::arg(b * std::conj(m))) > phase_step) return true;
  }
  return false;
}

/// Puts the middles that bend into the grid, and settles the intervals that do not. Returns whether any was put in.
bool refined(std::vector<Sample>& grid, const std::vector<Sample>& middles, const Eigen::VectorXd& top) {
  std::vector<Sample> result;
  std::size_t k = 0;
  bool changed = false;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool looked_at = !grid[i].settled && i + 1 < grid.size();
    const bool split = looked_at && grid.size() + k < most_points && grid[i + 1].omega - grid[i].omega > 1e-9 * grid[i + 1].omega && bends(grid[i], middles[k], grid[i + 1], top);
    result.push_back(std::move(grid[i]));
    result.back().settled = !split;
    if (split) result.push_back(middles[k]);
    changed = changed || split;
    if (looked_at) ++k;
  }
  grid = std::move(result);
  return changed;
}

}  // namespace

std::vector<double> linear_grid(const Band& band, int points) {
  std::vector<double> grid;
  for (int i = 0; i < points; ++i) grid.push_back(i + 1 == points ? band.to : band.from + (band.to - band.from) * i / (points - 1));
  return grid;
}

std::vector<double> logarithmic_grid(const Band& band, int points) {
  std::vector<double> grid;
  for (int i = 0; i < points; ++i)
    grid.push_back(i + 1 == points ? band.to : band.from * std::pow(band.to / band.from, static_cast<double>(i) / (points - 1)));
  return grid;
}

std::vector<double> automatic_grid(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                   const assembly::Loading& loading, const Eigen::VectorXcd& poles, const Peaks& peaks, const Band& band,
                                   const foundation::Progress& progress) {
  std::vector<double> grid = first_guess(poles, peaks, band);
  if (channels.empty() || !(band.to > band.from)) return grid;
  std::vector<Sample> samples = sampled(assembled, channels, loading, grid);
  for (int round = 0; round < most_rounds && samples.size() < most_points; ++round) {
    foundation::report_progress(progress, "frequency grid", static_cast<double>(round) / most_rounds);
    std::vector<double> middles;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      if (!samples[i].settled) middles.push_back(0.5 * (samples[i].omega + samples[i + 1].omega));
    if (middles.empty() || !refined(samples, sampled(assembled, channels, loading, middles), largest(samples, peaks))) break;
  }
  grid.clear();
  for (const Sample& sample : samples) grid.push_back(sample.omega);
  return grid;
}

}  // namespace trivet::response
