// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/random_variance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/polynomial_roots.h"
#include "trivet/response/random/basis_integrals.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

const excitation::InputPair* pair_of(const RandomLoading& loading, std::size_t j, std::size_t k) {
  for (const excitation::InputPair& pair : loading.pairs)
    if (std::minmax(pair.first, pair.second) == std::minmax(j, k)) return &pair;
  return nullptr;
}

/// Ends of all pieces of all spectra.
std::set<double> all_breakpoints(const RandomLoading& loading) {
  std::set<double> points;
  for (const RandomInput& input : loading.inputs)
    for (const double omega : excitation::breakpoints(input.spectrum)) points.insert(omega);
  return points;
}

/// The root of a density has a branch point where the density falls to 0 along a line; panels are graded toward it.
std::vector<double> zeros_of_density(const RandomLoading& loading) {
  constexpr double beside = 1e-7;  // of the piece: the rest is 1e-7^1.5 of its integral
  std::vector<double> zeros;
  for (const RandomInput& input : loading.inputs)
    for (const excitation::SpectrumPiece& p : input.spectrum.pieces) {
      if (p.density_from == 0) zeros.push_back(p.from - beside * (p.to - p.from));
      if (p.density_to == 0) zeros.push_back(p.to + beside * (p.to - p.from));
    }
  return zeros;
}

}  // namespace

std::vector<RandomMoment> random_moments(const std::vector<assembly::Channel>& channels, const RandomOptions& options) {
  std::vector<Eigen::Index> all(channels.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<RandomMoment> moments = {{all, 0, {}}, {all, 1, {}}};
  for (const WeightedChannel& weighted : options.weighted)
    moments.push_back({{to_index(weighted.channel)}, 2 - channels[weighted.channel].derivative, weighted.weighting});
  return moments;
}

double weight(const RandomMoment& moment, double omega) {
  return moment.weighting ? std::norm(excitation::transfer(*moment.weighting, omega)) : 1;
}

int order_at_rest(const RandomMoment& moment) {
  int of_weighting = 0;
  if (moment.weighting) {
    const excitation::RationalTransfer transfer = excitation::rational_transfer(*moment.weighting);
    while (transfer.numerator[of_weighting] == 0) {
      ++of_weighting;
      assert(to_size(of_weighting) < transfer.numerator.size() && "a weighting does not vanish");
    }
  }
  return 2 * (moment.derivative + of_weighting);
}

std::optional<int> order_at_rest(const excitation::Spectrum& spectrum) {
  if (spectrum.from() > 0) return std::nullopt;
  const excitation::SpectrumPiece& first = spectrum.pieces.front();
  return first.factor + (first.density_from == 0 ? 1 : 0);
}

Eigen::VectorXcd cross_density(const RandomLoading& loading, std::size_t j, std::size_t k,
                               const Eigen::VectorXd& omega) {
  assert(j < loading.inputs.size() && k < loading.inputs.size());
  const excitation::Spectrum &first = loading.inputs[j].spectrum, &second = loading.inputs[k].spectrum;
  if (j == k) return omega.unaryExpr([&](double w) { return Complex(excitation::density(first, w)); });
  const excitation::InputPair* pair = pair_of(loading, j, k);
  if (!pair) return {};
  const double delay = pair->first == j ? pair->delay : -pair->delay;
  return omega.unaryExpr([&](double w) {
    return std::polar(std::sqrt(excitation::coherence(pair->coherence, w) * excitation::density(first, w) *
                                excitation::density(second, w)),
                      -w * delay);
  });
}

double longest_delay(const RandomLoading& loading) {
  double shortest = std::numeric_limits<double>::infinity(), longest = -shortest, of_pairs = 0;
  for (const RandomInput& input : loading.inputs)
    for (const numerics::Load* load : {&input.loading.force, &input.loading.motion})
      for (const numerics::LoadTerm& term : load->terms())
        shortest = std::min(shortest, term.delay), longest = std::max(longest, term.delay);
  for (const excitation::InputPair& pair : loading.pairs) {
    const double decay = pair.coherence.decay == 0
        ? 0
        : pair.coherence.decay * pair.coherence.distance / (2 * std::numbers::pi * pair.coherence.speed);
    of_pairs = std::max(of_pairs, std::abs(pair.delay) + decay);
  }
  return std::max(0.0, longest - shortest) + of_pairs;
}

Eigen::VectorXcd with_poles_of_input(const Eigen::VectorXcd& poles, const RandomLoading& loading,
                                     const std::vector<RandomMoment>& moments) {
  std::vector<Complex> all(poles.begin(), poles.end());
  for (const RandomMoment& moment : moments)
    if (moment.weighting)
      for (const Complex& root :
           numerics::polynomial_roots(excitation::rational_transfer(*moment.weighting).denominator))
        all.push_back(root);
  if (!loading.pairs.empty())
    for (const double omega : zeros_of_density(loading)) all.emplace_back(0, omega);
  return Eigen::Map<const Eigen::VectorXcd>(all.data(), to_index(all.size()));
}

std::vector<double> panel_ends(const Eigen::VectorXcd& poles, const RandomLoading& loading,
                               const std::vector<RandomMoment>& moments) {
  const Eigen::VectorXcd smooth = with_poles_of_input(poles, loading, moments);
  Eigen::VectorXcd with_rest(smooth.size() + 1);
  with_rest << smooth, 0.0;
  const double delay = longest_delay(loading);
  std::vector<double> ends;
  double last = -1;
  for (const double to : all_breakpoints(loading)) {
    if (last >= 0) {
      const std::vector<double> more = graded_panels(last > 0 ? with_rest : smooth, last, to, delay);
      ends.insert(ends.end(), more.begin() + (ends.empty() ? 0 : 1), more.end());
    }
    last = to;
  }
  assert(std::ranges::is_sorted(ends) && "panels of neighbouring spectra share one end");
  return ends;
}

bool is_undamped(const Complex& pole, double fastest) {
  return std::abs(pole.real()) <= 64 * std::numeric_limits<double>::epsilon() * std::abs(pole) ||
      std::abs(pole.real()) <= 1e-15 * fastest;
}

std::vector<Eigen::Index> undamped_poles_in_band(const Eigen::VectorXcd& poles, const RandomLoading& loading) {
  const double fastest = poles.size() ? poles.cwiseAbs().maxCoeff() : 0;
  const auto driven = [&](double omega) {
    for (const RandomInput& input : loading.inputs)
      for (const excitation::SpectrumPiece& piece : input.spectrum.pieces)
        if (omega >= piece.from && omega <= piece.to && piece.density_from + piece.density_to > 0) return true;
    return false;
  };
  std::vector<Eigen::Index> result;
  for (Eigen::Index k = 0; k < poles.size(); ++k)
    if (is_undamped(poles(k), fastest) && poles(k).imag() > 0 && driven(poles(k).imag())) result.push_back(k);
  return result;
}

RandomVariances no_variances(Eigen::Index channels, std::size_t moments, std::size_t inputs) {
  RandomVariances result;
  result.mean_square = Eigen::MatrixXd::Zero(channels, to_index(moments));
  result.share = Eigen::MatrixXd::Zero(channels, to_index(inputs));
  result.reason.assign(to_size(channels), std::vector<std::string>(moments));
  result.error = result.misfit = Eigen::VectorXd::Zero(channels);
  result.vanishes.assign(to_size(channels), false);
  return result;
}

}  // namespace trivet::response
