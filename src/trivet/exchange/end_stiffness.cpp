// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/end_stiffness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::exchange {

std::vector<int> fixed_components(const Eigen::MatrixXd& matrix) {
  constexpr double beyond_arms = 1e12, beyond_stiffness = 1e30;
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    double largest = 0;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      if (j != i) largest = std::max(largest, std::abs(matrix(i, j)));
    const double diagonal = std::abs(matrix(i, i));
    if (diagonal >= beyond_stiffness || (largest > 0 && diagonal > beyond_arms * largest))
      rows.push_back(static_cast<int>(i));
  }
  return rows;
}

Eigen::Matrix<double, 12, 12> completed_by_rigid_motion(const Eigen::Matrix<double, 12, 12>& matrix,
                                                        const std::vector<int>& rows,
                                                        const Eigen::Matrix<double, 12, 6>& motions) {
  Eigen::Matrix<double, 12, 12> result = matrix;
  for (const int i : rows) result(i, i) = 0;
  for (const int first : {0, 6}) {
    const Eigen::Matrix<double, 6, 6> own = motions.middleRows<6>(first);
    const Eigen::Matrix<double, 12, 6> unit = motions *
        numerics::PivotedLu<double>(own).solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(own.rows(), own.rows())));
    for (const int i : rows)
      if (i >= first && i < first + 6) result(i, i) = -result.row(i).dot(unit.col(i - first));
  }
  return result;
}

namespace {

/// Limits of the reciprocal condition of the scaled interior: below the first it is singular to round-off, below the
/// second the result loses digits.
constexpr double singular_below = 64 * std::numeric_limits<double>::epsilon();
constexpr double doubtful_below = 1e-10;

struct Partition {
  std::vector<int> retained, condensed;
  Eigen::Matrix<double, Eigen::Dynamic, 12> motion;  ///< of the retained rows per unit motion of the ends
};

std::string row_name(const NamedMatrix& matrix, int row) {
  if (matrix.labels.empty()) return fmt::format("row {}", row + 1);
  const Label& label = matrix.labels[row];
  return fmt::format("node {}, component {}", label.node, label.component);
}

/// All rows that are not retained, except rows without entries, which do not affect the result.
std::vector<int> condensed_rows(const NamedMatrix& matrix, const std::vector<int>& retained,
                                foundation::Problems& problems) {
  std::vector<bool> kept(to_size(matrix.values.rows()), false);
  for (const int row : retained) kept[row] = true;
  std::vector<int> rows;
  int empty = 0, first_empty = 0;
  for (int i = 0; i < matrix.values.rows(); ++i) {
    if (kept[i]) continue;
    const bool complex_zero =
        matrix.imaginary.size() == 0 || (matrix.imaginary.row(i).isZero(0) && matrix.imaginary.col(i).isZero(0));
    if (matrix.values.row(i).isZero(0) && matrix.values.col(i).isZero(0) && complex_zero) {
      if (empty++ == 0) first_empty = i;
    } else {
      rows.push_back(i);
    }
  }
  if (empty > 0)
    problems.warning("condensation",
                     fmt::format("{} rows hold only zeros, the first one is {}", empty, row_name(matrix, first_empty)),
                     "they are not connected to the other rows", "they are ignored");
  return rows;
}

/// Error if a condensed row is fixed by a boundary condition: the element would be fixed to the ground there.
void check_loose(const NamedMatrix& matrix, const std::vector<int>& condensed, foundation::Problems& problems) {
  for (const int row : fixed_components(matrix.values))
    if (std::ranges::find(condensed, row) != condensed.end()) {
      problems.error(
          "condensation", fmt::format("{:.3g} on the diagonal of {}", matrix.values(row, row), row_name(matrix, row)),
          "such a number stands for a component that a boundary condition fixes, as Abaqus writes it (1e36); "
          "an element is attached to its two ends only",
          "write the matrix without boundary conditions, or name this node as an end");
      return;
    }
}

/// K_bb − K_bi K_ii⁻¹ K_ib, or nullopt with an error.
template <typename Dense>
std::optional<Dense> condensed(const Dense& full, const NamedMatrix& matrix, const Partition& parts,
                               foundation::Problems& problems) {
  Dense boundary = full(parts.retained, parts.retained);
  if (parts.condensed.empty()) return boundary;
  Dense interior = full(parts.condensed, parts.condensed);
  const Eigen::VectorXd scale = interior.rowwise().template lpNorm<Eigen::Infinity>().unaryExpr(
      [](double v) { return v > 0 ? 1 / std::sqrt(v) : 1.0; });
  interior = (scale.asDiagonal() * interior * scale.asDiagonal()).eval();
  const numerics::PivotedLu<typename Dense::Scalar> factors(interior);
  Eigen::Index smallest_pivot = 0;
  const double pivot = factors.pivots().cwiseAbs().minCoeff(&smallest_pivot);
  const double condition = pivot > singular_below ? factors.reciprocal_condition() : 0;
  const std::string weakest = row_name(matrix, parts.condensed[smallest_pivot]);
  if (!(condition > singular_below)) {
    problems.error("condensation", fmt::format("{} can move without force", weakest),
                   "the condensed part must be supported by the ends",
                   "support or remove loose parts of the model, or name the ends that support them");
    return std::nullopt;
  }
  if (condition < doubtful_below)
    problems.warning("condensation",
                     fmt::format("reciprocal condition {:.2g}, the weakest part is near {}", condition, weakest),
                     "the result loses about one digit per power of ten", "look for a weakly supported part");
  const Dense right = scale.asDiagonal() * full(parts.condensed, parts.retained);
  const Dense solved = factors.solve(right);
  const Dense left = full(parts.retained, parts.condensed) * scale.asDiagonal();
  return Dense(boundary - left * solved);
}

foundation::Expected<EndMatrix> reduced(const NamedMatrix& matrix, Partition parts) {
  EndMatrix result;
  parts.condensed = condensed_rows(matrix, parts.retained, result.warnings);
  check_loose(matrix, parts.condensed, result.warnings);
  if (result.warnings.has_errors()) return tl::make_unexpected(result.warnings);
  if (matrix.imaginary.size() == 0) {
    const auto boundary = condensed<Eigen::MatrixXd>(matrix.values, matrix, parts, result.warnings);
    if (!boundary) return tl::make_unexpected(result.warnings);
    result.values = parts.motion.transpose() * *boundary * parts.motion;
  } else {
    const Eigen::MatrixXcd full = matrix.values + std::complex<double>(0, 1) * matrix.imaginary;
    const auto boundary = condensed<Eigen::MatrixXcd>(full, matrix, parts, result.warnings);
    if (!boundary) return tl::make_unexpected(result.warnings);
    result.values = parts.motion.transpose() * boundary->real() * parts.motion;
    result.imaginary = parts.motion.transpose() * boundary->imag() * parts.motion;
  }
  if (result.values.allFinite() && (!result.imaginary || result.imaginary->allFinite())) return result;
  result.warnings.error("condensation", "the result is not finite", "its entries must be numbers",
                        "the entries of the file are too large");
  return tl::make_unexpected(result.warnings);
}

using Rows = std::map<Label, int>;

Rows rows_by_label(const NamedMatrix& matrix) {
  Rows rows;
  for (std::size_t i = 0; i < matrix.labels.size(); ++i) rows.emplace(matrix.labels[i], static_cast<int>(i));
  return rows;
}

bool has_labels(const NamedMatrix& matrix, foundation::Problems& problems) {
  if (!matrix.labels.empty()) return true;
  problems.error("ends", "the file has no node numbers", "ends are nodes of the file", "name twelve rows instead");
  return false;
}

std::string components_of(const Rows& rows, int node) {
  std::string text;
  for (auto at = rows.lower_bound({node, 0}); at != rows.end() && at->first.node == node; ++at)
    text += (text.empty() ? "components " : ", ") + std::to_string(at->first.component);
  return text.empty() ? "no such node" : text;
}

void add_end(const Rows& rows, const NodeEnd& end, const std::string& subject, std::vector<int>& retained,
             foundation::Problems& problems) {
  for (int i = 0; i < 6; ++i) {
    const bool own = end.rotation_node == 0 || i < 3;
    const Label wanted{own ? end.node : end.rotation_node, own ? i + 1 : i - 2};
    const auto found = rows.find(wanted);
    if (found != rows.end()) {
      retained.push_back(found->second);
      continue;
    }
    problems.error(subject, fmt::format("node {}: {}", wanted.node, components_of(rows, wanted.node)),
                   fmt::format("its component {} is needed", wanted.component),
                   "retain all six components of the end, or name all nodes of its plate with their coordinates");
    return;
  }
}

/// Adds the rows of the nodes of a plate, and their motion u = u_P + θ × r as 6 columns.
void add_plate(const Rows& rows, const RigidEnd& end, const std::string& subject, int first_column, Partition& parts,
               foundation::Problems& problems) {
  if (end.nodes.empty()) problems.error(subject, "no nodes", "a plate has at least one", "name its nodes");
  for (const RigidEnd::At& at : end.nodes) {
    const Eigen::Vector3d r = at.position - end.point;
    Eigen::Matrix<double, 6, 6> motion = Eigen::Matrix<double, 6, 6>::Identity();
    motion.topRightCorner<3, 3>() << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
    bool found = false;
    for (int i = 0; i < 6; ++i) {
      const auto row = rows.find({at.node, i + 1});
      if (row == rows.end()) continue;
      found = true;
      parts.retained.push_back(row->second);
      const auto index = to_index(parts.retained.size()) - 1;
      parts.motion.conservativeResize(index + 1, Eigen::NoChange);
      parts.motion.row(index).setZero();
      parts.motion.row(index).segment<6>(first_column) = motion.row(i);
    }
    if (!found)
      problems.error(subject, fmt::format("node {}: no such node", at.node),
                     "the nodes of a plate are nodes of the file", "correct its number");
    if (!at.position.allFinite())
      problems.error(subject, fmt::format("position of node {}", at.node), "it must be finite",
                     "correct the coordinates");
  }
}

/// Error if a row is retained twice.
void check_distinct(const NamedMatrix& matrix, std::vector<int> rows, foundation::Problems& problems) {
  std::ranges::sort(rows);
  const auto twice = std::ranges::adjacent_find(rows);
  if (twice != rows.end())
    problems.error("ends", row_name(matrix, *twice) + " is named twice", "a component belongs to one end",
                   "name it once");
}

}  // namespace

foundation::Expected<EndMatrix> reduce_to_ends(const NamedMatrix& matrix, const NodeEnd& n, const NodeEnd& k) {
  foundation::Problems problems;
  Partition parts{{}, {}, Eigen::Matrix<double, 12, 12>::Identity()};
  if (!has_labels(matrix, problems)) return tl::make_unexpected(problems);
  const Rows rows = rows_by_label(matrix);
  add_end(rows, n, "end N", parts.retained, problems);
  add_end(rows, k, "end K", parts.retained, problems);
  check_distinct(matrix, parts.retained, problems);
  if (problems.has_errors()) return tl::make_unexpected(problems);
  return reduced(matrix, std::move(parts));
}

foundation::Expected<EndMatrix> reduce_to_ends(const NamedMatrix& matrix, const RigidEnd& n, const RigidEnd& k) {
  foundation::Problems problems;
  Partition parts;
  parts.motion.resize(0, 12);
  if (!has_labels(matrix, problems)) return tl::make_unexpected(problems);
  const Rows rows = rows_by_label(matrix);
  add_plate(rows, n, "end N", 0, parts, problems);
  add_plate(rows, k, "end K", 6, parts, problems);
  check_distinct(matrix, parts.retained, problems);
  if (problems.has_errors()) return tl::make_unexpected(problems);
  return reduced(matrix, std::move(parts));
}

foundation::Expected<EndMatrix> reduce_to_rows(const NamedMatrix& matrix, const std::array<int, 12>& wanted) {
  foundation::Problems problems;
  Partition parts{{}, {}, Eigen::Matrix<double, 12, 12>::Identity()};
  for (const int row : wanted) {
    parts.retained.push_back(row - 1);
    if (row < 1 || row > matrix.values.rows())
      problems.error("rows", fmt::format("row {}", row), fmt::format("rows count from 1 to {}", matrix.values.rows()),
                     "name twelve rows: (u_N, θ_N, u_K, θ_K)");
  }
  if (problems.has_errors()) return tl::make_unexpected(problems);
  check_distinct(matrix, parts.retained, problems);
  if (problems.has_errors()) return tl::make_unexpected(problems);
  return reduced(matrix, std::move(parts));
}

Matrix12 in_si(const Matrix12& matrix, double length_unit, double force_unit) {
  if (!(length_unit > 0) || !std::isfinite(length_unit) || !(force_unit > 0) || !std::isfinite(force_unit))
    throw foundation::InvalidInput(
        fmt::format("length unit {:.6g} m, force unit {:.6g} N: both must be > 0 and finite", length_unit, force_unit));
  Eigen::Matrix<double, 12, 1> lever = Eigen::Matrix<double, 12, 1>::Ones();
  lever.segment<3>(3).setConstant(length_unit);
  lever.segment<3>(9).setConstant(length_unit);
  return force_unit / length_unit * (lever.asDiagonal() * matrix * lever.asDiagonal());
}

}  // namespace trivet::exchange
