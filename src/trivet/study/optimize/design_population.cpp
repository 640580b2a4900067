// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/design_search.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "trivet/foundation/index.h"
#include "trivet/study/optimize/sampled_starts.h"

namespace trivet::study {
namespace {

/// Generations of a population: without a better design for so many, it ends.
constexpr int most_generations = 400, generations_without_gain = 60;

class Population {
 public:
  Population(const DesignObjective& objective, const std::vector<Eigen::VectorXd>& first,
             const foundation::Progress& progress)
      : objective_(objective), progress_(progress), members_(to_index(first.size()), first.front().size()) {
    for (std::size_t i = 0; i < first.size(); ++i) members_.row(to_index(i)) = first[i].transpose();
    ranks_ = family_ranks(objective_, members_, {}, progress_);
  }

  void evolve() {
    double best = highest();
    for (int generation = 0, idle = 0; generation < most_generations && idle < generations_without_gain; ++generation) {
      step();
      constexpr double gain = 1e-4;  // of ln(margin)
      idle = highest() > best + gain ? 0 : idle + 1;
      best = std::max(best, highest());
      foundation::report_progress(progress_, "evolving", (generation + 1.0) / most_generations);
    }
  }

  /// The best members that lie apart.
  [[nodiscard]] std::vector<Eigen::VectorXd> best(std::size_t wanted) const {
    constexpr double apart = 0.05;
    std::vector<Eigen::VectorXd> chosen;
    for (const std::size_t i : by_rank()) {
      if (chosen.size() >= wanted) break;
      const Eigen::VectorXd one = members_.row(to_index(i)).transpose();
      if (std::ranges::none_of(
              chosen, [&](const Eigen::VectorXd& other) { return (other - one).lpNorm<Eigen::Infinity>() <= apart; }))
        chosen.push_back(one);
    }
    return chosen;
  }

 private:
  [[nodiscard]] double highest() const { return *std::ranges::max_element(ranks_); }

  [[nodiscard]] std::vector<std::size_t> by_rank() const {
    std::vector<std::size_t> order(ranks_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return ranks_[a] > ranks_[b]; });
    return order;
  }

  /// Each member against a trial from it, one of the best and two others.
  void step() {
    constexpr double best_share = 0.15, crossing = 0.9, least_scale = 0.3, most_scale = 0.9;
    const std::vector<std::size_t> order = by_rank();
    const auto count = ranks_.size();
    const std::size_t leaders =
        std::max<std::size_t>(2, static_cast<std::size_t>(best_share * static_cast<double>(count)));
    Eigen::MatrixXd trials = members_;
    for (std::size_t i = 0; i < count; ++i) {
      const auto row = [&](std::size_t member) { return members_.row(to_index(member)); };
      const std::size_t leader = order[below(leaders)], a = below(count), b = below(count);
      const double scale = least_scale + (most_scale - least_scale) * uniform();
      const Eigen::RowVectorXd moved = row(i) + scale * (row(leader) - row(i)) + scale * (row(a) - row(b));
      const auto sure = to_index(below(to_size(members_.cols())));
      for (Eigen::Index j = 0; j < members_.cols(); ++j) {
        if (j != sure && uniform() > crossing) continue;
        const double from = members_(to_index(i), j);
        // Beyond an end: halfway to it.
        trials(to_index(i), j) = moved(j) < 0 ? from / 2 : moved(j) > 1 ? (1 + from) / 2 : moved(j);
      }
    }
    const std::vector<double> found = family_ranks(objective_, trials, ranks_, progress_);
    for (std::size_t i = 0; i < count; ++i) {
      if (!(found[i] > ranks_[i])) continue;
      ranks_[i] = found[i];
      members_.row(to_index(i)) = trials.row(to_index(i));
    }
  }

  double uniform() {
    constexpr double to_unit = 0x1p-53;
    return static_cast<double>(random_() >> 11U) * to_unit;
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }

  const DesignObjective& objective_;
  const foundation::Progress& progress_;
  std::mt19937_64 random_{1};  // the same numbers in every run
  Eigen::MatrixXd members_;
  std::vector<double> ranks_;
};

}  // namespace

bool can_evolve(const DesignObjective& objective) {
  return objective.minimized().weights().empty() &&
      std::ranges::all_of(objective.families(), [](const DesignBatch& one) { return one.judges(); });
}

std::vector<Eigen::VectorXd> evolved_designs(const DesignObjective& objective,
                                             const std::vector<Eigen::VectorXd>& first, std::size_t wanted,
                                             const foundation::Progress& progress) {
  Population population(objective, first, progress);
  population.evolve();
  return population.best(wanted);
}

}  // namespace trivet::study
