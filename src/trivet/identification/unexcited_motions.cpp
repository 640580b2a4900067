// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/unexcited_motions.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/identification/load_cases.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"

namespace trivet::identification {
namespace {

/// Ratio of the motion in a direction to the largest motion from which it counts as moved.
constexpr double moved_from = 1e-7;
/// Share of a coordinate in a combination from which it is named.
constexpr double worth_a_word = 1e-4;

int coordinate(Eigen::Index i, Eigen::Index rows) { return static_cast<int>(rows == 6 ? i + 6 : i); }

/// Gauss–Jordan with pivots from the largest entry: each direction gets its own coordinates if possible.
Eigen::MatrixXd separated(Eigen::MatrixXd directions) {
  for (Eigen::Index j = 0; j < directions.cols(); ++j) {
    Eigen::Index row = 0, column = 0;
    directions.rightCols(directions.cols() - j).cwiseAbs().maxCoeff(&row, &column);
    directions.col(j).swap(directions.col(j + column));
    directions.col(j) /= directions(row, j);
    for (Eigen::Index other = 0; other < directions.cols(); ++other)
      if (other != j) directions.col(other) -= directions(row, other) * directions.col(j).eval();
  }
  return directions;
}

std::string unmoved_coordinate_text(int i) {
  const char end = i < 6 ? 'N' : 'K', axis = "xyz"[i % 3];
  if (i % 6 < 3) return fmt::format("no load case moves {} along {}", end, axis);
  return fmt::format("no load case {} {} about {}", axis == 'z' ? "twists" : "tilts", end, axis);
}

/// "every load case has u_K x − 0.2 θ_K y = 0"
std::string fixed_combination_text(const Eigen::VectorXd& weights) {
  Eigen::Index lead = 0;
  weights.cwiseAbs().maxCoeff(&lead);
  std::string text;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double w = weights(i) / weights(lead);
    if (std::abs(w) < worth_a_word) continue;
    const std::string sign = text.empty() ? (w < 0 ? "−" : "") : (w < 0 ? " − " : " + ");
    const std::string factor = std::abs(std::abs(w) - 1) < 1e-6 ? "" : fmt::format("{:.3g} ", std::abs(w));
    text += sign + factor + coordinate_words(coordinate(i, weights.size()));
  }
  return "every load case has " + text + " = 0 (SI units)";
}

}  // namespace

std::vector<std::string> unexcited_motions(const Eigen::MatrixXd& motions) {
  const Eigen::Index rows = motions.rows();
  double translation = 0, rotation = 0;
  for (Eigen::Index i = 0; i < rows; ++i)
    (i % 6 < 3 ? translation : rotation) = std::max(i % 6 < 3 ? translation : rotation, motions.row(i).norm());
  Eigen::VectorXd size(rows);
  for (Eigen::Index i = 0; i < rows; ++i) size(i) = i % 6 < 3 ? translation : rotation;
  size = (size.array() > 0).select(size, 1);

  const Eigen::MatrixXd scaled = size.cwiseInverse().asDiagonal() * motions;
  const Eigen::MatrixXd moments = scaled * scaled.transpose();
  const numerics::SymmetricEigen<Eigen::MatrixXd> eigen = numerics::symmetric_eigen(moments);
  Eigen::Index missing = 0;
  while (missing < rows && eigen.values(missing) < moved_from * moved_from * eigen.values(rows - 1)) ++missing;

  std::vector<std::string> words;
  const Eigen::MatrixXd directions = separated(eigen.vectors.leftCols(missing));
  for (Eigen::Index j = 0; j < missing; ++j) {
    Eigen::Index lead = 0;
    const Eigen::VectorXd direction = directions.col(j);
    direction.cwiseAbs().maxCoeff(&lead);
    const bool single = (direction.cwiseAbs().array() > worth_a_word).count() == 1;
    words.push_back(single ? unmoved_coordinate_text(coordinate(lead, rows))
                           : fixed_combination_text(direction.cwiseQuotient(size)));
  }
  return words;
}

}  // namespace trivet::identification
