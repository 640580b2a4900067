// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/constants.h"
#include "trivet/identification/hysteresis_loop.h"
#include "trivet/numerics/linalg/decompositions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace trivet::identification {
namespace {

using foundation::two_pi;

double remaining(const Eigen::VectorXd& time, const Eigen::VectorXd& signal, double frequency, int order) {
  return harmonic_fit(harmonic_columns(time, frequency, order, 1), signal).noise(0);
}

/// Times at which the signal crosses zero upwards, from below −band to above +band.
std::vector<double> upward_crossings(const Eigen::VectorXd& time, const Eigen::VectorXd& signal, double band) {
  std::vector<double> crossings;
  bool was_low = false;
  double zero = 0;
  for (Eigen::Index i = 0; i < signal.size(); ++i) {
    if (signal(i) < -band) was_low = true;
    if (i > 0 && signal(i - 1) < 0 && signal(i) >= 0) zero = time(i);
    if (was_low && signal(i) > band) {
      crossings.push_back(zero);
      was_low = false;
    }
  }
  return crossings;
}

/// Gauss–Newton iteration on ω; each step also solves for the linear coefficients.
double refined(const Eigen::VectorXd& time, const Eigen::VectorXd& signal, double frequency, int order, int harmonics) {
  constexpr int most_steps = 30;
  const double duration = time(time.size() - 1) - time(0);
  const Eigen::VectorXd elapsed = (time.array() - time(0)) / duration;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::MatrixXd columns = harmonic_columns(time, frequency, order, harmonics);
    const Eigen::VectorXd coefficients = harmonic_fit(columns, signal).coefficients.col(0);
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(columns.rows());  // of the signal along the phase
    for (int n = 1; n <= harmonics; ++n) {
      const Eigen::Index cosine = order + 2 * n - 1;
      slope += n * (coefficients(cosine + 1) * columns.col(cosine) - coefficients(cosine) * columns.col(cosine + 1));
    }
    Eigen::MatrixXd tangent(columns.rows(), columns.cols() + 1);
    tangent << columns, elapsed.cwiseProduct(slope);
    const double change = harmonic_fit(tangent, signal).coefficients(columns.cols(), 0) / duration;
    frequency += std::clamp(change, -0.05 * frequency, 0.05 * frequency);
    if (std::abs(change) * duration < 1e-9) break;
  }
  return frequency;
}

}  // namespace

Eigen::MatrixXd harmonic_columns(const Eigen::VectorXd& time, double angular_frequency, int order, int harmonics) {
  const double first = time(0), duration = time(time.size() - 1) - first;
  const Eigen::ArrayXd along = 2 * (time.array() - first) / duration - 1,
                       phase = angular_frequency * (time.array() - first);
  Eigen::MatrixXd columns(time.size(), order + 1 + 2 * harmonics);
  columns.col(0).setOnes();
  for (int p = 1; p <= order; ++p) columns.col(p) = columns.col(p - 1).array() * along;
  for (int n = 1; n <= harmonics; ++n) {
    columns.col(order + 2 * n - 1) = (n * phase).cos();
    columns.col(order + 2 * n) = (n * phase).sin();
  }
  return columns;
}

HarmonicFit harmonic_fit(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& signals) {
  HarmonicFit fit;
  const Eigen::MatrixXd normal = columns.transpose() * columns;
  fit.unit_covariance =
      numerics::ldlt_solution(normal, Eigen::MatrixXd(Eigen::MatrixXd::Identity(normal.rows(), normal.cols())));
  fit.coefficients = fit.unit_covariance * (columns.transpose() * signals);
  fit.residuals = signals - columns * fit.coefficients;
  fit.coefficients +=
      fit.unit_covariance * (columns.transpose() * fit.residuals);  // corrects the rounding of the normal equations
  fit.residuals = signals - columns * fit.coefficients;
  const double freedom = static_cast<double>(std::max<Eigen::Index>(1, columns.rows() - columns.cols()));
  fit.noise = (fit.residuals.colwise().squaredNorm() / freedom).cwiseSqrt();
  return fit;
}

std::optional<double> frequency_of(const Eigen::VectorXd& time, const Eigen::VectorXd& signal, int order,
                                   int harmonics) {
  const Eigen::VectorXd centred = harmonic_fit(harmonic_columns(time, 0, order, 0), signal).residuals.col(0);
  const double size = std::sqrt(centred.squaredNorm() / static_cast<double>(centred.size()));
  if (!(size > 1e-14 * signal.cwiseAbs().maxCoeff())) return std::nullopt;
  const double duration = time(time.size() - 1) - time(0);
  const std::vector<double> crossings = upward_crossings(time, centred, 0.5 * size);
  double start = 0;
  if (crossings.size() >= 3) {
    start = two_pi * static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
  } else {
    double best = std::numeric_limits<double>::infinity();
    for (double cycles = 0.6; cycles < 3.45; cycles += 0.1)
      if (const double left = remaining(time, signal, two_pi * cycles / duration, order); left < best) {
        best = left;
        start = two_pi * cycles / duration;
      }
  }
  const double samples_per_cycle = static_cast<double>(time.size()) * two_pi / (start * duration);
  return refined(time, signal, refined(time, signal, start, order, 1), order,
                 std::clamp(static_cast<int>(samples_per_cycle / 4), 1, harmonics));
}

}  // namespace trivet::identification
