// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/curve_fractions.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/response/random/pole_expansion.h"
#include "trivet/response/steady/channel_terms.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::study {
namespace {

using Complex = std::complex<double>;

std::vector<int> all_powers() {
  std::vector<int> powers;
  for (int m = response::lowest_power; m <= response::highest_power; ++m) powers.push_back(m);
  return powers;
}

/// Poles in pairs that give real denominators if all poles are real or conjugates; a single one is paired with itself.
std::vector<std::pair<Eigen::Index, Eigen::Index>> paired(const Eigen::VectorXcd& poles, bool real) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
  Eigen::Index open = -1;
  for (Eigen::Index k = 0; k < poles.size(); ++k) {
    if (real && poles(k).imag() != 0) {
      pairs.emplace_back(k, k + 1);
      ++k;
    } else if (open < 0) {
      open = k;
    } else {
      pairs.emplace_back(open, k);
      open = -1;
    }
  }
  if (open >= 0) pairs.emplace_back(open, open);
  return pairs;
}

/// Numbers of one curve: residues over (s − λ₁)(s − λ₂), then powers of s without those that are only round-off.
void set_terms(const response::PoleExpansion& part, Eigen::Index curve, const Eigen::VectorXcd& poles,
               const std::vector<std::pair<Eigen::Index, Eigen::Index>>& pairs, Eigen::Ref<Eigen::VectorXcd> terms) {
  constexpr double cancelled = 1e-12;
  Eigen::Index at = 0;
  for (const auto& [one, two] : pairs) {
    const Complex first = part.residue(curve, one), second = one == two ? Complex(0) : part.residue(curve, two);
    terms(at++) = -first * poles(two) - second * poles(one);
    terms(at++) = first + second;
  }
  for (Eigen::Index m = 0; m < part.power.cols(); ++m) {
    const bool is_round_off = std::abs(part.power(curve, m)) <= cancelled * part.possible_power(curve, m);
    terms(at++) = is_round_off ? Complex(0) : part.power(curve, m);
  }
}

/// Frequencies around the poles and over the band.
std::vector<double> compared_frequencies(const Eigen::VectorXcd& poles, const assembly::Band& band) {
  constexpr int spread = 16, decades = 3;
  std::vector<double> omega;
  for (int i = 0; i <= spread; ++i) omega.push_back(band.from + (band.to - band.from) * i / spread);
  for (int k = 1; k <= decades; ++k) omega.push_back(band.to * std::pow(10.0, -k));
  for (const Complex& pole : poles)
    for (const double t : {-1.0, 0.0, 1.0}) omega.push_back(pole.imag() + t * std::abs(pole.real()));
  std::erase_if(omega, [&](double w) { return !(w > 0 && w >= band.from && w <= band.to); });
  std::ranges::sort(omega);
  omega.erase(std::ranges::unique(omega).begin(), omega.end());
  return omega;
}

/// Largest deviation of the fractions from direct solutions, as they are and rounded.
void compare(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
             const assembly::Loading& loading, const std::vector<double>& omega, CurveFractions& found) {
  constexpr double near_zero = 1e-6, round_off = 1e-10;  // of the curve, of all curves of its unit
  const response::FrequencyResponse truth = response::frequency_response(assembled, channels, loading, omega);
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(found.form.curves), floor = largest;
  for (Eigen::Index c = 0; c < floor.size(); ++c)
    for (const Complex& value : truth.curves[to_size(c)].value)
      if (std::isfinite(std::abs(value))) largest(c) = std::max(largest(c), std::abs(value));
  for (Eigen::Index c = 0; c < floor.size(); ++c) {
    for (Eigen::Index k = 0; k < floor.size(); ++k)
      if (channels[to_size(c)].unit == channels[to_size(k)].unit) floor(c) = std::max(floor(c), round_off * largest(k));
    floor(c) = std::max({floor(c), near_zero * largest(c), std::numeric_limits<double>::min()});
  }
  const Eigen::VectorXcd less = rounded(found.numerators);
  found.error = found.rounded_error = 0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const Eigen::VectorXcd exact = found.form.at(found.denominators, found.numerators, omega[i]),
                           coarse = found.form.at(found.denominators, less, omega[i]);
    for (Eigen::Index c = 0; c < floor.size(); ++c) {
      const Complex value = truth.curves[to_size(c)].value(to_index(i));
      if (!std::isfinite(std::abs(value))) continue;  // at an undamped resonance
      const double scale = std::max(std::abs(value), floor(c));
      const auto include = [&](const Complex& other, double& worst) {
        const double off = std::abs(other - value) / scale;
        worst = std::isnan(off) ? std::numeric_limits<double>::infinity() : std::max(worst, off);
      };
      include(exact(c), found.error);
      include(coarse(c), found.rounded_error);
    }
  }
}

}  // namespace

Eigen::MatrixXcd rounded(const Eigen::MatrixXcd& numbers) {
  return numbers.cast<std::complex<float>>().cast<Complex>();
}

Eigen::VectorXcd CurveForm::at(const Eigen::VectorXcd& denominators, const Eigen::VectorXcd& numerators,
                               double omega) const {
  const Complex s(0, omega);
  Eigen::VectorXcd basis(terms());
  for (Eigen::Index k = 0; k < pairs; ++k) {
    basis(2 * k) = 1.0 / (denominators(2 * k) - omega * omega + s * denominators(2 * k + 1));
    basis(2 * k + 1) = s * basis(2 * k);
  }
  for (std::size_t m = 0; m < powers.size(); ++m) basis(2 * pairs + to_index(m)) = std::pow(s, powers[m]);
  Eigen::VectorXcd parts(std::ssize(delays) * curves);
  for (Eigen::Index row = 0; row < parts.size(); ++row) {
    Complex sum = 0;
    for (Eigen::Index t = 0; t < basis.size(); ++t)
      if (const Complex& number = numerators(row * terms() + t); number != 0.0) sum += number * basis(t);
    parts(row) = sum;
  }
  return response::summed(parts, delays, omega);
}

CurveFractions curve_fractions(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                               const assembly::Loading& loading, const assembly::Band& band,
                               const std::vector<double>& delays) {
  CurveFractions found;
  if (response::delays_of(loading) != delays) return found;
  const response::PoleExpansions expansions = response::pole_expansions(assembled, channels, {&loading});
  const auto pairs = paired(expansions.poles, expansions.real);
  found.real = expansions.real;
  found.form = {std::ssize(channels), std::ssize(pairs), delays, all_powers()};
  found.denominators.resize(2 * found.form.pairs);
  for (Eigen::Index k = 0; k < found.form.pairs; ++k) {
    const Complex one = expansions.poles(pairs[to_size(k)].first), two = expansions.poles(pairs[to_size(k)].second);
    found.denominators(2 * k) = one * two;
    found.denominators(2 * k + 1) = -(one + two);
  }
  found.numerators = Eigen::VectorXcd::Zero(found.form.size());
  const Eigen::Index terms = found.form.terms();
  for (const response::PoleExpansion& part : expansions.parts) {
    const auto delay = std::ranges::find(delays, part.delay) - delays.begin();
    for (Eigen::Index c = 0; c < found.form.curves; ++c)
      set_terms(part, c, expansions.poles, pairs,
                found.numerators.segment((delay * found.form.curves + c) * terms, terms));
  }
  if (!found.numerators.allFinite()) return found;  // a double pole
  compare(assembled, channels, loading, compared_frequencies(expansions.poles, band), found);
  return found;
}

}  // namespace trivet::study
