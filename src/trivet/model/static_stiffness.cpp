// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/static_stiffness.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/model/point_mass.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/reduced_echelon.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::model {

namespace {

/// Projector on the deformations of an element: its part against rigid motions is that of forces at rest, which do not
/// stiffen.
elements::Matrix12 deformation_projector(const Span& between) {
  const Eigen::Matrix<double, 12, 6> rigid = elements::rigid_motions(between.arm, between.n_from_k);
  const elements::Matrix6 metric = rigid.transpose() * rigid;
  return elements::Matrix12::Identity() - rigid * numerics::inverse(metric) * rigid.transpose();
}

}  // namespace

bool has_static_stiffness(const System& system) {
  const std::vector<Element>& elements = system.elements();
  return std::ranges::any_of(elements, [](const Element& one) { return one.stiffening != 1; }) &&
      std::ranges::none_of(elements, has_laws);
}

System with_static_stiffness(const System& system) {
  Description description = system.description();
  for (Element& element : description.elements) {
    if (element.stiffening == 1) continue;
    const elements::Matrix12 deformation = deformation_projector(span(description.bodies, element.n, element.k));
    element.law.nominal_stiffness -=
        (1 - 1 / element.stiffening) * deformation.transpose() * element.law.nominal_stiffness * deformation;
    element.stiffening = 1;
  }
  return system.in_other_state(std::move(description));
}

namespace {

using spatial::Matrix6;

/// Round-off of turned axes and lever arms, as a share of the largest stiffness of the element times its levers.
constexpr double round_off = 1e-13;
/// Lowest eigenvalue of a stiffness with unit diagonal below which a motion counts as unheld: two bars at an angle of
/// 1e-6 rad.
constexpr double unheld = 1e-12;
/// Components of a motion below this share are not named.
constexpr double too_small_to_name = 1e-4;

Matrix6 motion_of_end(const End& end) {
  return spatial::both_blocks(end.axes).transpose() * spatial::rigid_motion(end.at);
}

/// Largest translational and rotational entries on the diagonal of an element matrix.
struct Size {
  double linear = 0, angular = 0;

  explicit Size(const Eigen::MatrixXd& matrix) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      (i < 12 && i % 6 >= 3 ? angular : linear) =
          std::max(i < 12 && i % 6 >= 3 ? angular : linear, std::abs(matrix(i, i)));
  }
  /// Forces that are round-off of it, for a row and a column that are rotational or not.
  [[nodiscard]] double negligible(bool row, bool column, double lever) const {
    return round_off * (linear * (row ? lever : 1) * (column ? lever : 1) + (row && column ? angular : 0));
  }
};

double longest_lever(const Description& description, const Element& element) {
  return std::max(
      {element.n.at.norm(), element.k.at.norm(), span(description.bodies, element.n, element.k).arm.norm()});
}

/// True if column j of M T, or row j of Tᵀ M, is not only round-off.
bool acts(const Eigen::MatrixXd& matrix, Eigen::Index first, const spatial::Vector6& motion, bool rotation,
          double lever) {
  const Size size(matrix);
  const Eigen::VectorXd force = matrix.middleCols(first, 6) * motion,
                        back = matrix.middleRows(first, 6).transpose() * motion;
  for (Eigen::Index i = 0; i < force.size(); ++i)
    if (std::max(std::abs(force(i)), std::abs(back(i))) > size.negligible(i < 12 && i % 6 >= 3, rotation, lever))
      return true;
  return false;
}

/// Calls `visit(element, first row of the end, end)` for all ends on a node.
template <typename Visitor>
void for_each_end(const Description& description, std::size_t node, const Visitor& visit) {
  for (const Element& element : description.elements) {
    if (element.n.body == node) visit(element, 0, element.n);
    if (element.k.body == node) visit(element, 6, element.k);
  }
}

/// One free coordinate without mass, of a node or a point mass.
struct Coordinate {
  std::size_t node;
  int direction;
};

std::vector<Coordinate> massless_coordinates(const Description& description) {
  std::vector<Coordinate> list;
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const Body& body = description.bodies[b];
    if (!body.is_node && !is_point_mass(body)) continue;
    Eigen::Matrix<bool, 6, 1> massive;
    for (int j = 0; j < 6; ++j) massive(j) = !is_massless(body, to_size(j));
    for_each_end(description, b, [&](const Element& element, Eigen::Index first, const End& end) {
      const Eigen::MatrixXd mass = elements::matrices(element.law).mass;
      const Matrix6 motion = motion_of_end(end);
      for (int j = 0; j < 6; ++j)
        massive(j) = massive(j) || acts(mass, first, motion.col(j), j >= 3, longest_lever(description, element));
    });
    for (int j = 0; j < 6; ++j)
      if (body.free[j] && !massive(j)) list.push_back({b, j});
  }
  return list;
}

/// Static stiffness of these coordinates, all others held, and the sizes of its diagonal below which it is round-off.
struct HeldStiffness {
  Eigen::MatrixXd K;
  Eigen::VectorXd negligible;
};

HeldStiffness held_stiffness(const Description& description, const std::vector<Coordinate>& list) {
  const auto n = to_index(list.size());
  HeldStiffness result{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  for (const Element& element : description.elements) {
    std::vector<Eigen::Index> rows;
    Eigen::MatrixXd ends(12, 0);
    for (Eigen::Index i = 0; i < n; ++i)
      for (const auto& [end, first] : {std::pair{&element.n, 0}, {&element.k, 6}})
        if (end->body == list[i].node) {
          rows.push_back(i);
          ends.conservativeResize(12, ends.cols() + 1);
          ends.rightCols<1>().setZero();
          ends.rightCols<1>().segment<6>(first) = motion_of_end(*end).col(list[i].direction);
        }
    if (rows.empty()) continue;
    const elements::Matrix12 stiffness = elements::stiffness(element.law);
    const Eigen::MatrixXd own = ends.transpose() * stiffness * ends;
    const double lever = longest_lever(description, element);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool rotation = list[rows[i]].direction >= 3;
      result.negligible(rows[i]) += Size(stiffness).negligible(rotation, rotation, lever);
      for (std::size_t j = 0; j < rows.size(); ++j)
        result.K(rows[i], rows[j]) += 0.5 * (own(to_index(i), to_index(j)) + own(to_index(j), to_index(i)));
    }
  }
  return result;
}

/// The motion of the coordinates `scaled` (of a unit diagonal) with the names of its nodes.
UnheldMotion described(const Description& description, const std::vector<Coordinate>& list,
                       const Eigen::VectorXd& diagonal, const Eigen::VectorXd& scaled) {
  Eigen::Index largest = 0;
  scaled.cwiseAbs().maxCoeff(&largest);
  UnheldMotion motion;
  motion.node = list[largest].node;
  for (Eigen::Index i = 0; i < scaled.size(); ++i) {
    if (std::abs(scaled(i)) < too_small_to_name * std::abs(scaled(largest))) continue;
    const Coordinate& one = list[i];
    const std::string name = "\"" + description.bodies[one.node].name + "\"";
    if (one.node == motion.node) motion.directions(one.direction) = scaled(i) / std::sqrt(diagonal(i));
    else if (motion.with.find(name) == std::string::npos) motion.with += (motion.with.empty() ? "" : ", ") + name;
  }
  return motion;
}

/// Unheld motions of these coordinates alone.
std::vector<UnheldMotion> unheld_among(const Description& description, const std::vector<Coordinate>& list) {
  const HeldStiffness held = held_stiffness(description, list);
  const Eigen::VectorXd diagonal = held.K.diagonal().cwiseAbs();
  std::vector<UnheldMotion> found;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (diagonal(to_index(i)) > held.negligible(to_index(i))) continue;
    found.push_back({list[i].node, spatial::Vector6::Unit(list[i].direction), true, ""});
  }
  if (!found.empty()) return found;
  const Eigen::VectorXd d = diagonal.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = d.asDiagonal() * held.K * d.asDiagonal();
  if (numerics::PivotedLu<double>(scaled).reciprocal_condition() > unheld) return found;
  const numerics::SymmetricEigen<Eigen::MatrixXd> eigen = numerics::symmetric_eigen(scaled);
  Eigen::MatrixXd free(0, scaled.cols());
  for (Eigen::Index i = 0; i < eigen.values.size(); ++i) {
    if (std::abs(eigen.values(i)) > unheld * static_cast<double>(list.size())) continue;
    free.conservativeResize(free.rows() + 1, Eigen::NoChange);
    free.bottomRows<1>() = eigen.vectors.col(i).transpose();
  }
  const Eigen::MatrixXd motions = numerics::reduced_echelon(free);
  for (Eigen::Index i = 0; i < motions.rows(); ++i)
    found.push_back(described(description, list, diagonal, motions.row(i).transpose()));
  return found;
}

}  // namespace

std::array<bool, 6> held_directions(const Description& description, std::size_t node) {
  std::array<bool, 6> held = {};
  for_each_end(description, node, [&](const Element& element, Eigen::Index first, const End& end) {
    const elements::Matrices m = elements::matrices(element.law);
    const Matrix6 motion = motion_of_end(end);
    const double lever = longest_lever(description, element);
    for (int j = 0; j < 6; ++j)
      for (const Eigen::MatrixXd* matrix : {&m.stiffness, &m.damping, &m.mass})
        held[j] = held[j] || acts(*matrix, first, motion.col(j), j >= 3, lever);
  });
  return held;
}

std::size_t coordinates_with_mass(const Description& description, std::size_t node) {
  const Body& body = description.bodies[node];
  const std::vector<Coordinate> massless = massless_coordinates(description);
  const auto of_node = std::ranges::count(massless, node, &Coordinate::node);
  return to_size(std::ranges::count(body.free, true) - of_node);
}

std::vector<UnheldMotion> unheld_motions(const Description& description) {
  const std::vector<Coordinate> all = massless_coordinates(description);
  std::vector<UnheldMotion> found;
  std::size_t nodes = 0;
  for (auto first = all.begin(); first != all.end(); ++nodes) {
    const auto last = std::find_if(first, all.end(), [&](const Coordinate& one) { return one.node != first->node; });
    const std::vector<UnheldMotion> own = unheld_among(description, {first, last});
    found.insert(found.end(), own.begin(), own.end());
    first = last;
  }
  if (!found.empty() || nodes < 2) return found;
  found = unheld_among(description, all);
  if (found.size() > 1) {
    found.front().further = found.size() - 1;
    found.resize(1);
  }
  return found;
}

}  // namespace trivet::model
