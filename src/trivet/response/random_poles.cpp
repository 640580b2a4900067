// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random_poles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/response/basis_integrals.h"
#include "trivet/response/channel_terms.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// A coefficient below this share of its terms stands for a zero: at an undamped pole, or at rest for a spectrum that begins there.
constexpr double negligible_share = 1e-9;
/// Frequencies at which the form is held to direct solutions: about as many poles, and points between.
constexpr Eigen::Index checked_frequencies = 16;

bool significant(const Complex& value, double possible) { return std::abs(value) > negligible_share * possible; }

/// Marks what is infinite, and takes it and its round-off out of the expansions.
void sort_out_infinite(const RandomLoading& loading, const std::vector<RandomMoment>& moments, PoleExpansions& expansions, RandomVariances& result) {
  const std::vector<Eigen::Index> undamped = undamped_poles_in_band(expansions.poles, loading);
  for (PoleExpansion& part : expansions.parts) {
    const std::optional<int> of_spectrum = order_at_rest(loading.inputs[part.load].spectrum);
    for (Eigen::Index c = 0; c < part.residue.rows(); ++c) {
      std::vector<std::string>& reason = result.reason[static_cast<std::size_t>(c)];
      for (const Eigen::Index k : undamped) {
        if (significant(part.residue(c, k), part.possible_residue(c, k)))
          for (std::string& r : reason) r = "an undamped natural frequency lies in the band of \"" + loading.inputs[part.load].name + "\"";
        part.residue(c, k) = 0;
      }
      for (int m = lowest_power; m < 0 && of_spectrum; ++m) {
        Complex& coefficient = part.power(c, m - lowest_power);
        const bool matters = significant(coefficient, part.possible_power(c, m - lowest_power));
        if (!matters) coefficient = 0;
        for (std::size_t i = 0; i < moments.size() && matters; ++i)
          if (2 * m + *of_spectrum + order_at_rest(moments[i]) <= -1 && reason[i].empty())
            reason[i] = "the spectrum of \"" + loading.inputs[part.load].name + "\" begins at 0 Hz, toward which the answer grows without bound";
      }
    }
  }
  // Undamped poles take no part any more, nor do their conjugates, which must stay pairs.
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < expansions.poles.size(); ++k) {
    const bool out = std::any_of(undamped.begin(), undamped.end(), [&](Eigen::Index u) { return u == k || (expansions.real && expansions.poles(k) == std::conj(expansions.poles(u))); });
    if (!out) kept.push_back(k);
  }
  if (kept.size() == static_cast<std::size_t>(expansions.poles.size())) return;
  expansions.poles = expansions.poles(kept).eval();
  for (PoleExpansion& part : expansions.parts) {
    part.residue = part.residue(Eigen::all, kept).eval();
    part.possible_residue = part.possible_residue(Eigen::all, kept).eval();
  }
}

/// Nodes at which to compare: near poles in the band, spread over them, and spread over all nodes.
std::vector<Eigen::Index> check_nodes(const Eigen::VectorXcd& poles, const Eigen::VectorXd& omega) {
  std::vector<double> in_band;
  for (const Complex& pole : poles)
    if (pole.imag() >= omega(0) && pole.imag() <= omega(omega.size() - 1)) in_band.push_back(pole.imag());
  std::sort(in_band.begin(), in_band.end());
  std::vector<Eigen::Index> nodes;
  const auto count = static_cast<Eigen::Index>(in_band.size()), at_poles = std::min(count, checked_frequencies / 2);
  for (Eigen::Index i = 0; i < at_poles; ++i) {
    const double pole = in_band[static_cast<std::size_t>(at_poles < 2 ? 0 : i * (count - 1) / (at_poles - 1))];
    nodes.push_back(std::min<Eigen::Index>(omega.size() - 1, std::lower_bound(omega.begin(), omega.end(), pole) - omega.begin()));
  }
  const Eigen::Index spread = checked_frequencies - at_poles;
  for (Eigen::Index i = 0; i < spread; ++i) nodes.push_back(i * (omega.size() - 1) / (spread - 1));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The form against direct solutions, each weighed by the root of its density: sets `error` and `vanishes`.
void compare_with_solutions(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const RandomLoading& loading,
                            const PoleExpansions& expansions, const BasisIntegrals& basis, RandomVariances& result) {
  const auto count = static_cast<Eigen::Index>(channels.size());
  const std::vector<Eigen::Index> nodes = check_nodes(expansions.poles, basis.omega());
  std::vector<double> omega;
  for (const Eigen::Index node : nodes) omega.push_back(basis.omega()(node));
  Eigen::VectorXd miss = Eigen::VectorXd::Zero(count), largest = miss, possible = miss;
  for (std::size_t i = 0; i < loading.inputs.size(); ++i) {
    const AnswerSamples direct = answer_samples(assembled, channels, loading.inputs[i].loading, omega);
    for (std::size_t f = 0; f < nodes.size(); ++f) {
      const double amplitude = std::sqrt(excitation::density(loading.inputs[i].spectrum, omega[f]));
      Eigen::VectorXcd value = Eigen::VectorXcd::Zero(count);
      for (const PoleExpansion& part : expansions.parts)
        if (part.load == i) value += std::polar(1.0, -omega[f] * part.delay) * basis.value(part, nodes[f]);
      const auto column = static_cast<Eigen::Index>(f);
      miss = miss.cwiseMax(amplitude * (value - direct.value.col(column)).cwiseAbs());
      largest = largest.cwiseMax(amplitude * direct.value.col(column).cwiseAbs());
      possible = possible.cwiseMax(amplitude * direct.possible.col(column));
    }
    result.solutions += static_cast<int>(nodes.size());
  }
  for (Eigen::Index c = 0; c < count; ++c) {
    result.vanishes[static_cast<std::size_t>(c)] = !(largest(c) > vanishing_answer * possible(c));
    const double noise = 1024 * std::numeric_limits<double>::epsilon() * possible(c);  // of the direct solutions themselves
    result.error(c) = result.vanishes[static_cast<std::size_t>(c)] ? 0 : 1e-12 + 2 * std::max(0.0, miss(c) - noise) / largest(c);
  }
}

}  // namespace

RandomVariances variances_by_poles(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const RandomLoading& loading,
                                   const std::vector<RandomMoment>& moments, const PoleExpansions& given, const foundation::Progress& progress) {
  RandomVariances result = no_variances(static_cast<Eigen::Index>(channels.size()), moments.size(), loading.inputs.size());
  if (!std::all_of(given.parts.begin(), given.parts.end(), [](const PoleExpansion& part) { return part.residue.allFinite() && part.power.allFinite(); })) {
    result.error.setConstant(std::numeric_limits<double>::infinity());
    return result;
  }
  PoleExpansions expansions = given;
  sort_out_infinite(loading, moments, expansions, result);
  const BasisIntegrals basis(expansions, gauss_nodes(panel_ends(expansions.poles, loading, moments)));
  compare_with_solutions(assembled, channels, loading, expansions, basis, result);
  std::vector<Eigen::MatrixXd> coefficients;
  for (const PoleExpansion& part : expansions.parts) coefficients.push_back(basis.coefficients(part));

  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Eigen::VectorXd factor = basis.omega().unaryExpr([&](double w) { return multiplier(moments[i], w); });
    for (std::size_t a = 0; a < expansions.parts.size(); ++a) {
      foundation::report_progress(progress, "random response", (static_cast<double>(i) + static_cast<double>(a) / static_cast<double>(expansions.parts.size())) / static_cast<double>(moments.size()));
      for (std::size_t b = 0; b <= a; ++b) {
        const PoleExpansion &of_a = expansions.parts[a], &of_b = expansions.parts[b];
        // Σ H_j* S_jk H_k: the answer of part a stands with the density from b to a.
        Eigen::VectorXcd weight = cross_density(loading, of_b.load, of_a.load, basis.omega());
        if (weight.size() == 0) continue;
        weight = weight.cwiseProduct(factor.cast<Complex>()).eval();
        const double later = of_a.delay - of_b.delay;
        if (later != 0) weight = weight.cwiseProduct(basis.omega().unaryExpr([&](double w) { return std::polar(1.0, -w * later); })).eval();
        const Eigen::MatrixXd gram = basis.real_products(weight);
        const Eigen::VectorXd product = (coefficients[a](moments[i].channels, Eigen::all) * gram).cwiseProduct(coefficients[b](moments[i].channels, Eigen::all)).rowwise().sum();
        for (std::size_t c = 0; c < moments[i].channels.size(); ++c) {
          const Eigen::Index channel = moments[i].channels[c];
          const double value = product(static_cast<Eigen::Index>(c));
          result.mean_square(channel, static_cast<Eigen::Index>(i)) += a == b ? value : 2 * value;
          if (i > 0) continue;
          result.share(channel, static_cast<Eigen::Index>(of_a.load)) += value;
          if (a != b) result.share(channel, static_cast<Eigen::Index>(of_b.load)) += value;
        }
      }
    }
  }
  return result;
}

}  // namespace trivet::response
