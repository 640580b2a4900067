// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/nonlinear/rest/load_path.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/search/zeros_and_minima.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<double> LoadPath::starts(Index j) const {
  assert(j >= 0 && j < linear_.size());
  constexpr double smallest = 1e-7, largest = 10, ratio = 1.1;  // [m, rad]
  const auto missing = [&](double x) {
    return x + receptance_(j, j) * deflections_[j].law.at_rest(x).force - linear_(j);
  };
  std::vector<double> grid = {0};
  for (double x = smallest; x < largest; x *= ratio) {
    grid.push_back(x);
    grid.insert(grid.begin(), -x);
  }
  std::vector<double> found = {linear_(j)};
  const auto rubs = [&](Index first) {
    return first >= 0 && deflections_[first].rubbing && !deflections_[first].rubbing->law.is_ring();
  };
  if (rubs(j) || rubs(j - 1)) return found;  // linear
  for (Index first = std::max<Index>(0, j - 2); first <= j; ++first)
    if (const auto& distance = deflections_[first].distance; distance && !distance->is_ring())
      found.push_back(distance->mirrored(j - first));
  for (std::size_t i = 0; i + 1 < grid.size(); ++i)
    if ((missing(grid[i]) < 0) != (missing(grid[i + 1]) < 0)) found.push_back((grid[i] + grid[i + 1]) / 2);
  return found;
}

bool LoadPath::is_among(const VectorXd& one, const std::vector<VectorXd>& found) const {
  constexpr double same = 1e-6, round_off = 1e-12;
  return std::ranges::any_of(found, [&](const VectorXd& other) {
    return (other - one).norm() <= std::max(same * std::max(other.norm(), one.norm()), round_off * typical_.norm()) ||
        other == one;
  });
}

/// δ = b s with r(s) = s − s_linear + γ bᵀ f(b s), as G = γ b bᵀ. Between neighbouring places r has as many zeros as
/// its signs there and at its extremes show.
std::optional<std::vector<VectorXd>> LoadPath::scanned() const {
  Index largest = 0;
  (void)across_.colwise().norm().maxCoeff(&largest);
  const VectorXd one = across_.col(largest) / across_.col(largest).squaredNorm();
  VectorXd b = across_.transpose() * one;
  constexpr double round_off = 1e-12;
  if ((across_ - across_.col(largest) * b.transpose()).norm() > round_off * across_.norm()) return std::nullopt;
  const double gain = receptance_(largest, largest), linear = linear_(largest);
  const auto force = [&](double s) { return forces(b * s); };
  const auto missing = [&](double s) { return s - linear + gain * b.dot(force(s).force); };
  const auto slope = [&](double s) { return 1 + gain * b.dot(force(s).tangent * b); };
  std::vector<double> zeros;
  const auto add_zero = [&](double low, double high) {
    const double at_low = missing(low), at_high = missing(high);
    if (std::isfinite(at_low) && std::isfinite(at_high) && (at_low < 0) != (at_high < 0))
      zeros.push_back(numerics::zero_between(low, high, missing));
  };
  constexpr double smallest = 1e-9, farthest = 10, ratio = 1.02;  // [m, rad]
  std::vector<double> places = {0, linear};
  for (double x = smallest; x < farthest; x *= ratio) {
    places.push_back(x);
    places.push_back(-x);
  }
  for (Index j = 0; j < b.size(); ++j)
    if (const auto& distance = deflections_[j].distance; distance && !distance->is_ring())
      for (Index a = 0; a < 3; ++a)
        if (b(j + a) != 0) places.push_back(distance->mirrored(a) / b(j + a));
  std::ranges::sort(places);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double low = places[i], high = places[i + 1], at_low = slope(low), at_high = slope(high);
    if (low == high) continue;
    if (missing(low) == 0) zeros.push_back(low);
    if (std::isfinite(at_low) && std::isfinite(at_high) && (at_low < 0) != (at_high < 0)) {
      const double extreme = numerics::zero_between(low, high, slope);
      add_zero(low, extreme);
      add_zero(extreme, high);
    } else {
      add_zero(low, high);
    }
  }
  std::vector<VectorXd> found;
  for (const double s : zeros)
    if (const VectorXd there = b * s; are_known(there) && !is_among(there, found)) found.push_back(there);
  return found;
}

void LoadPath::add(const VectorXd& start, std::vector<VectorXd>& found) const {
  if (std::optional<VectorXd> rest = solved(start, 0); rest && are_known(*rest) && !is_among(*rest, found))
    found.push_back(std::move(*rest));
}

/// Deflections of two or three coordinates, as far as struts snap through and positions were found, and half as much
/// again.
void LoadPath::add_from_grid(std::vector<VectorXd>& found) const {
  constexpr double round_off = 1e-9, farther = 1.5;
  const numerics::PivotedQr factors = numerics::pivoted_qr(across_.transpose(), round_off);
  const Index rank = factors.rank;
  if (rank > 3) return;
  const Index places = rank == 2 ? 24 : 9;
  const MatrixXd along = factors.Q.leftCols(rank);
  VectorXd extent = typical_.cwiseAbs();
  for (const VectorXd& one : found) extent = extent.cwiseMax(one.cwiseAbs());
  for (Index j = 0; j < extent.size(); ++j)
    if (const auto& distance = deflections_[j].distance; distance && !distance->is_ring())
      for (Index a = 0; a < 3; ++a) extent(j + a) = std::max(extent(j + a), std::abs(distance->mirrored(a)));
  const VectorXd farthest = farther * along.cwiseAbs().transpose() * extent;
  for (Index i = 0; i < (rank == 2 ? places * places : places * places * places); ++i) {
    VectorXd share(rank);
    for (Index a = 0, rest = i; a < rank; ++a, rest /= places)
      share(a) = 2 * static_cast<double>(rest % places) / static_cast<double>(places - 1) - 1;
    add(along * share.cwiseProduct(farthest), found);
  }
}

/// Between two stable positions there is an unstable one.
void LoadPath::add_between(std::vector<VectorXd>& found) const {
  constexpr std::size_t most = 12;
  constexpr int parts = 8;
  for (std::size_t i = 0; i < found.size() && i < most; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int part = 1; part < parts; ++part) {
        const double share = static_cast<double>(part) / parts;
        add((1 - share) * found[i] + share * found[j], found);
      }
}

std::vector<VectorXd> LoadPath::all() const {
  if (linear_.size() == 0) return {};
  if (!(across_.norm() > 0)) return {VectorXd::Zero(linear_.size())};  // no nonlinear part can move
  std::vector<VectorXd> found;
  const auto in_order = [](std::vector<VectorXd> states) {
    std::ranges::sort(states, [](const VectorXd& a, const VectorXd& b) { return a(0) < b(0); });
    return states;
  };
  if (std::optional<std::vector<VectorXd>> of_one = scanned()) return in_order(std::move(*of_one));
  std::vector<std::vector<double>> choices;
  for (Index j = 0; j < linear_.size(); ++j) choices.push_back(starts(j));
  constexpr int most_starts = 2000;
  double all_starts = 1;
  for (const std::vector<double>& of_one : choices) all_starts *= static_cast<double>(of_one.size());
  const bool tries_all = all_starts <= most_starts;
  std::mt19937_64 random(20261127);
  std::vector<std::size_t> chosen(choices.size(), 0);
  for (int i = 0; i < most_starts; ++i) {
    VectorXd start(linear_.size());
    for (std::size_t j = 0; j < choices.size(); ++j) start(to_index(j)) = choices[j][chosen[j]];
    add(start, found);
    if (!tries_all) {
      for (std::size_t j = 0; j < choices.size(); ++j) chosen[j] = random() % choices[j].size();
      continue;
    }
    std::size_t place = 0;
    while (place < chosen.size() && ++chosen[place] == choices[place].size()) chosen[place++] = 0;
    if (place == chosen.size()) break;
  }
  add_from_grid(found);
  add_between(found);
  return in_order(std::move(found));
}

}  // namespace trivet::nonlinear
