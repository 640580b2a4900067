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

PairedValues::Sums PairedValues::all_but(std::optional<std::size_t> left_out) const {
  Sums all{.first = Eigen::VectorXd::Zero(sums_.front().first.size()),
           .total = Eigen::VectorXd::Zero(sums_.front().total.size())};
  for (std::size_t r = 0; r < sums_.size(); ++r) {
    if (r == left_out) continue;
    all.pairs += sums_[r].pairs;
    all.sum += sums_[r].sum;
    all.squares += sums_[r].squares;
    all.first += sums_[r].first;
    all.total += sums_[r].total;
  }
  return all;
}

double PairedValues::variance(const Sums& of) const {
  const double count = 2 * static_cast<double>(of.pairs), mean = of.sum / count;
  const double found = of.squares / count - mean * mean;
  constexpr double round_off = 1e-14;
  const double undecided = nine_digits * *reference_;
  return found > std::max(round_off * of.squares / count, undecided * undecided) ? found : 0;
}

std::vector<VarianceShare> PairedValues::shares(double confidence) const {
  if (fewest_pairs() < 2) return {};
  const Eigen::Index dimensions = sums_.front().first.size();
  const auto replicates = static_cast<double>(sums_.size());
  struct Estimates {
    Eigen::ArrayXd first, total;
  };
  const auto estimates = [&](const Sums& of) -> std::optional<Estimates> {
    // Twice the variance from the same pairs: a number without influence has f(ab) = f(a) and the share 0 exactly,
    // where the variance of all values leaves the difference of both estimates.
    const double twice = of.total(dimensions), from_all = 2 * variance(of) * static_cast<double>(of.pairs);
    if (!(from_all > 0 && twice > 0)) return std::nullopt;
    return Estimates{1 - of.first.array() / twice, of.total.head(dimensions).array() / from_all};
  };
  const auto all = estimates(all_but(std::nullopt));
  if (!all) return {};
  std::vector<std::vector<double>> first(to_size(dimensions)), total(to_size(dimensions));
  for (std::size_t r = 0; r < sums_.size(); ++r) {
    const auto others = estimates(all_but(r));
    if (!others) return {};
    for (std::size_t d = 0; d < first.size(); ++d) {
      const auto pseudo_value = [&](const Eigen::ArrayXd& of_all, const Eigen::ArrayXd& of_others) {
        return replicates * of_all(to_index(d)) - (replicates - 1) * of_others(to_index(d));
      };
      first[d].push_back(pseudo_value(all->first, others->first));
      total[d].push_back(pseudo_value(all->total, others->total));
    }
  }
  std::vector<VarianceShare> found;
  for (std::size_t d = 0; d < first.size(); ++d)
    found.push_back({mean_of_replicates(first[d], confidence), mean_of_replicates(total[d], confidence)});
  return found;
}

}  // namespace trivet::numerics
