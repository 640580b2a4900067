// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/frequency_grid.h"

#include <algorithm>
#include <cmath>
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

struct Sampled {
  std::vector<double> omega;
  Eigen::MatrixXcd values;  // curves × points
};

Sampled sample(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const Eigen::VectorXcd& load,
               const std::vector<double>& omega) {
  const FrequencyResponse response = frequency_response(assembled, channels, load, omega);
  Sampled result{omega, Eigen::MatrixXcd(static_cast<Eigen::Index>(channels.size()), static_cast<Eigen::Index>(omega.size()))};
  for (std::size_t c = 0; c < channels.size(); ++c) result.values.row(static_cast<Eigen::Index>(c)) = response.curves[c].value.transpose();
  return result;
}

/// Must the interval from column i to i + 1 be halved, given the values in its middle?
bool bends(const Sampled& coarse, Eigen::Index i, const Eigen::VectorXcd& middle, const Eigen::VectorXd& top) {
  for (Eigen::Index c = 0; c < coarse.values.rows(); ++c) {
    const std::complex<double> a = coarse.values(c, i), b = coarse.values(c, i + 1), m = middle(c);
    const double size = std::max({std::abs(a), std::abs(b), std::abs(m)});
    if (!std::isfinite(size) || size <= invisible * top(c)) continue;
    if (std::abs(std::abs(m) - 0.5 * (std::abs(a) + std::abs(b))) > amplitude_tolerance * std::max(std::abs(m), 1e-3 * size)) return true;
    if (std::abs(std::arg(m * std::conj(a))) > phase_step || std::abs(std::arg(b * std::conj(m))) > phase_step) return true;
  }
  return false;
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
                                   const Eigen::VectorXcd& load, const Eigen::VectorXcd& poles, const Peaks& peaks, const Band& band) {
  std::vector<double> grid = first_guess(poles, peaks, band);
  if (channels.empty() || !(band.to > band.from)) return grid;
  std::vector<bool> settled(grid.size(), false);  // per interval: it needs no further look
  for (int round = 0; round < most_rounds && grid.size() < most_points; ++round) {
    const Sampled coarse = sample(assembled, channels, load, grid);
    Eigen::VectorXd top(coarse.values.rows());
    for (Eigen::Index c = 0; c < top.size(); ++c) {
      top(c) = 0;
      for (Eigen::Index i = 0; i < coarse.values.cols(); ++i)
        if (const double a = std::abs(coarse.values(c, i)); std::isfinite(a)) top(c) = std::max(top(c), a);
    }
    std::vector<double> middles;
    std::vector<std::size_t> intervals;
    for (std::size_t i = 0; i + 1 < grid.size(); ++i)
      if (!settled[i]) {
        middles.push_back(0.5 * (grid[i] + grid[i + 1]));
        intervals.push_back(i);
      }
    if (middles.empty()) break;
    const Sampled fine = sample(assembled, channels, load, middles);
    std::vector<bool> split(grid.size(), false);
    for (std::size_t k = 0; k < intervals.size(); ++k)
      split[intervals[k]] = bends(coarse, static_cast<Eigen::Index>(intervals[k]), fine.values.col(static_cast<Eigen::Index>(k)), top) &&
                            grid[intervals[k] + 1] - grid[intervals[k]] > 1e-9 * grid[intervals[k] + 1];
    std::vector<double> refined;
    std::vector<bool> refined_settled;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      refined.push_back(grid[i]);
      refined_settled.push_back(!split[i]);
      if (split[i]) {
        refined.push_back(0.5 * (grid[i] + grid[i + 1]));
        refined_settled.push_back(false);
      }
    }
    grid = std::move(refined);
    settled = std::move(refined_settled);
  }
  return grid;
}

}  // namespace trivet::response
