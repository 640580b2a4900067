// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/sampled_starts.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/family/packed_margins.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

constexpr std::size_t look_piece = 512;  // designs; their matrices fit in the cache
constexpr std::size_t small_piece = 32;  // of a population, for several threads

Eigen::ArrayXXd of_curves(const CaseVector& of, const CaseVector::Unpacked& designs) {
  return curve_margins(of, designs).margins;
}

/// Designs judged by the kernels of all cases.
class Looks {
 public:
  Looks(const DesignObjective& objective, const foundation::Progress& progress)
      : objective_(objective), progress_(progress) {}

  /// Rows of `shares` by descending rank: the best `wanted` for certain, and others behind them.
  std::vector<std::size_t> best(const Eigen::MatrixXd& shares, std::size_t wanted) {
    std::vector<std::size_t> all = judge_quickly(shares);
    const std::size_t count = all.size();
    const auto by_rank = [&](std::size_t a, std::size_t b) { return rank_of(a) > rank_of(b); };
    std::ranges::stable_sort(all, by_rank);
    // Amplitudes and peaks lower the ranks further: in this order, until what is left cannot be among the best.
    constexpr std::size_t batch = 4096;
    std::vector<std::size_t> judged;
    for (std::size_t first = 0; first < count; first += batch) {
      const auto from = all.begin() + static_cast<std::ptrdiff_t>(first);
      const std::vector<std::size_t> next(from, from + static_cast<std::ptrdiff_t>(std::min(batch, count - first)));
      if (judged.size() >= wanted && rank_of(judged[wanted - 1]) >= rank_of(next.front())) break;
      lower(next, &of_curves);
      judged.insert(judged.end(), next.begin(), next.end());
      std::ranges::stable_sort(judged, by_rank);
    }
    return judged;
  }

  /// @param needed  see family_ranks
  std::vector<double> ranks(const Eigen::MatrixXd& shares, const std::vector<double>& needed) {
    std::vector<std::size_t> left = judge_quickly(shares);
    const std::size_t count = left.size();
    if (!needed.empty()) std::erase_if(left, [&](std::size_t design) { return rank_of(design) <= needed[design]; });
    lower(left, &of_curves);
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(rank_of(i));
    return result;
  }

 private:
  /// All requirements but amplitudes and peaks. @returns the numbers of all designs
  std::vector<std::size_t> judge_quickly(const Eigen::MatrixXd& shares) {
    shares_ = &shares;
    const auto count = to_size(shares.rows());
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    objectives_.assign(count, DesignObjective::most);
    constraints_.assign(count, DesignObjective::most);
    lower(all, &quick_margins);
    return all;
  }

  [[nodiscard]] double rank_of(std::size_t design) const { return rank(objectives_[design], constraints_[design]); }

  /// Lowers objectives and constraints to the margins that a kernel finds.
  void lower(const std::vector<std::size_t>& which,
             Eigen::ArrayXXd (*kernel)(const CaseVector&, const CaseVector::Unpacked&)) {
    const std::size_t piece = to_size(shares_->rows()) > look_piece ? look_piece : small_piece;
    foundation::parallel_for(which.size(), {.size = piece, .progress = progress_, .task = "looking"},
                             [&](std::size_t first, std::size_t last) {
                               Eigen::MatrixXd values(to_index(last - first), shares_->cols());
                               for (std::size_t i = first; i < last; ++i)
                                 values.row(to_index(i - first)) =
                                     objective_.space().values(shares_->row(to_index(which[i])).transpose());
                               for (std::size_t c = 0; c < objective_.families().size(); ++c) {
                                 const DesignBatch& one = objective_.families()[c];
                                 if (!one.reason().empty()) continue;
                                 const Eigen::ArrayXXd margins = kernel(one.packed(), one.designs(values));
                                 for (std::size_t i = first; i < last; ++i)
                                   set(which[i], c, margins.row(to_index(i - first)).transpose());
                               }
                             });
  }

  void set(std::size_t design, std::size_t c, const Eigen::ArrayXd& margins) {
    for (Eigen::Index r = 0; r < margins.size(); ++r) {
      const bool counts = !objective_.minimized().any() || objective_.minimized().contain({c, to_size(r)});
      double& least = counts ? objectives_[design] : constraints_[design];
      const double reserve = objective_.reserve({c, to_size(r)});
      const double value =
          margins(r) > 0 ? std::log(margins(r)) - reserve : DesignObjective::unusable;  // also if unknown
      least = std::min(least, std::max(value, DesignObjective::unusable));
    }
  }

  const DesignObjective& objective_;
  const foundation::Progress& progress_;
  const Eigen::MatrixXd* shares_ = nullptr;
  std::vector<double> objectives_, constraints_;  ///< ln of the least margins
};

/// The first `wanted` of these rows that lie apart.
std::vector<Eigen::VectorXd> apart(const Eigen::MatrixXd& shares, const std::vector<std::size_t>& rows,
                                   std::size_t wanted) {
  std::vector<Eigen::VectorXd> chosen;
  for (const double distance : {0.1, 0.0})
    for (const std::size_t row : rows) {
      if (chosen.size() >= wanted) return chosen;
      const Eigen::VectorXd point = shares.row(to_index(row)).transpose();
      const bool near = std::ranges::any_of(
          chosen, [&](const Eigen::VectorXd& other) { return (other - point).lpNorm<Eigen::Infinity>() <= distance; });
      if (!near) chosen.push_back(point);
    }
  return chosen;
}

}  // namespace

Eigen::MatrixXd sobol_points(Eigen::Index dimensions, std::size_t count) {
  boost::random::sobol sequence(static_cast<std::size_t>(dimensions));
  const auto whole = static_cast<double>(boost::random::sobol::max()) + 1;
  Eigen::MatrixXd points(to_index(count), dimensions);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (Eigen::Index j = 0; j < dimensions; ++j) points(i, j) = static_cast<double>(sequence()) / whole;
  return points;
}

std::vector<double> family_ranks(const DesignObjective& objective, const Eigen::MatrixXd& shares,
                                 const std::vector<double>& needed, const foundation::Progress& progress) {
  return Looks(objective, progress).ranks(shares, needed);
}

SampledStarts sampled_starts(const DesignObjective& objective, std::size_t wanted, const foundation::Progress& progress,
                             std::size_t among) {
  const bool any = std::ranges::any_of(objective.families(), [](const DesignBatch& one) { return one.judges(); });
  const std::size_t count = any ? std::max(among, wanted) : wanted;
  const Eigen::MatrixXd shares = sobol_points(to_index(objective.space().size()), count);
  SampledStarts looks;
  looks.judged = any ? count : 0;
  if (any) {
    looks.points = apart(shares, Looks(objective, progress).best(shares, wanted), wanted);
  } else {
    for (Eigen::Index i = 0; i < shares.rows(); ++i) looks.points.emplace_back(shares.row(i).transpose());
  }
  return looks;
}

double rank(double objective, double constraint) {
  constexpr double below_all = -1e3;
  return constraint >= least_met ? objective : below_all + constraint;
}

}  // namespace trivet::study
