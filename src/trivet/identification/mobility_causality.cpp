// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/mobility_causality.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "trivet/numerics/nonnegative_least_squares.h"

namespace trivet::identification {
namespace {

using Complex = std::complex<double>;
constexpr double explained_by_noise = 0.1, wrong_phase = 0.4;
constexpr double per_decade = 24;
constexpr double margin = 30;     ///< resonances are looked for so far outside the table
constexpr Eigen::Index most_rows = 120;

/// Resonator frequencies: the rows' own, and a logarithmic grid beyond.
std::vector<double> resonances(double from, double to) {
  std::vector<double> grid;
  const int count = static_cast<int>(std::ceil(per_decade * std::log10(margin * margin * to / from)));
  for (int i = 0; i <= count; ++i) grid.push_back(from / margin * std::pow(margin * margin * to / from, static_cast<double>(i) / count));
  return grid;
}

}  // namespace

MobilityVerdict mobility_causality(const std::vector<double>& omega, const Eigen::VectorXcd& mobility) {
  std::vector<Eigen::Index> rows;
  const Eigen::Index step = std::max<Eigen::Index>(1, (mobility.size() + most_rows - 1) / most_rows);
  for (Eigen::Index i = 0; i < mobility.size(); i += step)
    if (std::abs(mobility(i)) > 0) rows.push_back(i);
  const auto count = static_cast<Eigen::Index>(rows.size());
  if (count == 0) return {};
  std::vector<std::pair<double, double>> resonators = {{0, 0}};
  for (const double resonance : resonances(omega.front(), omega.back()))
    for (const double ratio : {0.04, 0.15, 0.5, 1.5}) resonators.emplace_back(resonance, ratio);
  // Light damping is resolved only where the table has rows.
  for (Eigen::Index r = 0; r < count; ++r) {
    const double here = omega[static_cast<std::size_t>(rows[static_cast<std::size_t>(r)])];
    const double next = r + 1 < count ? omega[static_cast<std::size_t>(rows[static_cast<std::size_t>(r + 1)])] : here;
    for (const double resonance : {here, 0.5 * (here + next)})
      for (const double ratio : {0.003, 0.01, 0.025}) resonators.emplace_back(resonance, ratio);
  }
  Eigen::MatrixXd a(2 * count, static_cast<Eigen::Index>(resonators.size()));
  Eigen::VectorXd b(2 * count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const double w = omega[static_cast<std::size_t>(rows[static_cast<std::size_t>(r)])];
    const Complex y = mobility(rows[static_cast<std::size_t>(r)]);
    for (std::size_t k = 0; k < resonators.size(); ++k) {
      const auto [resonance, ratio] = resonators[k];
      const Complex value = Complex(0, w) / (resonance * resonance - w * w + Complex(0, 2 * ratio * resonance * w)) * std::max(resonance, omega.front()) / std::abs(y);
      const auto column = static_cast<Eigen::Index>(k);
      a(2 * r, column) = value.real();
      a(2 * r + 1, column) = value.imag();
    }
    b(2 * r) = y.real() / std::abs(y);
    b(2 * r + 1) = y.imag() / std::abs(y);
  }
  const Eigen::VectorXd weights = numerics::nonnegative_least_squares(a, b);
  MobilityVerdict verdict;
  verdict.relative_rms = std::sqrt((a * weights - b).squaredNorm() / static_cast<double>(count));
  verdict.passes = verdict.relative_rms <= explained_by_noise;
  verdict.refused = verdict.relative_rms > wrong_phase;
  return verdict;
}

}  // namespace trivet::identification
