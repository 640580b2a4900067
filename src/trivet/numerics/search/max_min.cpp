// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/search/max_min.h"

#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/nonnegative_least_squares.h"

namespace trivet::numerics {
namespace {

using Optimizer = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

Optimizer optimizer(Eigen::Index variables) {
  Optimizer result(nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(variables)), nlopt_destroy);
  if (!result) throw foundation::NotComputable("the optimizer has no memory");
  return result;
}

/// Constraints that are met, or less violated, come first.
bool is_better(const MaxMinPoint& a, const MaxMinPoint& b, double tolerance) {
  const double violation_a = std::min(0.0, a.constraint + tolerance),
               violation_b = std::min(0.0, b.constraint + tolerance);
  return violation_a != violation_b ? violation_a > violation_b : a.objective > b.objective;
}

/// The least objective value of each group.
Eigen::VectorXd least_of_groups(const MaxMinProblem& problem, const Eigen::VectorXd& values) {
  Eigen::VectorXd least = Eigen::VectorXd::Constant(to_index(problem.groups()), foundation::infinity);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (problem.is_objective[i]) {
      double& one = least(to_index(problem.group_of(to_size(i))));
      one = std::min(one, values(i));
    }
  return least;
}

constexpr double slack_tolerance = 1e-11;

/// The problem with its bounds t as last variables, for the callbacks of NLopt. The values do not depend on them, with
/// which a line search ends: they are kept.
class Bounded {
 public:
  Bounded(const MaxMinProblem& problem, nlopt_opt optimizer, MaxMinPoint start)
      : problem_(problem), optimizer_(optimizer), best_(std::move(start)) {}

  /// The best point that was evaluated: NLopt's own result lacks a point whose t exceeds a value by round-off.
  [[nodiscard]] const MaxMinPoint& best() const { return best_; }

  /// Σ w_g t_g
  static double bound(unsigned n, const double* x, double* slope, void* self) {
    const MaxMinProblem& problem = static_cast<Bounded*>(self)->problem_;
    const auto variables = static_cast<unsigned>(problem.variables);
    if (slope) std::fill(slope, slope + n, 0.0);
    double sum = 0;
    for (unsigned k = variables; k < n; ++k) {
      sum += problem.weight(k - variables) * x[k];
      if (slope) slope[k] = problem.weight(k - variables);
    }
    return sum;
  }

  /// t − v_i ≤ 0 or −v_i ≤ 0; slopes row by row.
  static void slack(unsigned m, double* result, unsigned n, const double* x, double* slope, void* self) {
    auto& bounded = *static_cast<Bounded*>(self);
    try {
      bounded.set_slack(m, result, n, x, slope);
    } catch (...) {
      bounded.failure_ = std::current_exception();
      std::fill(result, result + m, 0.0);
      if (slope) std::fill(slope, slope + static_cast<std::size_t>(m) * n, 0.0);
      nlopt_force_stop(bounded.optimizer_);
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void evaluate(const Eigen::VectorXd& x, bool slopes) {
    if (x.size() == x_.size() && x == x_ && (!slopes || slopes_.size() > 0)) return;
    x_.resize(0);
    slopes_.resize(0, 0);
    problem_.evaluate(x, values_, slopes ? &slopes_ : nullptr);
    x_ = x;
    const bool inside = (x.array() >= 0).all() && (x.array() <= 1).all();
    const MaxMinPoint here = point_with(problem_, x, values_);
    if (inside && is_better(here, best_, 10 * slack_tolerance)) best_ = here;
  }

  void set_slack(unsigned m, double* result, unsigned n, const double* x, double* slope) {
    const auto variables = static_cast<unsigned>(problem_.variables);
    evaluate(Eigen::Map<const Eigen::VectorXd>(x, problem_.variables), slope != nullptr);
    for (unsigned i = 0; i < m; ++i) {
      const bool objective = problem_.is_objective[i];
      const unsigned t = variables + static_cast<unsigned>(problem_.group_of(i));
      result[i] = (objective ? x[t] : 0) - values_(i);
      if (!slope) continue;
      double* const row = slope + static_cast<std::size_t>(i) * n;
      std::fill(row, row + n, 0.0);
      for (unsigned j = 0; j < variables; ++j) row[j] = -slopes_(i, j);
      if (objective) row[t] = 1;
    }
  }

  const MaxMinProblem& problem_;
  nlopt_opt optimizer_;
  std::exception_ptr failure_;
  MaxMinPoint best_;
  Eigen::VectorXd x_, values_;  ///< evaluated last
  Eigen::MatrixXd slopes_;      ///< there, or empty
};

/// Slopes below this are no scale for a residual: at a smooth maximum of one value all of them vanish.
constexpr double flat = 1e-2;

}  // namespace

MaxMinPoint point_with(const MaxMinProblem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& values) {
  MaxMinPoint point{x, 0, foundation::infinity};
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (!problem.is_objective[i]) point.constraint = std::min(point.constraint, values(i));
  const Eigen::VectorXd least = least_of_groups(problem, values);
  for (Eigen::Index g = 0; g < least.size(); ++g) point.objective += problem.weight(to_size(g)) * least(g);
  return point;
}

MaxMinPoint point_at(const MaxMinProblem& problem, const Eigen::VectorXd& x) {
  Eigen::VectorXd values;
  problem.evaluate(x, values, nullptr);
  return point_with(problem, x, values);
}

MaxMinPoint max_min(const MaxMinProblem& problem, const Eigen::VectorXd& start) {
  constexpr double step_tolerance = 1e-10, gain = 1e-9;
  constexpr int most_evaluations = 150, most_rounds = 4;
  const Eigen::Index n = problem.variables;
  const auto m = static_cast<unsigned>(problem.is_objective.size());
  constexpr double narrower = 0.2;  // of the reach of a climb whose first steps led to nothing better
  double reach = 1;
  MaxMinPoint best = point_at(problem, start);
  for (int round = 0; round < most_rounds; ++round) {
    const Eigen::Index all = n + to_index(problem.groups());
    const Optimizer library = optimizer(all);
    Bounded bounded(problem, library.get(), best);
    constexpr double far = 1e3;
    Eigen::VectorXd x(all), low = Eigen::VectorXd::Constant(all, -far), high = Eigen::VectorXd::Constant(all, far);
    low.head(n) = (best.x.array() - reach).cwiseMax(0.0);
    high.head(n) = (best.x.array() + reach).cwiseMin(1.0);
    Eigen::VectorXd values;
    problem.evaluate(best.x, values, nullptr);
    x << best.x, least_of_groups(problem, values).cwiseMax(-far).cwiseMin(far);
    const std::vector<double> tolerances(m, slack_tolerance);
    nlopt_set_lower_bounds(library.get(), low.data());
    nlopt_set_upper_bounds(library.get(), high.data());
    nlopt_set_max_objective(library.get(), Bounded::bound, &bounded);
    nlopt_add_inequality_mconstraint(library.get(), m, Bounded::slack, &bounded, tolerances.data());
    nlopt_set_xtol_rel(library.get(), step_tolerance);
    nlopt_set_maxeval(library.get(), most_evaluations);
    double t = 0;
    nlopt_optimize(library.get(), x.data(), &t);
    bounded.rethrow();
    const MaxMinPoint& found = bounded.best();
    const bool worth = found.objective > best.objective + gain || found.constraint > best.constraint + gain;
    best = found;
    if (worth) {
      reach = 1;
      continue;
    }
    if (best.x != start) break;
    reach *= narrower;  // the first steps are as long as the box, and may end where nothing has a slope
  }
  return best;
}

Multipliers multipliers(const MaxMinProblem& problem, const MaxMinPoint& point, double active) {
  Eigen::VectorXd values;
  Eigen::MatrixXd slopes;
  problem.evaluate(point.x, values, &slopes);
  const Eigen::VectorXd least = least_of_groups(problem, values);
  std::vector<Eigen::Index> near;
  bool any_objective = false;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const bool objective = problem.is_objective[i];
    if (values(i) > (objective ? least(to_index(problem.group_of(to_size(i)))) : 0.0) + active) continue;
    near.push_back(i);
    any_objective = any_objective || objective;
  }
  Multipliers result{Eigen::VectorXd::Zero(values.size()), foundation::infinity};
  if (!any_objective) return result;
  // Columns: slopes of the active values, then what the bounds in reach can take: +e_j at 0, −e_j at 1.
  constexpr double at_bound = 1e-9;
  const auto count = to_index(near.size());
  Eigen::MatrixXd columns(problem.variables, count + problem.variables);
  for (Eigen::Index i = 0; i < count; ++i) columns.col(i) = slopes.row(near[i]).transpose();
  Eigen::Index total = count;
  for (Eigen::Index j = 0; j < problem.variables; ++j) {
    const double side = point.x(j) <= at_bound ? 1 : point.x(j) >= 1 - at_bound ? -1 : 0;
    if (side != 0) columns.col(total++) = side * Eigen::VectorXd::Unit(problem.variables, j);
  }
  const double scale = std::max(columns.leftCols(count).colwise().norm().maxCoeff(), flat);
  columns.leftCols(count) /= scale;
  // The sum over the objectives of each group is a heavy row.
  constexpr double heavy = 1e4;
  const Eigen::Index groups = least.size();
  Eigen::MatrixXd system(problem.variables + groups, total);
  system.topRows(problem.variables) = columns.leftCols(total);
  system.bottomRows(groups).setZero();
  for (Eigen::Index i = 0; i < count; ++i)
    if (const std::size_t value = to_size(near[i]); problem.is_objective[value])
      system(problem.variables + to_index(problem.group_of(value)), i) = heavy;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(problem.variables + groups);
  for (Eigen::Index g = 0; g < groups; ++g) right(problem.variables + g) = heavy * problem.weight(to_size(g));
  const Eigen::VectorXd lambda = nonnegative_least_squares(system, right);
  result.residual = (columns.leftCols(total) * lambda).norm();
  for (Eigen::Index i = 0; i < count; ++i) result.of_values(near[i]) = lambda(i);
  return result;
}

}  // namespace trivet::numerics
