// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/front_problems.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"

namespace trivet::study {

std::vector<Eigen::VectorXd> even_weights(std::size_t objectives, int along) {
  std::vector<Eigen::VectorXd> result;
  const double last = along - 1;
  for (int i = 0; i < along; ++i) {
    if (objectives == 2) {
      result.push_back(Eigen::Vector2d(1 - i / last, i / last));
      continue;
    }
    for (int j = 0; i + j < along; ++j) result.push_back(Eigen::Vector3d(1 - (i + j) / last, i / last, j / last));
  }
  return result;
}

FrontScale::FrontScale(const std::vector<Eigen::VectorXd>& ends) {
  least_ = ends.front();
  Eigen::VectorXd most = ends.front();
  for (const Eigen::VectorXd& end : ends) {
    least_ = least_.cwiseMin(end);
    most = most.cwiseMax(end);
  }
  width_ = most - least_;
  constexpr double no_width = 1e-6;
  has_width_ = (width_.array() > no_width * most.array()).all();
  if (has_width_)
    for (const Eigen::VectorXd& end : ends) ends_.push_back(shares(end));
}

Eigen::VectorXd FrontScale::shares(const Eigen::VectorXd& amplitudes) const {
  return (amplitudes - least_).cwiseQuotient(width_);
}

Eigen::VectorXd FrontScale::amplitudes(const Eigen::VectorXd& shares) const {
  return least_ + shares.cwiseProduct(width_);
}

Eigen::VectorXd FrontScale::between_ends(const Eigen::VectorXd& weights) const {
  Eigen::VectorXd point = Eigen::VectorXd::Zero(weights.size());
  for (std::size_t i = 0; i < ends_.size(); ++i) point += weights(to_index(i)) * ends_[i];
  return point;
}

double FrontScale::beyond_ends(const Eigen::VectorXd& shares) const {
  Eigen::VectorXd normal = Eigen::VectorXd::Ones(shares.size());
  if (shares.size() == 2) {
    const Eigen::VectorXd along = ends_[1] - ends_[0];
    normal = Eigen::Vector2d(-along(1), along(0));
  } else {
    const Eigen::Vector3d a = ends_[1] - ends_[0], b = ends_[2] - ends_[0];
    normal = a.cross(b);
  }
  if (normal.norm() == 0) return 0;
  if (normal.sum() < 0) normal = -normal;
  return normal.dot(ends_[0] - shares) / normal.norm();
}

double longest_over_shortest(const std::vector<Eigen::VectorXd>& points) {
  double longest = 0, shortest = 1e300;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double distance = (points[i + 1] - points[i]).norm();
    longest = std::max(longest, distance);
    shortest = std::min(shortest, distance);
  }
  constexpr double smallest = 1e-12;
  return longest / std::max(shortest, smallest);
}

std::vector<double> equally_spaced(const std::vector<double>& at, const std::vector<Eigen::VectorXd>& points) {
  std::vector<double> length = {0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    length.push_back(length.back() + (points[i + 1] - points[i]).norm());
  std::vector<double> result = at;
  for (std::size_t k = 1; k + 1 < at.size(); ++k) {
    const double wanted = length.back() * static_cast<double>(k) / static_cast<double>(at.size() - 1);
    const auto next = std::ranges::upper_bound(length, wanted);
    const std::size_t i = std::min(to_size(next - length.begin()), length.size() - 1);
    const double share = (wanted - length[i - 1]) / (length[i] - length[i - 1]);
    result[k] = at[i - 1] + share * (at[i] - at[i - 1]);
  }
  return result;
}

std::vector<PlaceOnFront> places_on_front(const std::vector<Eigen::VectorXd>& points) {
  constexpr double same = 1e-6;  // of the range of an objective
  std::vector<PlaceOnFront> places(points.size(), PlaceOnFront::on);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size() && places[i] == PlaceOnFront::on; ++j) {
      if (i == j) continue;
      const Eigen::VectorXd worse = points[i] - points[j];
      if (worse.minCoeff() >= -same && worse.maxCoeff() > same) places[i] = PlaceOnFront::dominated;
      else if (j < i && worse.lpNorm<Eigen::Infinity>() <= same) places[i] = PlaceOnFront::repeated;
    }
  return places;
}

namespace {

/// Where an objective cannot be computed: worse than every amplitude, and small enough for the search.
constexpr double far_below = -1e3;

/// The problem of all objectives, whose values another one rewrites.
numerics::MaxMinProblem rewritten(
    const DesignObjective& objective,
    const std::function<void(std::size_t wanted, double& value, Eigen::MatrixXd* slopes, Eigen::Index row)>& rewrite) {
  return {to_index(objective.space().size()), objective.is_objective(),
          [&objective, rewrite](const Eigen::VectorXd& x, Eigen::VectorXd& values, Eigen::MatrixXd* slopes) {
            objective.evaluate(x, values, slopes);
            for (std::size_t i = 0; i < objective.places().size(); ++i)
              if (objective.is_objective()[i])
                rewrite(objective.minimized().number(objective.places()[i]), values(to_index(i)), slopes, to_index(i));
          }};
}

void ignore(double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
  value = DesignObjective::most;
  if (slopes) slopes->row(row).setZero();
}

}  // namespace

FrontValues front_values(const DesignObjective& objective, const Eigen::VectorXd& x) {
  FrontValues result{x, Eigen::VectorXd::Zero(to_index(objective.minimized().count())), foundation::infinity};
  Eigen::VectorXd values;
  objective.evaluate(x, values, nullptr);
  for (std::size_t i = 0; i < objective.places().size(); ++i) {
    const double value = values(to_index(i));
    if (!objective.is_objective()[i]) {
      result.constraint = std::min(result.constraint, value);
      continue;
    }
    double& largest = result.amplitudes(to_index(objective.minimized().number(objective.places()[i])));
    largest = std::max(largest, value <= DesignObjective::unusable ? foundation::infinity : std::exp(-value));
  }
  return result;
}

numerics::MaxMinProblem least_amplitude(const DesignObjective& objective, std::size_t wanted) {
  return rewritten(objective, [wanted](std::size_t number, double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
    if (number != wanted) ignore(value, slopes, row);
  });
}

numerics::MaxMinProblem least_amplitude_below(const DesignObjective& objective, std::size_t wanted,
                                              const Eigen::VectorXd& held) {
  numerics::MaxMinProblem problem = rewritten(
      objective, [wanted, held](std::size_t number, double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
        if (number == wanted) return;
        if (std::isfinite(held(to_index(number)))) value += std::log(held(to_index(number)));
        else ignore(value, slopes, row);
      });
  for (std::size_t i = 0; i < objective.places().size(); ++i)
    problem.is_objective[i] =
        objective.is_objective()[i] && objective.minimized().number(objective.places()[i]) == wanted;
  return problem;
}

numerics::MaxMinProblem towards_less(const DesignObjective& objective, const Eigen::VectorXd& from,
                                     const Eigen::VectorXd& width) {
  return rewritten(objective,
                   [from, width](std::size_t number, double& value, Eigen::MatrixXd* slopes, Eigen::Index row) {
                     const Eigen::Index k = to_index(number);
                     if (value <= DesignObjective::unusable) {
                       value = far_below;
                       return;
                     }
                     const double amplitude = std::exp(-value);
                     value = std::max((from(k) - amplitude) / width(k), far_below);
                     if (slopes) slopes->row(row) *= amplitude / width(k);
                   });
}

}  // namespace trivet::study
