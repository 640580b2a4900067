// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::excitation {
namespace {

using foundation::two_pi;
constexpr int points_between_breakpoints = 32;  // a wrong delay is visible within a fraction of a period of e^{−iωτ}
constexpr double accepted_negative_eigenvalue = 1e-9;  // of a matrix with unit diagonal

foundation::Problems problems_of_pair(const InputPair& pair, std::size_t inputs, const std::string& subject) {
  foundation::Problems problems;
  const Coherence& c = pair.coherence;
  if (pair.first >= inputs || pair.second >= inputs || pair.first == pair.second)
    problems.error(subject, fmt::format("inputs {} and {}", pair.first + 1, pair.second + 1),
                   fmt::format("a pair has two different inputs out of {}", inputs), "correct the pair");
  if (!(c.at_zero >= 0 && c.at_zero <= 1))
    problems.error(subject, fmt::format("coherence {:.6g}", c.at_zero),
                   "γ² is between 0 (uncorrelated) and 1 (fully coherent)", "correct it");
  if (!(c.decay >= 0) || !std::isfinite(c.decay))
    problems.error(subject, fmt::format("decay {:.6g}", c.decay), "it must be ≥ 0", "coherence falls with distance");
  if (!(c.distance >= 0) || !std::isfinite(c.distance))
    problems.error(subject, fmt::format("distance {:.6g} m", c.distance), "it must be ≥ 0",
                   "give its magnitude; the sign is that of the delay");
  if (c.decay > 0 && (!(c.speed > 0) || !std::isfinite(c.speed)))
    problems.error(subject, fmt::format("speed {:.6g} m/s", c.speed), "a decay per wavelength needs a speed > 0",
                   "give the speed of the wave");
  if (!std::isfinite(pair.delay))
    problems.error(subject, fmt::format("delay {} s", pair.delay), "it must be finite", "correct it");
  return problems;
}

/// γ_jk e^{−iωτ}: the density matrix of inputs with unit spectra.
Eigen::MatrixXcd correlation(const RandomInputs& inputs, double omega) {
  const auto n = to_index(inputs.spectra.size());
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Identity(n, n);
  for (const InputPair& pair : inputs.pairs) {
    const auto j = to_index(pair.first), k = to_index(pair.second);
    matrix(j, k) = std::polar(std::sqrt(coherence(pair.coherence, omega)), -omega * pair.delay);
    matrix(k, j) = std::conj(matrix(j, k));
  }
  return matrix;
}

std::vector<double> test_frequencies(const RandomInputs& inputs) {
  std::set<double> ends;
  for (const Spectrum& spectrum : inputs.spectra)
    for (const double omega : breakpoints(spectrum)) ends.insert(omega);
  std::vector<double> points(ends.begin(), ends.end());
  for (std::size_t i = 1, last = points.size(); i < last; ++i)
    for (int k = 1; k < points_between_breakpoints; ++k)
      points.push_back(points[i - 1] + (points[i] - points[i - 1]) * k / points_between_breakpoints);
  std::ranges::sort(points);
  return points;
}

}  // namespace

double coherence(const Coherence& law, double omega) {
  return law.decay == 0 ? law.at_zero
                        : law.at_zero * std::exp(-2 * law.decay * law.distance * omega / (two_pi * law.speed));
}

Eigen::MatrixXcd density_matrix(const RandomInputs& inputs, double omega) {
  for (const InputPair& pair : inputs.pairs)
    foundation::refuse_errors(problems_of_pair(pair, inputs.spectra.size(), "pair of inputs"));
  Eigen::VectorXd root(to_index(inputs.spectra.size()));
  for (Eigen::Index j = 0; j < root.size(); ++j) root(j) = std::sqrt(density(inputs.spectra[j], omega));
  return root.asDiagonal() * correlation(inputs, omega) * root.asDiagonal();
}

foundation::Problems check(const RandomInputs& inputs, const std::string& subject) {
  foundation::Problems problems;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for (const InputPair& pair : inputs.pairs) {
    problems.add(problems_of_pair(pair, inputs.spectra.size(), subject));
    if (!seen.insert(std::minmax(pair.first, pair.second)).second)
      problems.error(subject, fmt::format("inputs {} and {} twice", pair.first + 1, pair.second + 1),
                     "a pair is given once", "remove one");
  }
  if (problems.has_errors() || inputs.pairs.empty()) return problems;
  for (const double omega : test_frequencies(inputs)) {
    const double lowest = numerics::symmetric_eigenvalues(correlation(inputs, omega))(0);
    if (lowest >= -accepted_negative_eigenvalue) continue;
    problems.error(
        subject, fmt::format("at {:.6g} Hz the matrix of coherences has the eigenvalue {:.3g}", omega / two_pi, lowest),
        "cross-spectra of real signals are positive semidefinite: two inputs coherent with a third are coherent with "
        "each other, and delays add up",
        "give the missing pairs, or lower the coherences");
    break;
  }
  return problems;
}

}  // namespace trivet::excitation
