// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/random_methods.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/response/random/basis_integrals.h"
#include "trivet/response/steady/channel_terms.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// A coefficient below this share of its terms counts as 0: at an undamped pole, or at ω = 0 if a spectrum begins
/// there.
constexpr double negligible_share = 1e-9;
/// Number of frequencies at which the form is checked against direct solutions: about half at poles, half between.
constexpr int checked_frequencies = 16;
/// Largest number of values in the basis at a time.
constexpr Eigen::Index most_numbers = 6'000'000;

bool significant(const Complex& value, double possible) { return std::abs(value) > negligible_share * possible; }

/// Marks infinite moments and removes their terms, and round-off in place of such terms, from the expansions.
void sort_out_infinite(const RandomLoading& loading, const std::vector<RandomMoment>& moments,
                       PoleExpansions& expansions, RandomVariances& result) {
  const std::vector<Eigen::Index> undamped = undamped_poles_in_band(expansions.poles, loading);
  for (PoleExpansion& part : expansions.parts) {
    const std::optional<int> of_spectrum = order_at_rest(loading.inputs[part.load].spectrum);
    for (Eigen::Index c = 0; c < part.residue.rows(); ++c) {
      std::vector<std::string>& reason = result.reason[c];
      for (const Eigen::Index k : undamped) {
        if (significant(part.residue(c, k), part.possible_residue(c, k)))
          for (std::string& r : reason)
            r = "an undamped natural frequency is in the band of \"" + loading.inputs[part.load].name + "\"";
        part.residue(c, k) = 0;
      }
      for (int m = lowest_power; m < 0 && of_spectrum; ++m) {
        Complex& coefficient = part.power(c, m - lowest_power);
        const bool matters = significant(coefficient, part.possible_power(c, m - lowest_power));
        if (!matters) coefficient = 0;
        for (std::size_t i = 0; i < moments.size() && matters; ++i)
          if (2 * m + *of_spectrum + order_at_rest(moments[i]) <= -1 && reason[i].empty())
            reason[i] = "the spectrum of \"" + loading.inputs[part.load].name +
                "\" begins at 0 Hz, where the result is unbounded";
      }
    }
  }
  // Undamped poles are removed with their conjugates, so that the others stay pairs.
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < expansions.poles.size(); ++k) {
    const bool out = std::ranges::any_of(undamped, [&](Eigen::Index u) {
      return u == k || (expansions.real && expansions.poles(k) == std::conj(expansions.poles(u)));
    });
    if (!out) kept.push_back(k);
  }
  if (kept.size() == to_size(expansions.poles.size())) return;
  expansions.poles = expansions.poles(kept).eval();
  for (PoleExpansion& part : expansions.parts) {
    part.residue = part.residue(Eigen::all, kept).eval();
    part.possible_residue = part.possible_residue(Eigen::all, kept).eval();
  }
}

/// Frequencies of the poles, ascending by relative distance to the nearest other pole: near-defective ones first.
std::vector<double> frequencies_of_poles(const Eigen::VectorXcd& poles) {
  std::vector<std::pair<double, double>> by_distance;
  for (Eigen::Index k = 0; k < poles.size(); ++k) {
    if (poles(k).imag() < 0) continue;
    double nearest = std::numeric_limits<double>::infinity();
    assert(poles(k) != 0.0 && "distances are relative to |λ|");
    for (Eigen::Index j = 0; j < poles.size(); ++j)
      if (j != k) nearest = std::min(nearest, std::abs(poles(j) - poles(k)) / std::abs(poles(k)));
    by_distance.emplace_back(nearest, poles(k).imag() > 0 ? poles(k).imag() : std::abs(poles(k)));
  }
  std::ranges::sort(by_distance);
  std::vector<double> frequencies;
  for (const auto& [distance, frequency] : by_distance) frequencies.push_back(frequency);
  return frequencies;
}

/// Nodes for the comparison: at the poles nearest to each other, at some of all poles, and spread over all nodes.
IntegrationNodes check_nodes(const Eigen::VectorXcd& poles, const Eigen::VectorXd& omega) {
  assert(omega.size() > 0 && "a spectrum has a density above 0 somewhere, and nodes there");
  std::vector<double> in_band = frequencies_of_poles(poles);
  std::erase_if(in_band, [&](double w) { return !(w >= omega(0) && w <= omega(omega.size() - 1)); });
  std::vector<double> wanted(in_band.begin(),
                             in_band.begin() + std::min<std::ptrdiff_t>(checked_frequencies / 4, std::ssize(in_band)));
  std::ranges::sort(in_band);
  for (int i = 0; i < checked_frequencies / 4 && !in_band.empty(); ++i)
    wanted.push_back(in_band[to_size(i) * (in_band.size() - 1) / (checked_frequencies / 4 - 1)]);
  for (Eigen::Index i = 0; i < checked_frequencies / 2; ++i)
    wanted.push_back(omega(i * (omega.size() - 1) / (checked_frequencies / 2 - 1)));
  std::ranges::sort(wanted);
  wanted.erase(std::ranges::unique(wanted).begin(), wanted.end());
  const Eigen::VectorXd points = Eigen::Map<const Eigen::VectorXd>(wanted.data(), to_index(wanted.size()));
  return {points, Eigen::VectorXd::Ones(points.size())};
}

/// The nodes at which a spectrum is not zero.
Eigen::VectorXd nodes_within(const excitation::Spectrum& spectrum, const Eigen::VectorXd& omega) {
  std::vector<double> within;
  for (const double w : omega)
    if (excitation::density(spectrum, w) > 0) within.push_back(w);
  return Eigen::Map<const Eigen::VectorXd>(within.data(), to_index(within.size()));
}

/// Relative error near a lightly damped pole that round-off of the matrices causes, whatever the solver.
double conditioning(const Eigen::VectorXcd& poles, double omega) {
  if (poles.size() == 0) return 0;
  const double distance = (poles.array() - Complex(0, omega)).abs().minCoeff();
  return 16 * std::numeric_limits<double>::epsilon() * poles.cwiseAbs2().maxCoeff() / (omega * distance);
}

/// Compares the form with direct solutions of each input within its spectrum, weighted by the root of the density; sets
/// `error`, `misfit`, `vanishes`.
void compare_with_solutions(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                            const RandomLoading& loading, const PoleExpansions& expansions,
                            const Eigen::VectorXd& all_nodes, RandomVariances& result) {
  const auto count = to_index(channels.size());
  Eigen::VectorXd miss = Eigen::VectorXd::Zero(count), unexplained = miss, largest = miss, possible = miss;
  for (std::size_t i = 0; i < loading.inputs.size(); ++i) {
    const RandomInput& input = loading.inputs[i];
    const BasisIntegrals basis(expansions, check_nodes(expansions.poles, nodes_within(input.spectrum, all_nodes)));
    const std::vector<double> omega(basis.omega().begin(), basis.omega().end());
    const ChannelSamples direct = channel_samples(assembled, channels, input.loading, omega);
    std::vector<std::pair<double, Eigen::MatrixXcd>> parts;  // delay and values
    for (const PoleExpansion& part : expansions.parts)
      if (part.load == i) parts.emplace_back(part.delay, basis.values(part));
    for (std::size_t f = 0; f < omega.size(); ++f) {
      const double amplitude = std::sqrt(excitation::density(input.spectrum, omega[f]));
      const auto column = to_index(f);
      Eigen::VectorXcd value = Eigen::VectorXcd::Zero(count);
      for (const auto& [delay, values] : parts) value += std::polar(1.0, -omega[f] * delay) * values.col(column);
      const Eigen::VectorXd size = direct.value.col(column).cwiseAbs(),
                            difference = (value - direct.value.col(column)).cwiseAbs();
      const Eigen::VectorXd noise = conditioning(expansions.poles, omega[f]) * size +
          1024 * std::numeric_limits<double>::epsilon() * direct.possible.col(column);
      miss = miss.cwiseMax(amplitude * difference);
      unexplained = unexplained.cwiseMax(amplitude * (difference - noise));
      largest = largest.cwiseMax(amplitude * size);
      possible = possible.cwiseMax(amplitude * direct.possible.col(column));
    }
    result.solutions += static_cast<int>(omega.size());
  }
  for (Eigen::Index c = 0; c < count; ++c) {
    const auto& reason = result.reason[c];
    if (std::ranges::none_of(reason, [](const std::string& r) { return r.empty(); })) continue;
    const bool vanishes = !(largest(c) > vanishing_channel * possible(c));
    result.vanishes[c] = vanishes;
    if (vanishes) continue;
    result.error(c) = 1e-12 + 2 * miss(c) / largest(c);
    result.misfit(c) = 2 * unexplained(c) / largest(c);
  }
}

/// Parts of the results and of their derivatives: [derivative][part].
using Parts = std::vector<std::vector<PoleExpansion>>;

/// Adds one pair of parts to a moment, and the magnitudes of its terms to `possible`.
void add_pair(const RandomMoment& moment, Eigen::Index column, const PoleExpansion& of_a, const PoleExpansion& of_b,
              bool same, const BasisIntegrals& basis, const Eigen::MatrixXd& products, RandomVariances& result,
              Eigen::MatrixXd& possible) {
  const Eigen::MatrixXd a = basis.coefficients(of_a)(moment.channels, Eigen::all),
                        b = basis.coefficients(of_b)(moment.channels, Eigen::all);
  const Eigen::VectorXd value = (a * products).cwiseProduct(b).rowwise().sum();
  Eigen::VectorXd size = Eigen::VectorXd::Zero(value.size());
  if (same) size = (a.cwiseAbs() * products.diagonal().cwiseAbs().cwiseSqrt()).cwiseAbs2();
  for (std::size_t i = 0; i < moment.channels.size(); ++i) {
    const Eigen::Index c = moment.channels[i];
    const double share = value(to_index(i));
    result.mean_square(c, column) += same ? share : 2 * share;
    possible(c, column) += size(to_index(i));
    if (column > 0) continue;
    result.share(c, to_index(of_a.load)) += share;
    if (!same) result.share(c, to_index(of_b.load)) += share;
  }
}

/// Adds ∫ Σ H_j* S_jk H_k over some of the nodes to every moment.
void add_mean_squares(const RandomLoading& loading, const std::vector<RandomMoment>& moments, const Parts& parts,
                      const BasisIntegrals& basis, RandomVariances& result, Eigen::MatrixXd& possible) {
  for (std::size_t a = 0; a < parts[0].size(); ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      // Σ H_j* S_jk H_k with j = b and k = a: the density is S_ba.
      Eigen::VectorXcd density = cross_density(loading, parts[0][b].load, parts[0][a].load, basis.omega());
      if (density.size() == 0) continue;
      const double later = parts[0][a].delay - parts[0][b].delay;
      if (later != 0)
        density =
            density.cwiseProduct(basis.omega().unaryExpr([&](double w) { return std::polar(1.0, -w * later); })).eval();
      const Eigen::MatrixXd plain = basis.real_products(density);
      for (std::size_t i = 0; i < moments.size(); ++i) {
        assert(moments[i].derivative >= 0 && to_size(moments[i].derivative) < parts.size());
        const auto derivative = to_size(moments[i].derivative);
        const auto add = [&](const Eigen::MatrixXd& products) {
          add_pair(moments[i], to_index(i), parts[derivative][a], parts[derivative][b], a == b, basis, products, result,
                   possible);
        };
        if (!moments[i].weighting) add(plain);
        else
          add(basis.real_products(
              density.cwiseProduct(basis.omega().unaryExpr([&](double w) { return Complex(weight(moments[i], w)); }))));
      }
    }
}

}  // namespace

RandomVariances variances_by_poles(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                   const RandomLoading& loading, const std::vector<RandomMoment>& moments,
                                   const PoleExpansions& given, const foundation::Progress& progress) {
  RandomVariances result = no_variances(to_index(channels.size()), moments.size(), loading.inputs.size());
  if (!std::ranges::all_of(
          given.parts, [](const PoleExpansion& part) { return part.residue.allFinite() && part.power.allFinite(); })) {
    result.misfit.setConstant(std::numeric_limits<double>::infinity());
    return result;
  }
  PoleExpansions expansions = given;
  sort_out_infinite(loading, moments, expansions, result);
  const IntegrationNodes nodes = gauss_nodes(panel_ends(expansions.poles, loading, moments));
  compare_with_solutions(assembled, channels, loading, expansions, nodes.omega, result);
  Parts parts = {expansions.parts};
  int highest = 0;
  for (const RandomMoment& moment : moments) highest = std::max(highest, moment.derivative);
  for (int derivative = 1; derivative <= highest; ++derivative) {
    parts.emplace_back();
    for (const PoleExpansion& part : parts[derivative - 1])
      parts.back().push_back(differentiated(part, expansions.poles));
    expansions.parts.insert(expansions.parts.end(), parts.back().begin(), parts.back().end());
  }
  Eigen::MatrixXd possible = Eigen::MatrixXd::Zero(result.mean_square.rows(), result.mean_square.cols());
  const Eigen::Index portion = std::max<Eigen::Index>(16, most_numbers / (expansions.poles.size() + 1));
  for (Eigen::Index first = 0; first < nodes.omega.size(); first += portion) {
    foundation::report_progress(progress, "random response",
                                static_cast<double>(first) / static_cast<double>(nodes.omega.size()));
    const Eigen::Index count = std::min(portion, nodes.omega.size() - first);
    const BasisIntegrals basis(expansions, {nodes.omega.segment(first, count), nodes.weight.segment(first, count)});
    add_mean_squares(loading, moments, parts, basis, result, possible);
  }
  // If large terms cancel, their sum is no more accurate than this.
  for (Eigen::Index c = 0; c < possible.rows(); ++c)
    for (std::size_t i = 0; i < moments.size() && !result.vanishes[c]; ++i) {
      const auto column = to_index(i);
      if (!result.reason[c][i].empty() || possible(c, column) == 0) continue;
      const double lost = fraction_accuracy * possible(c, column) / std::max(result.mean_square(c, column), 0.0);
      result.error(c) = std::max(result.error(c), lost);
      result.misfit(c) = std::max(result.misfit(c), lost);
    }
  return result;
}

}  // namespace trivet::response
