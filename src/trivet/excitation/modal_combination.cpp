// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/modal_combination.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {
namespace {

using foundation::two_pi;

}  // namespace

ResponseSpectrum over_period(const std::vector<double>& periods, const std::vector<double>& accelerations,
                             double damping_ratio) {
  ResponseSpectrum spectrum{{}, {accelerations.rbegin(), accelerations.rend()}, damping_ratio};
  for (auto period = periods.rbegin(); period != periods.rend(); ++period)
    spectrum.angular_frequencies.push_back(two_pi / *period);
  return spectrum;
}

foundation::Problems check(const ResponseSpectrum& spectrum, const std::string& subject) {
  foundation::Problems problems;
  const std::vector<double>&w = spectrum.angular_frequencies, &a = spectrum.accelerations;
  if (w.size() != a.size())
    problems.error(subject, fmt::format("{} frequencies and {} accelerations", w.size(), a.size()),
                   "each frequency has one", "complete the rows");
  if (w.size() < 2)
    problems.error(subject, fmt::format("{} rows", w.size()), "a response spectrum has two or more", "add rows");
  for (std::size_t i = 0; i < std::min(w.size(), a.size()); ++i) {
    if (!(w[i] > 0) || !std::isfinite(w[i]))
      problems.error(subject, fmt::format("a natural frequency of {:.6g} Hz", w[i] / two_pi),
                     "natural frequencies (and periods) must be finite and > 0",
                     "replace a period of zero by a short one, 0.01 s for instance");
    if (!(a[i] > 0) || !std::isfinite(a[i]))
      problems.error(subject, fmt::format("acceleration {:.6g} m/s² at {:.6g} Hz", a[i], w[i] / two_pi),
                     "it must be finite and > 0: the spectrum is interpolated logarithmically", "correct the row");
    if (i > 0 && w[i] <= w[i - 1])
      problems.error(subject, fmt::format("{:.6g} Hz after {:.6g} Hz", w[i] / two_pi, w[i - 1] / two_pi),
                     "frequencies (and periods) must increase", "sort the rows and remove repeats");
  }
  if (!(spectrum.damping_ratio >= 0 && spectrum.damping_ratio < 1))
    problems.error(subject, fmt::format("damping ratio {:.6g}", spectrum.damping_ratio), "it must be between 0 and 1",
                   "0.05 is usual");
  return problems;
}

double spectral_acceleration(const ResponseSpectrum& spectrum, double omega) {
  refuse_errors(check(spectrum, "response spectrum"));
  const std::vector<double>&w = spectrum.angular_frequencies, &a = spectrum.accelerations;
  if (!(omega >= w.front() && omega <= w.back()))
    throw foundation::InvalidInput(fmt::format(
        "natural frequency {:.6g} Hz: the response spectrum covers {:.6g} … {:.6g} Hz and is not extrapolated",
        omega / two_pi, w.front() / two_pi, w.back() / two_pi));
  const auto above = std::upper_bound(w.begin() + 1, w.end() - 1, omega);
  const auto i = to_size(above - w.begin());
  const double share = std::log(omega / w[i - 1]) / std::log(w[i] / w[i - 1]);
  return a[i - 1] * std::pow(a[i] / a[i - 1], share);
}

double square_root_of_sum_of_squares(const Eigen::VectorXd& modal_maxima) { return modal_maxima.stableNorm(); }

double modal_correlation(double omega_i, double omega_j, double zeta_i, double zeta_j) {
  for (const double omega : {omega_i, omega_j}) require_positive(omega, "natural frequency", "rad/s");
  for (const double zeta : {zeta_i, zeta_j}) require_damping_ratio(zeta);
  if (omega_i == omega_j && zeta_i == zeta_j) return 1;
  const double b = omega_i / omega_j, detuning = (1 - b) * (1 + b);
  return 8 * std::sqrt(zeta_i * zeta_j) * (b * zeta_i + zeta_j) * b * std::sqrt(b) /
      (detuning * detuning + 4 * zeta_i * zeta_j * b * (1 + b * b) + 4 * (zeta_i * zeta_i + zeta_j * zeta_j) * b * b);
}

double complete_quadratic_combination(const Eigen::VectorXd& r, const Eigen::VectorXd& omega,
                                      const Eigen::VectorXd& zeta) {
  if (omega.size() != r.size() || zeta.size() != r.size())
    throw foundation::InvalidInput(
        fmt::format("{} modal maxima, {} frequencies and {} damping ratios: their numbers must be equal", r.size(),
                    omega.size(), zeta.size()));
  double sum = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    for (Eigen::Index j = 0; j < r.size(); ++j)
      sum += r(i) * r(j) * modal_correlation(omega(i), omega(j), zeta(i), zeta(j));
  return std::sqrt(std::max(0.0, sum));  // positive semidefinite, except for round-off of a cancelling sum
}

}  // namespace trivet::excitation
