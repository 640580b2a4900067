// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/variance_shares.h"

#include <algorithm>

#include "trivet/foundation/index.h"

namespace trivet::numerics {
namespace {

/// Values are known to these: less variation is that of their computation.
constexpr double nine_digits = 1e-9;

}  // namespace

PairedValues::PairedValues(std::size_t dimensions, std::size_t replicates) : sums_(replicates) {
  for (Sums& one : sums_) {
    one.first = Eigen::VectorXd::Zero(to_index(dimensions));
    one.total = Eigen::VectorXd::Zero(to_index(dimensions) + 1);
  }
}

void PairedValues::add(std::size_t replicate, double at_a, double at_b, const Eigen::VectorXd& exchanged) {
  if (!reference_) reference_ = at_a;
  Sums& to = sums_[replicate];
  ++to.pairs;
  for (const double value : {at_a - *reference_, at_b - *reference_}) {
    to.sum += value;
    to.squares += value * value;
  }
  to.first += (exchanged.array() - at_b).square().matrix();
  to.total.head(exchanged.size()) += (exchanged.array() - at_a).square().matrix();
  to.total(exchanged.size()) += (at_b - at_a) * (at_b - at_a);
}

std::vector<VarianceShare> PairedValues::shares(double confidence) const {
  std::vector<double> variances;
  for (const Sums& one : sums_) {
    if (one.pairs < 2) return {};
    const double count = 2 * static_cast<double>(one.pairs), mean = one.sum / count;
    variances.push_back(one.squares / count - mean * mean);
    constexpr double round_off = 1e-14;
    const double undecided = nine_digits * *reference_;
    if (!(variances.back() > std::max(round_off * one.squares / count, undecided * undecided))) return {};
  }
  std::vector<VarianceShare> found;
  for (Eigen::Index d = 0; d < sums_.front().first.size(); ++d) {
    std::vector<double> first, total;
    for (std::size_t r = 0; r < sums_.size(); ++r) {
      const Sums& of = sums_[r];
      // Twice the variance from the same pairs: a number without influence has f(ab) = f(a) and the share 0 exactly,
      // where the variance of all values leaves the difference of both estimates.
      first.push_back(1 - of.first(d) / of.total(of.first.size()));
      total.push_back(of.total(d) / (2 * variances[r] * static_cast<double>(of.pairs)));
    }
    found.push_back({mean_of_replicates(first, confidence), mean_of_replicates(total, confidence)});
  }
  return found;
}

}  // namespace trivet::numerics
