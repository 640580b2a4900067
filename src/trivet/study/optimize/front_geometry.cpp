// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/front_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

}  // namespace trivet::study
