// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/shock_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/peaks/peak_count.h"

namespace trivet::excitation {

namespace {

/// Number of terms of a series over one radian: the next one is below (1 + √2)^28/28! = 2e-19 of the largest.
constexpr std::size_t terms = 28;
using Series = std::array<double, terms>;

/// Widens [smallest, largest] by the extrema of Σ c_k σᵏ on [0, 1]. Steps that cannot exceed the range are skipped:
/// between its ends a function deviates from its chord by at most max |f″|/8.
void widen(double& smallest, double& largest, const Series& c) {
  double end = 0, bound = 0;
  for (std::size_t k = 0; k < terms; ++k) {
    const auto order = static_cast<double>(k);
    end += c[k];
    bound += order * (order - 1) * std::abs(c[k]) / 8;
  }
  const double low = std::min(c[0], end), high = std::max(c[0], end);
  const bool inside = low - bound >= smallest && high + bound <= largest;
  smallest = std::min(smallest, low);
  largest = std::max(largest, high);
  if (inside) return;
  std::array<double, terms - 1> derivative{};
  for (std::size_t k = 1; k < terms; ++k) derivative[k - 1] = static_cast<double>(k) * c[k];
  for (const numerics::SignChange& turn : numerics::sign_changes(derivative, 0, 1)) {
    const double value = numerics::polynomial_value(c, turn.at);
    smallest = std::min(smallest, value);
    largest = std::max(largest, value);
  }
}

struct Range {
  double smallest = 0, largest = 0;
};

/// One oscillator in the scaled time τ = ωt, y = ω²z and its rate dy/dτ, both in the unit of the base acceleration.
constexpr double most_steps = 1e6;  ///< of one radian within one piece of a signal

class Oscillator {
 public:
  Oscillator(double omega, double zeta) : omega_(omega), zeta_(zeta) {}

  /// Integrates over a piece of the base acceleration and widens the range of the absolute acceleration.
  void integrate(const Piece& piece, double duration, Range& absolute) {
    const double steps = std::max(1.0, std::ceil(duration * std::max(omega_, piece.kappa)));
    if (steps > most_steps)
      throw foundation::NotComputable(
          "shock spectrum: an oscillator goes through more than a million radians within one piece of the signal; "
          "lower the upper end of the band");
    const double h = duration / steps;
    for (double i = 0; i < steps; ++i) advance(base_series(piece, i * h, h), h, absolute);
  }

  /// Free vibration under a constant base acceleration, until no later extremum can be larger: at most one period.
  void ring_out(double base, Range& absolute) {
    const Series constant{base};
    const double period = 2 * std::numbers::pi / std::sqrt((1 - zeta_) * (1 + zeta_));
    for (double tau = 0; tau < period + 1; ++tau) {
      const double amplitude = std::hypot(y_ + base, rate_);  // its energy never increases
      const double reach = (1 + 2 * zeta_) * amplitude;
      if (base + reach <= absolute.largest && base - reach >= absolute.smallest &&
          -base + amplitude <= relative_.largest && -base - amplitude >= relative_.smallest)
        return;
      advance(constant, 1 / omega_, absolute);
    }
  }

  [[nodiscard]] double largest_relative() const { return std::max(relative_.largest, -relative_.smallest); }

 private:
  /// Taylor series over σ = (s − from)/h, from u‴ = −κ²u′.
  static Series base_series(const Piece& piece, double from, double h) {
    const SignalState start = state_on(piece, from);
    Series a{start.value, start.rate * h, start.curvature * h * h / 2};
    const double x = piece.kappa * piece.kappa * h * h;
    for (std::size_t k = 3; k < terms; ++k) a[k] = -x * a[k - 2] / static_cast<double>(k * (k - 1));
    return a;
  }

  void advance(const Series& base, double h, Range& absolute) {
    const double angle = omega_ * h;
    Series y{y_, angle * rate_}, acceleration{};
    for (std::size_t k = 0; k + 2 < terms; ++k) {
      const auto n = static_cast<double>(k);
      y[k + 2] = -(angle * angle * (base[k] + y[k]) + 2 * zeta_ * angle * (n + 1) * y[k + 1]) / ((n + 1) * (n + 2));
    }
    y_ = rate_ = 0;
    for (std::size_t k = 0; k < terms; ++k) {
      const double rate = k + 1 < terms ? static_cast<double>(k + 1) * y[k + 1] / angle : 0;
      acceleration[k] = -y[k] - 2 * zeta_ * rate;
      y_ += y[k];
      rate_ += rate;
    }
    widen(absolute.smallest, absolute.largest, acceleration);
    widen(relative_.smallest, relative_.largest, y);
  }

  double omega_, zeta_, y_ = 0, rate_ = 0;
  Range relative_;
};

}  // namespace

std::vector<ShockResponse> shock_spectrum(const Signal& base, const std::vector<double>& angular_frequencies,
                                          double zeta, const foundation::Progress& progress) {
  require_valid(base);
  require_damping_ratio(zeta);
  for (const double omega : angular_frequencies) require_positive(omega, "natural frequency", "rad/s");
  if (!base.pieces.empty() && (base.pieces.back().rate != 0 || base.pieces.back().curvature != 0))
    throw foundation::InvalidInput(
        "the base acceleration does not end with a constant value, so the response never settles; end it with a "
        "constant");
  std::vector<ShockResponse> spectrum;
  for (const double omega : angular_frequencies) {
    Oscillator oscillator(omega, zeta);
    Range primary, residual;
    for (std::size_t i = 0; i + 1 < base.pieces.size(); ++i) {
      const double done = static_cast<double>(i) / static_cast<double>(base.pieces.size());
      foundation::report_progress(
          progress, "shock response spectrum",
          (static_cast<double>(spectrum.size()) + done) / static_cast<double>(angular_frequencies.size()));
      oscillator.integrate(base.pieces[i], base.pieces[i + 1].start - base.pieces[i].start, primary);
    }
    if (!base.pieces.empty()) oscillator.ring_out(base.pieces.back().value, residual);
    spectrum.push_back({omega, primary.largest, primary.smallest, residual.largest, residual.smallest,
                        oscillator.largest_relative() / (omega * omega)});
  }
  return spectrum;
}

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
  foundation::refuse_errors(check(spectrum, "response spectrum"));
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
