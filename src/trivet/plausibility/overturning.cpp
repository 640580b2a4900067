// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/plausibility/overturning.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::plausibility {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Share of the stiffest direction below which one is unrestrained.
constexpr double unheld = 1e-9;
/// Coordinates up to which machines are examined for notes.
constexpr Eigen::Index most_for_notes = 300;

MatrixXd symmetric_part(const MatrixXd& m) { return 0.5 * (m + m.transpose()); }

/// K of both orders in coordinates scaled by the masses.
class Stiffness {
 public:
  explicit Stiffness(const assembly::Assembled& assembled)
      : scale_(numerics::unit_scale(assembled.matrices)),
        first_(scaled(assembled.first_order().matrices.K)),
        whole_(scaled(assembled.matrices.K)),
        round_off_(round_off()) {}

  [[nodiscard]] const VectorXd& scale() const { return scale_; }
  [[nodiscard]] const MatrixXd& first() const { return first_; }
  [[nodiscard]] const MatrixXd& whole() const { return whole_; }

  /// Has it no negative eigenvalue beyond round-off?
  [[nodiscard]] bool holds(const MatrixXd& stiffness) const {
    return stiffness.rows() == 0 || numerics::symmetric_eigenvalues(stiffness)(0) >= -round_off_;
  }

 private:
  [[nodiscard]] MatrixXd scaled(const MatrixXd& stiffness) const {
    return scale_.asDiagonal() * symmetric_part(stiffness) * scale_.asDiagonal();
  }
  [[nodiscard]] double round_off() const {
    constexpr double of_a_sum = 64 * std::numeric_limits<double>::epsilon();
    return std::max(of_a_sum * static_cast<double>(whole_.rows()) * first_.cwiseAbs().maxCoeff(),
                    unheld * (whole_ - first_).cwiseAbs().maxCoeff());
  }

  VectorXd scale_;
  MatrixXd first_, whole_;
  double round_off_;
};

/// Motions of a body in which it tilts, as columns on scaled coordinates, and an orthonormal basis of all others. A
/// body whose rotations are guided tilts about its free axes.
struct Parted {
  MatrixXd tilts, others;
  Eigen::Matrix<double, 3, Eigen::Dynamic> axes;  ///< of the tilts, body frame
};

std::optional<Parted> parted(const model::System& system, const assembly::Assembled& assembled, std::size_t b,
                             const VectorXd& scale) {
  const model::Body& body = system.bodies()[b];
  if (body.is_node || !(body.mass.mass > 0)) return std::nullopt;
  const Eigen::Vector3d down = body.pose.rotation.transpose() * *system.description().gravity;
  std::vector<Eigen::Index> rows;
  Eigen::Matrix<double, 3, Eigen::Dynamic> axes(3, 0);
  for (int j = 0; j < 3; ++j)
    if (const Eigen::Index row = assembled.layout.row(b, 3 + j); row >= 0) {
      rows.push_back(row);
      axes.conservativeResize(3, axes.cols() + 1);
      axes.rightCols<1>() = Eigen::Vector3d::Unit(j);
    }
  if (rows.empty()) return std::nullopt;
  const Eigen::Index n = scale.size(), count = to_index(rows.size());
  MatrixXd about(count, count == 3 ? 2 : count);  // free rotations × tilts
  if (count == 3) {
    about.col(0) = down.unitOrthogonal();
    about.col(1) = down.normalized().cross(Eigen::Vector3d(about.col(0)));
  } else {
    about.setIdentity();
  }
  Parted result{MatrixXd::Zero(n, about.cols()), MatrixXd::Zero(n, n - about.cols()), axes * about};
  for (Eigen::Index i = 0; i < count; ++i) result.tilts.row(rows[i]) = about.row(i) / scale(rows[i]);
  Eigen::Index next = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    if (std::ranges::find(rows, i) == rows.end()) result.others(i, next++) = 1;
  if (count == 3)
    for (Eigen::Index i = 0; i < count; ++i) result.others(rows[i], next) = down(i) / scale(rows[i]);
  if (count == 3) result.others.col(next).normalize();
  return result;
}

/// Stiffness against the tilts while all else follows in equilibrium [N m/rad].
MatrixXd condensed(const MatrixXd& stiffness, const Parted& parts) {
  MatrixXd own = parts.tilts.transpose() * stiffness * parts.tilts;
  const MatrixXd coupling = parts.others.transpose() * stiffness * parts.tilts,
                 rest = parts.others.transpose() * stiffness * parts.others;
  if (rest.rows() == 0) return own;
  return symmetric_part(own - coupling.transpose() * numerics::smallest_solution(rest, coupling));
}

/// @param axis  of unit length, in components along the axes of the tilts
Tilting tilting(const model::System& system, std::size_t b, const Parted& parts, const MatrixXd& first,
                const MatrixXd& whole, const VectorXd& axis) {
  const model::Body& body = system.bodies()[b];
  const Eigen::Vector3d down = body.pose.rotation.transpose() * *system.description().gravity;
  Tilting result{b};
  result.restoring = std::max(0.0, axis.dot(first * axis));
  result.overturning = axis.dot((first - whole) * axis);
  result.height = -down.normalized().dot(body.mass.centre);
  const double level = Eigen::Vector3d(parts.axes * axis).cross(down.normalized()).squaredNorm();
  result.standing = result.height + axis.dot(whole * axis) / (body.mass.mass * down.norm() * level);
  return result;
}

}  // namespace

std::optional<Tilting> falling_body(const model::System& system, const assembly::Assembled& assembled) {
  if (!assembled.without_second_order || numerics::is_positive_definite(symmetric_part(assembled.matrices.K)))
    return std::nullopt;
  const Stiffness stiffness(assembled);
  if (stiffness.holds(stiffness.whole()) || !stiffness.holds(stiffness.first())) return std::nullopt;
  std::optional<Tilting> worst;
  double released = 0;
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const std::optional<Parted> parts = parted(system, assembled, b, stiffness.scale());
    // Only a machine that stands while this body does not tilt falls over with it.
    if (!parts || !stiffness.holds(parts->others.transpose() * stiffness.whole() * parts->others)) continue;
    const MatrixXd first = condensed(stiffness.first(), *parts), whole = condensed(stiffness.whole(), *parts);
    const Tilting found = tilting(system, b, *parts, first, whole, numerics::symmetric_eigen(whole).vectors.col(0));
    const double energy = found.overturning - found.restoring;
    if (!worst || energy > released) {
      worst = found;
      released = energy;
    }
  }
  if (worst) return worst;
  // Several bodies fall: that with the largest mass times height.
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const std::optional<Parted> parts = parted(system, assembled, b, stiffness.scale());
    if (!parts) continue;
    const MatrixXd first = parts->tilts.transpose() * stiffness.first() * parts->tilts,
                   whole = parts->tilts.transpose() * stiffness.whole() * parts->tilts;
    const Tilting found = tilting(system, b, *parts, first, whole, numerics::symmetric_eigen(whole).vectors.col(0));
    if (const double size = system.bodies()[b].mass.mass * found.height; size > highest) {
      worst = found;
      highest = size;
    }
  }
  return worst;
}

std::string falling_words(const model::System& system, const Tilting& tilting) {
  return fmt::format(
      "it falls over: when it tilts, the weight causes an overturning moment of {}, the elements a restoring moment of "
      "{}; with its centre of mass below {} over its pole (now {}) {} would stand",
      foundation::prefixed_exactly(tilting.overturning, "N m/rad", 5),
      foundation::prefixed_exactly(tilting.restoring, "N m/rad", 5), foundation::prefixed(tilting.standing, "m"),
      foundation::prefixed(tilting.height, "m"), system.bodies()[tilting.body].name);
}

std::vector<std::string> overturning_notes(const model::System& system, const assembly::Assembled& assembled,
                                           double from_share) {
  std::vector<std::string> notes;
  if (!assembled.without_second_order || assembled.matrices.size() > most_for_notes) return notes;
  const Stiffness stiffness(assembled);
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const std::optional<Parted> parts = parted(system, assembled, b, stiffness.scale());
    if (!parts) continue;
    const MatrixXd first = condensed(stiffness.first(), *parts), whole = condensed(stiffness.whole(), *parts);
    const VectorXd alone = numerics::symmetric_eigenvalues(first);
    if (!(alone(0) > unheld * alone.tail<1>()(0))) continue;
    const numerics::SymmetricEigen<MatrixXd> both = numerics::symmetric_eigen(MatrixXd(first - whole), first);
    const double share = both.values.tail<1>()(0);
    if (!(share > from_share)) continue;
    const Tilting found = tilting(system, b, *parts, first, whole, both.vectors.rightCols<1>().col(0).normalized());
    notes.push_back(
        fmt::format("body {}: when it tilts, the weight causes an overturning moment of {}, its mounts a restoring "
                    "moment of {}: {:.0f} % of the stiffness is lost, and natural frequencies are those of the rest",
                    system.bodies()[b].name, foundation::prefixed(found.overturning, "N m/rad"),
                    foundation::prefixed(found.restoring, "N m/rad"), 100 * share));
  }
  return notes;
}

namespace {

/// Stiffness of its force at rest against a motion of end N across its axis, over that of its law; 0 without bending.
double sideways_by_tension(const assembly::ElementMap& element) {
  double largest = 0;
  for (int i = 0; i < 2; ++i) {
    const double added = element.of_forces_at_rest(i, i), law = element.matrices.stiffness(i, i) - added;
    if (law > 0) largest = std::max(largest, added / law);
  }
  return largest;
}

}  // namespace

std::vector<std::string> first_order_notes(const model::System& system, const assembly::Assembled& assembled) {
  std::vector<std::string> notes;
  const auto& gravity = system.description().gravity;
  if (!gravity || gravity->isZero(0)) return notes;
  if (!system.description().second_order)
    notes.emplace_back(
        "second_order = false: the weight acts to first order only; forces at rest that move with the bodies do not "
        "change the stiffness, except of elements with a preload");
  for (const std::size_t b : assembled.without_rest)
    notes.push_back(
        fmt::format("body {}: its elements do not balance its weight and constant forces to first order, so it has no "
                    "position of rest near that of the file: the weight does not change its stiffness, and a hung body "
                    "has no stiffness of a pendulum; take away loads across, or hang it on a `strut`",
                    system.bodies()[b].name));
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    if (const double ratio = sideways_by_tension(assembled.elements[e]);
        ratio > 1 && system.elements()[e].type == "beam")
      notes.push_back(
          fmt::format("element {}: its tension holds it sideways {:.3g} times as much as its bending; the effect of a "
                      "tension is of the first order and too stiff by some percent there; divide the element into "
                      "shorter ones joined at nodes",
                      system.elements()[e].name, ratio));
  return notes;
}

}  // namespace trivet::plausibility
