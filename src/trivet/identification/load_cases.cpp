// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/load_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::identification {

LoadCase moved_end_case(std::string name, const Vector6& displacement, const Vector6& wrench) {
  LoadCase load_case;
  load_case.name = std::move(name);
  load_case.displacement << Vector6::Zero(), displacement;
  load_case.wrench.tail<6>() = wrench;
  return load_case;
}

std::string channel_words(int channel) {
  return fmt::format("{} {} at {}", channel % 6 < 3 ? "force" : "moment", "xyz"[channel % 3], channel < 6 ? 'N' : 'K');
}

std::string coordinate_words(int coordinate) {
  return fmt::format("{}_{} {}", coordinate % 6 < 3 ? "u" : "θ", coordinate < 6 ? 'N' : 'K', "xyz"[coordinate % 3]);
}

foundation::Problems load_case_problems(const std::vector<LoadCase>& cases) {
  foundation::Problems problems;
  if (cases.empty())
    problems.error("load_cases", "no load case", "a matrix needs readings", "give at least six independent load cases");
  std::set<std::string> names;
  bool moved = cases.empty();
  for (const LoadCase& one : cases) {
    const std::string subject = fmt::format("load case '{}'", one.name);
    for (int i = 0; i < 12; ++i) {
      if (!std::isfinite(one.displacement(i)))
        problems.error(subject, fmt::format("displacement {} = {}", coordinate_words(i), one.displacement(i)),
                       "every imposed displacement must be a number", "give 0 for a coordinate that was fixed");
      if (std::isinf(one.wrench(i)))
        problems.error(subject, fmt::format("{} = {}", channel_words(i), one.wrench(i)), "a reading must be a number",
                       "omit a channel that was not measured");
    }
    if (one.wrench.array().isNaN().all())
      problems.error(subject, "no channel was measured", "a load case must have at least one reading",
                     "remove the case, or give its wrench");
    moved = moved || one.displacement.cwiseAbs().maxCoeff() > 0;
    if (!names.insert(one.name).second)
      problems.warning(subject, "the name is used twice", "outliers are reported by name",
                       "give every load case a different name");
  }
  if (!moved)
    problems.error("load_cases", "every displacement is 0", "a stiffness can be measured only if the element is moved",
                   "check the columns");
  return problems;
}

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
