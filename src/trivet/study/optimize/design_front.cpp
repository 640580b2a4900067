// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/design_front.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/study/family/design_space.h"
#include "trivet/study/optimize/design_search.h"
#include "trivet/study/optimize/front_problems.h"
#include "trivet/study/optimize/sampled_starts.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

using numerics::MaxMinPoint;
using numerics::MaxMinProblem;

/// A value within this of the least one holds a point of the front, in scaled objectives.
constexpr double holds_within = 1e-6;

class FrontSearch {
 public:
  FrontSearch(const DesignObjective& objective, const project::OptimizeRequest& request,
              const foundation::Progress& progress)
      : objective_(objective), request_(request), progress_(progress), count_(objective.minimized().count()) {}

  DesignFront run() {
    look();
    find_ends();
    if (has_width()) {
      find_points();
      if (count_ == 2) space_evenly();
    } else {
      points_ = {ends_.front()};
    }
    return described();
  }

 private:
  /// Looks over the ranges; the given design counts too.
  void look() {
    const Eigen::MatrixXd points = sobol_points(to_index(objective_.space().size()),
                                                to_size(looks_for(request_.starts.value_or(project::usual_starts))));
    std::vector<Eigen::VectorXd> shares;
    for (Eigen::Index i = 0; i < points.rows(); ++i) shares.emplace_back(points.row(i).transpose());
    if (const auto given = objective_.space().given_shares()) shares.push_back(*given);
    looks_.resize(shares.size());
    foundation::parallel_for(shares.size(), {.progress = progress_, .task = "looking"},
                             [&](std::size_t first, std::size_t last) {
                               for (std::size_t i = first; i < last; ++i)
                                 looks_[i] = front_values(objective_, shares[i]);
                             });
  }

  /// The looks with the largest least value of a problem, at most `most`, apart from each other.
  [[nodiscard]] std::vector<Eigen::VectorXd> best_looks(const std::function<double(const FrontValues&)>& merit,
                                                        std::size_t most) const {
    std::vector<MaxMinPoint> merits;
    for (const FrontValues& look : looks_)
      if (look.amplitudes.allFinite()) merits.push_back({look.x, merit(look), look.constraint});
    std::vector<Eigen::VectorXd> chosen;
    for (MaxMinPoint& one : chosen_starts(std::move(merits), most)) chosen.push_back(std::move(one.x));
    return chosen;
  }

  static MaxMinPoint best_climb(const MaxMinProblem& problem, const std::vector<Eigen::VectorXd>& starts) {
    MaxMinPoint best{starts.front(), -foundation::infinity, -foundation::infinity};
    for (const Eigen::VectorXd& start : starts)
      if (MaxMinPoint end = max_min(problem, start); rank(end) > rank(best)) best = std::move(end);
    return best;
  }

  /// The least of each objective, and of those designs the one with the least of the others.
  void find_ends() {
    ends_.resize(count_);
    const std::size_t most = to_size(std::max(1, request_.starts.value_or(project::usual_starts)));
    for (std::size_t i = 0; i < count_; ++i) {
      const auto merit = [&](const FrontValues& look) { return -std::log(look.amplitudes(to_index(i))); };
      const std::vector<Eigen::VectorXd> starts = best_looks(merit, most);
      if (starts.empty()) refuse_without_design();
      std::vector<MaxMinPoint> found(starts.size());
      const MaxMinProblem problem = least_amplitude(objective_, i);
      foundation::parallel_for(starts.size(), {.progress = progress_, .task = "ends of the front"},
                               [&](std::size_t first, std::size_t last) {
                                 for (std::size_t k = first; k < last; ++k) found[k] = max_min(problem, starts[k]);
                               });
      MaxMinPoint best = found.front();
      for (const MaxMinPoint& one : found)
        if (rank(one) > rank(best)) best = one;
      if (best.constraint < least_met)
        throw foundation::NotComputable(
            "optimize: no design looked at meets every requirement, so there is no front; leave front out, and the "
            "search says what contradicts what");
      ends_[i] = with_least_others(i, best);
    }
  }

  void refuse_without_design() const {
    throw foundation::NotComputable("optimize: no design of the ranges can be computed" +
                                    (objective_.counts().first_failure.empty()
                                         ? std::string(": an undamped resonance lies in the band; add damping, or "
                                                       "change the band")
                                         : ": " + objective_.counts().first_failure));
  }

  [[nodiscard]] FrontValues with_least_others(std::size_t wanted, const MaxMinPoint& best) const {
    constexpr double eased = 1 + 1e-9;
    Eigen::VectorXd held = Eigen::VectorXd::Constant(to_index(count_), foundation::infinity);
    FrontValues end = front_values(objective_, best.x);
    held(to_index(wanted)) = eased * end.amplitudes(to_index(wanted));
    for (std::size_t j = 0; j < count_; ++j) {
      if (j == wanted) continue;
      const MaxMinPoint better = max_min(least_amplitude_below(objective_, j, held), end.x);
      const FrontValues there = front_values(objective_, better.x);
      const bool within = (there.amplitudes.array() <= held.array()).all() && there.constraint >= least_met;
      if (within && there.amplitudes(to_index(j)) <= end.amplitudes(to_index(j))) end = there;
      held(to_index(j)) = eased * end.amplitudes(to_index(j));
    }
    return end;
  }

  /// The ranges of the objectives between the ends; false if one design has the least of all.
  bool has_width() {
    std::vector<Eigen::VectorXd> amplitudes;
    for (const FrontValues& end : ends_) amplitudes.push_back(end.amplitudes);
    scale_ = FrontScale(amplitudes);
    return scale_.has_width();
  }

  [[nodiscard]] MaxMinProblem problem_from(const Eigen::VectorXd& weights) const {
    return towards_less(objective_, scale_.amplitudes(scale_.between_ends(weights)), scale_.width());
  }

  /// Straight from points of the line or plane through the ends towards less of all.
  void find_points() {
    weights_ = even_weights(count_, count_ == 2 ? request_.points : points_of_three_objectives);
    points_.resize(weights_.size());
    foundation::parallel_for(weights_.size(), {.progress = progress_, .task = "front"},
                             [&](std::size_t first, std::size_t last) {
                               for (std::size_t k = first; k < last; ++k) points_[k] = found_point(weights_[k]);
                             });
  }

  [[nodiscard]] FrontValues found_point(const Eigen::VectorXd& weights) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (weights(to_index(i)) == 1) return ends_[i];
    const Eigen::VectorXd from = scale_.between_ends(weights);
    const auto merit = [&](const FrontValues& look) { return (from - scale_.shares(look.amplitudes)).minCoeff(); };
    constexpr std::size_t climbs = 4;
    std::vector<Eigen::VectorXd> starts = best_looks(merit, climbs);
    for (const FrontValues& end : ends_) starts.push_back(end.x);
    return front_values(objective_, best_climb(problem_from(weights), starts).x);
  }

  /// Moves the points along the front until neighbours are equally far apart.
  void space_evenly() {
    constexpr int most_rounds = 8;
    constexpr double even = 1.02;
    for (int round = 0; round < most_rounds && unevenness() > even; ++round) {
      const std::vector<double> shares = equally_spaced(first_weights(), scaled_points());
      const std::vector<FrontValues> before = points_;
      const std::vector<Eigen::VectorXd> weights_before = weights_;
      foundation::parallel_for(
          weights_.size(), {.progress = progress_, .task = "spacing"}, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
              if (k == 0 || k + 1 == weights_.size()) continue;
              weights_[k] = Eigen::Vector2d(shares[k], 1 - shares[k]);
              std::vector<Eigen::VectorXd> starts;
              for (std::size_t i = 0; i + 1 < before.size(); ++i)  // the neighbours before
                if (weights_before[i](0) >= shares[k] && weights_before[i + 1](0) <= shares[k])
                  starts = {before[i].x, before[i + 1].x};
              points_[k] = front_values(objective_, best_climb(problem_from(weights_[k]), starts).x);
            }
          });
    }
  }

  [[nodiscard]] std::vector<double> first_weights() const {
    std::vector<double> shares;
    for (const Eigen::VectorXd& one : weights_) shares.push_back(one(0));
    return shares;
  }

  [[nodiscard]] std::vector<Eigen::VectorXd> scaled_points() const {
    std::vector<Eigen::VectorXd> scaled;
    for (const FrontValues& point : points_) scaled.push_back(scale_.shares(point.amplitudes));
    return scaled;
  }

  [[nodiscard]] double unevenness() const { return longest_over_shortest(scaled_points()); }

  DesignFront described() {
    DesignFront result;
    result.parameters = objective_.space().axes();
    result.given = objective_.space().given();
    if (!weights_.empty()) leave_out(result);
    describe_objectives(result);
    for (std::size_t k = 0; k < points_.size(); ++k) result.points.push_back(described(k));
    if (scale_.has_width()) {
      if (count_ == 2 && points_.size() > 2) result.unevenness = unevenness();
      for (std::size_t k = 0; k < points_.size(); ++k) {
        const double distance = scale_.beyond_ends(scale_.shares(points_[k].amplitudes));
        constexpr double noticeable = 1e-3;
        if (distance <= std::max(noticeable, result.knee_distance)) continue;
        result.knee = k;
        result.knee_distance = distance;
      }
    }
    const EvaluationCounts counts = objective_.counts();
    result.evaluations = counts.evaluations;
    result.failed = counts.failed;
    result.first_failure = counts.first_failure;
    result.differenced = objective_.differenced();
    result.differences = counts.differences;
    return result;
  }

  /// Removes points that are not on the front.
  void leave_out(DesignFront& result) {
    std::vector<FrontValues> met;
    std::vector<Eigen::VectorXd> weights, scaled;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (points_[k].constraint < least_met || !points_[k].amplitudes.allFinite()) {
        ++result.not_found;
        continue;
      }
      met.push_back(points_[k]);
      weights.push_back(weights_[k]);
      scaled.push_back(scale_.shares(points_[k].amplitudes));
    }
    const std::vector<PlaceOnFront> places = places_on_front(scaled);
    points_.clear();
    weights_.clear();
    for (std::size_t k = 0; k < met.size(); ++k) {
      if (places[k] == PlaceOnFront::dominated) ++result.dominated;
      else if (places[k] == PlaceOnFront::repeated) ++result.coinciding;
      else {
        points_.push_back(met[k]);
        weights_.push_back(weights[k]);
      }
    }
  }

  [[nodiscard]] const RequirementResult& given_objective(std::size_t number) const {
    return objective_.given().front()[objective_.minimized().result(0, number)];
  }

  void describe_objectives(DesignFront& result) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const RequirementResult& one = given_objective(i);
      FrontObjective& objective = result.objectives.emplace_back();
      objective.name = one.subject;
      objective.unit = one.unit;
      objective.least = foundation::infinity;
      for (const FrontValues& point : points_) {
        const double amplitude = one.allowed * point.amplitudes(to_index(i));
        objective.least = std::min(objective.least, amplitude);
        objective.most = std::max(objective.most, amplitude);
      }
      objective.given = objective_.minimized().largest(i, objective_.given());
    }
  }

  [[nodiscard]] FrontPoint described(std::size_t k) const {
    FrontPoint point;
    const Eigen::VectorXd values = objective_.space().values(points_[k].x);
    point.values.assign(values.begin(), values.end());
    for (std::size_t i = 0; i < count_; ++i)
      point.amplitudes.push_back(given_objective(i).allowed * points_[k].amplitudes(to_index(i)));
    const Eigen::VectorXd& reached = points_[k].amplitudes;
    const bool single = !scale_.has_width();
    const MaxMinProblem problem =
        single ? least_amplitude(objective_, 0) : towards_less(objective_, reached, scale_.width());
    const numerics::Multipliers found =
        numerics::multipliers(problem, numerics::point_at(problem, points_[k].x), holds_within);
    point.residual = found.residual;
    if (count_ != 2 || single) return point;
    Eigen::Vector2d sums = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < objective_.places().size(); ++i)
      if (objective_.is_objective()[i])
        sums(to_index(objective_.minimized().number(objective_.places()[i]))) += found.of_values(to_index(i));
    constexpr double some = 1e-6;
    if (sums.minCoeff() > some)
      point.exchange = (sums(0) * reached(0) / scale_.width()(0)) / (sums(1) * reached(1) / scale_.width()(1));
    return point;
  }

  const DesignObjective& objective_;
  const project::OptimizeRequest& request_;
  const foundation::Progress& progress_;
  std::size_t count_;
  std::vector<FrontValues> looks_, ends_, points_;
  std::vector<Eigen::VectorXd> weights_;  ///< of the ends, per point
  FrontScale scale_;
};

}  // namespace

DesignFront design_front(const project::Project& project, const foundation::Progress& progress) {
  const project::OptimizeRequest request = project.base().analyses.optimize.value_or(project::OptimizeRequest());
  for (const project::MountChoice& choice : project.base().analyses.choices)
    if (request.varies(choice.name))
      throw foundation::InvalidInput("optimize: a front is between numbers, and " + foundation::quoted(choice.name) +
                                     " is a choice of mounts; name the numbers in parameters = [\"NAME\"] of "
                                     "[analyses.optimize]");
  const DesignObjective objective(project, request);
  DesignFront front = FrontSearch(objective, request, progress).run();
  front.warnings = parameter_warnings(project, objective.space());
  return front;
}

std::size_t chosen_point(const DesignFront& front) { return front.knee.value_or(front.points.size() / 2); }

std::vector<project::Node> front_changes(const DesignFront& front, std::size_t point) {
  std::vector<project::Node> changes;
  for (std::size_t j = 0; j < front.parameters.size(); ++j)
    changes.push_back(project::ModelNumber(front.parameters[j]).change(front.points[point].values[j]));
  return changes;
}

}  // namespace trivet::study
