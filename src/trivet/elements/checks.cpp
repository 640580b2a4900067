// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/checks.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/part_size.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::elements {

bool check_length(foundation::Problems& problems, const std::string& key, double value) {
  if (foundation::is_part_size(value)) return true;
  const bool positive = value > 0 && std::isfinite(value);
  problems.error(key, fmt::format("{} = {:.6g} m", key, value),
                 positive ? foundation::part_size_rule : "it must be > 0",
                 positive ? "check the unit and the power of ten" : "give a length in metres");
  return false;
}

bool check_lengths(foundation::Problems& problems, std::initializer_list<std::pair<const char*, double>> lengths) {
  bool sound = true;
  for (const auto& [key, value] : lengths) sound = check_length(problems, key, value) && sound;
  return sound;
}

void check_slenderness(foundation::Problems& problems, const std::string& key, double width, double thickness) {
  const double ratio = std::max(width, thickness) / std::min(width, thickness);
  if (ratio > foundation::most_slender)
    problems.error(
        key, fmt::format("{:.6g} m compared with {:.6g} m: a ratio of {:.3g}", thickness, width, ratio),
        fmt::format("two lengths of one part differ by a factor of {:.0f} at most", foundation::most_slender),
        "check the unit and the power of ten");
}

void check_factor(foundation::Problems& problems, double dynamic_factor) {
  constexpr double usual_from = 1, usual_to = 4;
  const std::string value = fmt::format("dynamic_factor = {:.6g}", dynamic_factor);
  if (!(dynamic_factor > 0) || !std::isfinite(dynamic_factor))
    problems.error("dynamic_factor", value, "it must be > 0", "1 is the static stiffness");
  else if (dynamic_factor < usual_from || dynamic_factor > usual_to)
    problems.warning("dynamic_factor", value, "dynamic over static stiffness of rubber is between 1 and 4",
                     "check the number against a test");
}

void check_shape_factor(foundation::Problems& problems, double shape_factor) {
  constexpr double lowest = 0.25, highest = 20;
  if (shape_factor < lowest || shape_factor > highest)
    problems.warning("thickness", fmt::format("the shape factor is {:.4g}", shape_factor),
                     "the formulas were checked for shape factors from 0.25 to 20",
                     "use a finite-element mount or check the dimensions");
}

namespace {

/// √K_ii, or √ of the largest entry of its row and column if K_ii is zero or round-off of other entries (1e-30 N m/rad
/// for a strut along a skew axis). No element's lever is shorter than 1e-10 m.
spatial::Vector12 entry_scale(const Matrix12& matrix) {
  constexpr double round_off = 1e-14, shortest_lever_squared = 1e-20;
  double translation = 0, rotation = 0;
  for (int i = 0; i < 12; ++i)
    (i % 6 < 3 ? translation : rotation) = std::max(i % 6 < 3 ? translation : rotation, std::abs(matrix(i, i)));
  spatial::Vector12 scale;
  for (int i = 0; i < 12; ++i) {
    const double floor =
        i % 6 < 3 ? round_off * translation : round_off * rotation + shortest_lever_squared * translation;
    const double diagonal = std::abs(matrix(i, i));
    const double beside = std::max(matrix.row(i).cwiseAbs().maxCoeff(), matrix.col(i).cwiseAbs().maxCoeff());
    scale(i) = std::sqrt(diagonal > floor ? diagonal : std::max(floor, beside));
  }
  return scale;
}

/// Round-off of an entry (row i, coordinate or motion j) of a matrix with translational stiffnesses acting over `arm`.
double entry_round_off(const Matrix12& matrix, double arm, int i, int j) {
  constexpr double count = 64;
  double translation = 0, rotation = 0;
  for (int k = 0; k < 12; ++k)
    (k % 6 < 3 ? translation : rotation) = std::max(k % 6 < 3 ? translation : rotation, std::abs(matrix(k, k)));
  const bool moment = i % 6 >= 3, turn = j % 6 >= 3;
  const double typical = translation * (moment ? arm : 1) * (turn ? arm : 1) + (moment && turn ? rotation : 0);
  return count * std::numeric_limits<double>::epsilon() * typical;
}

}  // namespace

Eigen::Matrix<double, 12, 6> turned_preload(const Vector12& preload, const Eigen::Matrix3d& n_from_k) {
  Eigen::Matrix<double, 12, 6> required = Eigen::Matrix<double, 12, 6>::Zero();
  for (int j = 0; j < 3; ++j) {
    const Eigen::Vector3d in_k = Eigen::Vector3d::Unit(j), in_n = n_from_k * in_k;
    required.col(3 + j) << in_n.cross(preload.segment<3>(0)), 0.5 * in_n.cross(preload.segment<3>(3)),
        in_k.cross(preload.segment<3>(6)), 0.5 * in_k.cross(preload.segment<3>(9));
  }
  return required;
}

MatrixVerdict examine(const Matrix12& matrix, const Eigen::Matrix<double, 12, 6>& rigid,
                      const Eigen::Matrix<double, 12, 6>& expected) {
  MatrixVerdict verdict;
  const spatial::Vector12 scale = entry_scale(matrix);
  const double arm = rigid.topRightCorner<3, 3>().norm();
  const auto scaled = [](double value, double by) { return value == 0 ? 0.0 : value / by; };
  const auto beyond_round_off = [&](double value, int i, int j) {
    return value > entry_round_off(matrix, arm, i, j) ? value : 0.0;
  };

  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < i; ++j) {
      const double asymmetry =
          scaled(beyond_round_off(std::abs(matrix(i, j) - matrix(j, i)), i, j), scale(i) * scale(j));
      if (asymmetry > verdict.asymmetry) {
        verdict.asymmetry = asymmetry;
        verdict.asymmetric_row = j;
        verdict.asymmetric_column = i;
      }
    }

  verdict.residual = matrix * rigid - expected;
  const Eigen::Matrix<double, 12, 6> from_left = matrix.transpose() * rigid - expected;
  for (int j = 0; j < 6; ++j) {
    const double motion_scale = rigid.col(j).cwiseAbs().cwiseProduct(scale).maxCoeff();
    for (int i = 0; i < 12; ++i) {
      const double worst = std::max(std::abs(verdict.residual(i, j)), std::abs(from_left(i, j)));
      const double residual = scaled(beyond_round_off(worst, i, j), scale(i) * motion_scale);
      if (residual > verdict.rigid_residual) {
        verdict.rigid_residual = residual;
        verdict.residual_row = i;
        verdict.residual_motion = j;
      }
    }
  }

  Matrix12 symmetric;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) symmetric(i, j) = scaled(0.5 * (matrix(i, j) + matrix(j, i)), scale(i) * scale(j));
  const spatial::Vector12 eigenvalues = numerics::symmetric_eigenvalues(symmetric);
  verdict.lowest_eigenvalue = eigenvalues(0);
  verdict.highest_eigenvalue = eigenvalues(11);
  return verdict;
}

double lowest_of_held_end(const Matrix12& matrix) {
  const Matrix6 end = matrix.bottomRightCorner<6, 6>();
  const Vector6 scale = end.diagonal().unaryExpr([](double k) { return k == 0 ? 1.0 : 1 / std::sqrt(std::abs(k)); });
  const Matrix6 scaled = scale.asDiagonal() * (0.5 * (end + end.transpose())) * scale.asDiagonal();
  return numerics::symmetric_eigenvalues(scaled)(0);
}

bool is_semidefinite(const MatrixVerdict& verdict) {
  const double explained = rounding_of_data + 2 * std::min(verdict.rigid_residual, refused_residual);
  return verdict.lowest_eigenvalue >= -explained * std::max(1.0, std::abs(verdict.highest_eigenvalue));
}

}  // namespace trivet::elements
