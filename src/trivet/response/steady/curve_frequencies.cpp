// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/curve_frequencies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet::response {
namespace {

constexpr int decades = 4;  // below the upper end of the band

/// Evenly over the band at its middle, more closely at its ends; and one in each decade.
void add_over_band(const assembly::Band& band, int count, std::vector<double>& omega) {
  for (int i = 0; i < count; ++i)
    omega.push_back(0.5 * (band.from + band.to - (band.to - band.from) * std::cos(std::numbers::pi * i / (count - 1))));
  for (int k = 1; k <= decades; ++k) omega.push_back(band.to * std::pow(10.0, -k));
}

/// Near each pole; not at an undamped one, where nothing is defined.
void add_near(const Eigen::VectorXcd& poles, std::initializer_list<double> widths, std::vector<double>& omega) {
  constexpr double undamped = 1e-9;
  for (Eigen::Index k = 0; k < poles.size(); ++k) {
    const double centre = poles(k).imag(), width = std::max(std::abs(poles(k).real()), 1e-6 * centre);
    if (!(centre > 0)) continue;
    for (const double t : widths)
      if (t != 0 || std::abs(poles(k).real()) > undamped * centre) omega.push_back(centre + t * width);
  }
}

void remove_outside(const assembly::Band& band, std::vector<double>& omega) {
  std::erase_if(omega, [&](double w) { return !(w >= band.from && w <= band.to); });
}

/// Of undamped poles, as that of a free body at ω = 0: nothing is defined there.
void remove_at_poles(const Eigen::VectorXcd& poles, std::vector<double>& omega) {
  constexpr double at = 1e-9;
  std::erase_if(omega, [&](double w) {
    return std::ranges::any_of(poles, [&](const std::complex<double>& pole) {
      return std::abs(pole - std::complex<double>(0, w)) <= at * std::max(std::abs(pole), w);
    });
  });
}

}  // namespace

std::vector<double> first_frequencies(const Eigen::VectorXcd& poles, const assembly::Band& band, bool spread_too) {
  constexpr int spread = 9;
  std::vector<double> omega;
  if (spread_too) add_over_band(band, spread, omega);
  add_near(poles, {-1.0, 0.0, 1.0}, omega);
  omega.insert(omega.end(), {band.from, band.to});
  remove_outside(band, omega);
  return omega;
}

std::vector<double> candidate_frequencies(const Eigen::VectorXcd& poles, const assembly::Band& band, int spread) {
  constexpr double apart = 1e-9;  // of ω
  std::vector<double> omega;
  add_over_band(band, spread, omega);
  add_near(poles, {-1.0, 0.0, 1.0}, omega);
  remove_outside(band, omega);
  remove_at_poles(poles, omega);
  std::ranges::sort(omega);
  omega.erase(std::ranges::unique(omega, [](double a, double b) { return b - a <= apart * b; }).begin(), omega.end());
  return omega;
}

}  // namespace trivet::response
