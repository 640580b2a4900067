// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/distributions.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"

namespace trivet::numerics {
namespace {

namespace policies = boost::math::policies;
/// Plain double arithmetic, equal on all processors.
using Normal = boost::math::normal_distribution<double, policies::policy<policies::promote_double<false>>>;

double normal_quantile(double share) { return quantile(Normal(), share); }
double normal_share(double value) { return cdf(Normal(), value); }

/// ln x is normal with this mean and standard deviation.
struct OfLogarithm {
  double mean = 0, deviation = 0;
  explicit OfLogarithm(const Distribution& lognormal) {
    const double relative = lognormal.spread / lognormal.mean;
    const double variance = std::log1p(relative * relative);
    mean = std::log(lognormal.mean) - variance / 2;
    deviation = std::sqrt(variance);
  }
};

double share_without_truncation(const Distribution& d, double value) {
  const double t = (value - d.mean) / d.spread;
  switch (d.shape) {
    case DistributionShape::uniform:
      return std::clamp((1 + t) / 2, 0.0, 1.0);
    case DistributionShape::triangular:
      if (t <= -1 || t >= 1) return t < 0 ? 0 : 1;
      return t < 0 ? (1 + t) * (1 + t) / 2 : 1 - (1 - t) * (1 - t) / 2;
    case DistributionShape::normal:
      return normal_share(t);
    case DistributionShape::lognormal: {
      const OfLogarithm logarithm(d);
      return value > 0 ? normal_share((std::log(value) - logarithm.mean) / logarithm.deviation) : 0;
    }
    case DistributionShape::measured: {
      const auto below = std::ranges::upper_bound(d.measured, value) - d.measured.begin();
      return static_cast<double>(below) / static_cast<double>(d.measured.size());
    }
  }
  return 0;
}

double quantile_without_truncation(const Distribution& d, double share) {
  switch (d.shape) {
    case DistributionShape::uniform:
      return d.mean + d.spread * (2 * share - 1);
    case DistributionShape::triangular:
      return d.mean + d.spread * (share < 0.5 ? std::sqrt(2 * share) - 1 : 1 - std::sqrt(2 * (1 - share)));
    case DistributionShape::normal:
      return d.mean + d.spread * normal_quantile(share);
    case DistributionShape::lognormal: {
      const OfLogarithm logarithm(d);
      return std::exp(logarithm.mean + logarithm.deviation * normal_quantile(share));
    }
    case DistributionShape::measured: {
      const auto place = static_cast<std::size_t>(share * static_cast<double>(d.measured.size()));
      return d.measured[std::min(place, d.measured.size() - 1)];
    }
  }
  return d.mean;
}

}  // namespace

double share_up_to(const Distribution& d, double value) {
  const double share = share_without_truncation(d, value);
  if (!d.truncated_at) return share;
  const double from = share_without_truncation(d, d.mean - *d.truncated_at),
               to = share_without_truncation(d, d.mean + *d.truncated_at);
  return std::clamp((share - from) / (to - from), 0.0, 1.0);
}

double quantile(const Distribution& d, double share) {
  if (!d.truncated_at) return quantile_without_truncation(d, share);
  const double least = d.mean - *d.truncated_at, most = d.mean + *d.truncated_at;
  const double from = share_without_truncation(d, least), to = share_without_truncation(d, most);
  return std::clamp(quantile_without_truncation(d, from + share * (to - from)), least, most);  // for round-off
}

std::pair<double, double> ends(const Distribution& d) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto within = [&](double distance) { return std::pair(d.mean - distance, d.mean + distance); };
  switch (d.shape) {
    case DistributionShape::uniform:
    case DistributionShape::triangular:
      return within(d.spread);
    case DistributionShape::measured:
      return {d.measured.front(), d.measured.back()};
    case DistributionShape::normal:
    case DistributionShape::lognormal:
      break;
  }
  auto found = within(d.truncated_at.value_or(infinity));
  if (d.shape == DistributionShape::lognormal && found.first <= 0) found.first = -infinity;
  return found;
}

namespace {

/// L with L Lᵀ = the matrix; empty if it is not positive definite: with a pivot of round-off it is not.
Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& matrix) {
  constexpr double least_pivot = 1e-12;
  const Eigen::Index n = matrix.rows();
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index r = 0; r < n; ++r) {
    for (Eigen::Index c = 0; c < r; ++c)
      lower(r, c) = (matrix(r, c) - lower.row(r).head(c).dot(lower.row(c).head(c))) / lower(c, c);
    const double pivot = matrix(r, r) - lower.row(r).head(r).squaredNorm();
    if (!(pivot > least_pivot)) return {};
    lower(r, r) = std::sqrt(pivot);
  }
  return lower;
}

}  // namespace

GaussianCopula::GaussianCopula(std::size_t dimensions, const std::vector<Correlation>& correlations) {
  std::vector<Eigen::Index> place(dimensions, -1);
  for (const Correlation& one : correlations)
    for (const std::size_t dimension : {one.a, one.b}) {
      if (place[dimension] >= 0) continue;
      place[dimension] = to_index(correlated_.size());
      correlated_.push_back(to_index(dimension));
    }
  const auto n = to_index(correlated_.size());
  const auto matrix = [&](std::size_t count) {
    Eigen::MatrixXd all = Eigen::MatrixXd::Identity(n, n);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Index a = place[correlations[i].a], b = place[correlations[i].b];
      all(a, b) = all(b, a) = correlations[i].value;
    }
    return all;
  };
  lower_ = cholesky_factor(matrix(correlations.size()));
  if (lower_.rows() == n) return;
  std::size_t first = 0;
  while (first + 1 < correlations.size() && cholesky_factor(matrix(first + 1)).rows() == n) ++first;
  impossible_ = first;
}

void GaussianCopula::correlate(Eigen::Ref<Eigen::VectorXd> shares) const {
  if (correlated_.empty()) return;
  Eigen::VectorXd normal(to_index(correlated_.size()));
  for (Eigen::Index i = 0; i < normal.size(); ++i) normal(i) = normal_quantile(shares(correlated_[to_size(i)]));
  const Eigen::VectorXd combined = lower_.triangularView<Eigen::Lower>() * normal;
  // Round-off may give 0 or 1 far in the tails, where a number is none of the distribution.
  constexpr double least = 0x1p-60, most = 1 - 0x1p-53;
  for (Eigen::Index i = 0; i < normal.size(); ++i)
    shares(correlated_[to_size(i)]) = std::clamp(normal_share(combined(i)), least, most);
}

}  // namespace trivet::numerics
