// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/elements/checks.h"
#include "trivet/model/checks.h"

namespace trivet::model {
namespace {

using elements::Matrix12;
using elements::MatrixVerdict;

/// "u_N x" … "θ_K z": name of one of the 12 coordinates of an element.
std::string end_coordinate(int i) {
  const char* letters[] = {"x", "y", "z"};
  return fmt::format("{}_{} {}", i % 6 < 3 ? "u" : "θ", i < 6 ? "N" : "K", letters[i % 3]);
}

std::string motion_words(int j) {
  const char* letters[] = {"x", "y", "z"};
  return fmt::format("{} {} of the whole element", j < 3 ? "translation along" : "rotation about K's", letters[j % 3]);
}

/// For the message that rejects a given matrix: the single unit error without which it would be valid; "" if there is
/// none.
std::string slip_behind(const Description& description, const Element& element, const Matrix12& matrix) {
  constexpr double degree = 180 / std::numbers::pi;
  struct Slip {
    const char* words;
    double n, k, translation,
        rotation;  ///< factors that undo it: on the positions of the ends, on the blocks of the matrix
  };
  static constexpr Slip slips[] = {
      {"suspicion \"stiffness per degree\": the matrix is valid if its rotational stiffnesses are in N m/deg; ", 1, 1,
       1, degree},
      {"suspicion \"stiffness\": the matrix is valid if its translational stiffnesses are in N/mm; ", 1, 1, 1e3, 1},
      {"suspicion \"stiffness\": the matrix is valid if its translational stiffnesses are in N/m, typed as N/mm; ", 1,
       1, 1e-3, 1},
      {"suspicion \"stiffness\": the matrix is valid if its rotational stiffnesses are in N mm/rad; ", 1, 1, 1, 1e-3},
      {"suspicion \"stiffness\": the matrix is valid if its rotational stiffnesses are in kN m/rad; ", 1, 1, 1, 1e3},
      {"suspicion \"places\": the matrix is valid if its ends are in millimetres; ", 1e-3, 1e-3, 1, 1},
      {"suspicion \"places\": the matrix is valid if its ends are in centimetres; ", 1e-2, 1e-2, 1, 1},
      {"suspicion \"places\": the matrix is valid if its end K is in millimetres; ", 1, 1e-3, 1, 1},
      {"suspicion \"places\": the matrix is valid if its end K is in centimetres; ", 1, 1e-2, 1, 1},
  };
  for (const Slip& slip : slips) {
    Matrix12 meant = matrix;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j)
        if ((i % 6 < 3) == (j % 6 < 3)) meant(i, j) *= i % 6 < 3 ? slip.translation : slip.rotation;
    End n = element.n, k = element.k;
    n.at *= slip.n;
    k.at *= slip.k;
    const Span ends = span(description.bodies, n, k);
    const MatrixVerdict verdict = elements::examine(meant, elements::rigid_motions(ends.arm, ends.n_from_k));
    constexpr double rounding_of_factor = 1e-4;  // 57.3 may be written with few digits
    if (verdict.rigid_residual < rounding_of_factor && verdict.lowest_eigenvalue > -rounding_of_factor)
      return slip.words;
  }
  return "";
}

struct Subject {
  std::string path;
  std::string quantity;    // "stiffness"
  std::string bad_energy;  // what a negative eigenvalue would mean
};

void check_symmetry(const Subject& subject, const Matrix12& matrix, const MatrixVerdict& verdict,
                    foundation::Problems& problems) {
  int i = verdict.asymmetric_row, j = verdict.asymmetric_column;
  // A 6×6 matrix of end K spreads its error over all blocks: report the entry that was written.
  double worst = 0;
  for (int row = 6; row < 12; ++row)
    for (int column = row + 1; column < 12; ++column)
      if (const double difference = std::abs(matrix(row, column) - matrix(column, row)); difference > worst &&
          difference > elements::rounding_of_data * std::sqrt(std::abs(matrix(row, row) * matrix(column, column))))
        worst = difference, i = row, j = column;
  const std::string finding =
      fmt::format("entry ({}, {}) = {:.9g} but ({}, {}) = {:.9g}", end_coordinate(i), end_coordinate(j), matrix(i, j),
                  end_coordinate(j), end_coordinate(i), matrix(j, i));
  problems.error(subject.path, finding, fmt::format("the {} matrix of an element must be symmetric", subject.quantity),
                 "correct the entry, or set symmetric = false if it is intended (follower forces, gyroscopic terms)");
}

void check_rigid_motion(const Subject& subject, const MatrixVerdict& verdict, bool allowed, const std::string& slip,
                        foundation::Problems& problems) {
  const double entry = verdict.residual(verdict.residual_row, verdict.residual_motion);
  const std::string finding = fmt::format(
      "a unit {} causes the reaction {:.6g} at {} ({:.3g} % of the scaled stiffness)",
      motion_words(verdict.residual_motion), entry, end_coordinate(verdict.residual_row), 100 * verdict.rigid_residual);
  const std::string rule =
      fmt::format("the {} of a stress-free element does not resist a rigid motion", subject.quantity);
  if (verdict.rigid_residual > elements::refused_residual && !allowed)
    problems.error(subject.path, finding, rule,
                   slip +
                       "correct the matrix, its order (N, then K), its signs or its end points; set allow_residual = "
                       "true if the residual comes from a preload");
  else
    problems.warning(subject.path, finding, rule,
                     "the residual may come from rounding of the data, a wrong end point or a preload");
}

void check_matrix(const Subject& subject, const Description& description, const Element& element,
                  const Matrix12& matrix, foundation::Problems& problems) {
  if (!matrix.allFinite()) {
    problems.error(subject.path, "an entry is not finite", "every entry must be a number",
                   "look for overflow or a missing value");
    return;
  }
  const Span ends = span(description.bodies, element.n, element.k);
  const bool preloaded = element.law.preload && subject.quantity == "stiffness";
  const bool given = element.type == "matrix" && subject.quantity == "stiffness";
  const MatrixVerdict verdict =
      elements::examine(matrix, elements::rigid_motions(ends.arm, ends.n_from_k),
                        preloaded ? elements::turned_preload(*element.law.preload, ends.n_from_k)
                                  : Eigen::Matrix<double, 12, 6>::Zero().eval());
  if (element.symmetric && verdict.asymmetry > elements::rounding_of_data)
    check_symmetry(subject, matrix, verdict, problems);
  if (verdict.rigid_residual > elements::silent_residual)
    check_rigid_motion(subject, verdict, element.allow_residual, given ? slip_behind(description, element, matrix) : "",
                       problems);
  const bool symmetric_stiffness_or_damping = element.symmetric || subject.quantity == "damping";
  // A preloaded element does work in a rigid rotation: only its eigenvalues with N fixed show whether it is stable.
  const double lowest = preloaded ? elements::lowest_of_held_end(matrix) : verdict.lowest_eigenvalue;
  const bool negative = lowest < -elements::rounding_of_data * std::max(1.0, verdict.highest_eigenvalue);
  if (symmetric_stiffness_or_damping && negative &&
      (preloaded || element.allow_residual || elements::is_semidefinite(verdict)))
    problems.warning(subject.path, fmt::format("the scaled matrix has the eigenvalue {:.4g}", lowest),
                     preloaded ? std::string("with end N fixed, a stable preloaded element has no negative eigenvalue")
                               : fmt::format("without preload, a {} matrix has no negative eigenvalue: {}",
                                             subject.quantity, subject.bad_energy),
                     preloaded ? "the element is unstable: it buckles unless other elements hold its bodies"
                               : "the residual may be the cause; check the natural frequencies that it affects");
  else if (symmetric_stiffness_or_damping && negative)
    problems.error(
        subject.path, fmt::format("the scaled matrix has the eigenvalue {:.4g}", verdict.lowest_eigenvalue),
        fmt::format("a {} matrix must not have a negative eigenvalue: {}", subject.quantity, subject.bad_energy),
        (given ? slip_behind(description, element, matrix) : "") +
            "look for a wrong sign, a coupling term with a wrong lever arm, or rows in another order");
}

/// Checks of the law that do not depend on where the element is.
void check_laws(const Description& description, const Element& element, const std::string& subject,
                foundation::Problems& problems) {
  if (std::holds_alternative<elements::Viscoelastic>(element.law.damping) && !element.symmetric)
    problems.error(subject + ".damping", "a viscoelastic law on an unsymmetric stiffness",
                   "a viscoelastic law needs a symmetric stiffness", "use proportional damping or a loss factor");
  if (!(element.law.scale > 0))
    problems.error(subject + ".scale", fmt::format("scale = {:.6g}", element.law.scale), "it must be > 0",
                   "remove the element to switch it off");
  constexpr double weakest = 1e-12,
                   strongest = 1e12;  // beyond these an element is absent or a constraint, and the others lose digits
  if (element.law.scale > 0 && (element.law.scale < weakest || element.law.scale > strongest))
    problems.error(subject + ".scale", fmt::format("scale = {:.6g}", element.law.scale),
                   "it must be between 1e-12 and 1e12",
                   "remove the element to switch it off, or constrain the body by `free`");

  if (element.law.preload && element.law.scale != 1)
    problems.error(subject + ".scale", fmt::format("scale = {:.6g} of a preloaded element", element.law.scale),
                   "a scale would change the stiffness without the preload that belongs to it",
                   "remove scale, and change the dimensions or the matrix of the element");

  const std::string path = element.type == "matrix" ? subject + ".stiffness" : subject;
  check_matrix({path, "stiffness", "it would release energy when deformed"}, description, element,
               element.law.nominal_stiffness, problems);
  if (const auto* given = std::get_if<elements::DampingMatrix>(&element.law.damping))
    check_matrix({subject + ".damping", "damping", "it would feed energy into the motion"}, description, element,
                 given->matrix, problems);
  if (const auto* proportional = std::get_if<elements::ProportionalDamping>(&element.law.damping);
      proportional && !(proportional->factor >= 0))
    problems.error(subject + ".damping.proportional", fmt::format("{:.6g} s", proportional->factor), "it must be ≥ 0",
                   "negative damping would feed energy into the motion");
  if (const auto* loss = std::get_if<elements::LossFactor>(&element.law.damping); loss && !(loss->value >= 0))
    problems.error(subject + ".damping.loss_factor", fmt::format("{:.6g}", loss->value), "it must be ≥ 0",
                   "negative damping would feed energy into the motion");
  constexpr double largest_loss = 100,
                   longest_factor = 1e6;  // rubber has up to 1; B = δK with δ = 1 s damps out everything
  if (const auto* loss = std::get_if<elements::LossFactor>(&element.law.damping); loss && loss->value > largest_loss)
    problems.error(subject + ".damping.loss_factor", fmt::format("{:.6g}", loss->value),
                   "it is at most 100; rubber has up to 1", "check the number");
  if (const auto* proportional = std::get_if<elements::ProportionalDamping>(&element.law.damping);
      proportional && proportional->factor > longest_factor)
    problems.error(subject + ".damping.proportional", fmt::format("{:.6g} s", proportional->factor),
                   "it is at most 1e6 s; above 1 s every vibration is damped out", "check the unit");
}

}  // namespace

void check_element(const Description& description, const Element& element, foundation::Problems& problems) {
  const std::string subject = "elements." + element.name;
  if (element.is_foundation) return check_laws(description, element, subject, problems);
  if (!element.k.body && element.n.body) {
    problems.error(subject, "end K is on the ground", "end K must be on a body, end N on a body or on the ground",
                   "exchange the ends");
    return;
  }
  if (element.n.body == element.k.body) {
    problems.error(subject,
                   !element.n.body                                   ? "both ends are on the ground"
                       : description.bodies[*element.n.body].is_node ? "both ends are on the same node"
                                                                     : "both ends are on the same body",
                   "an element joins two bodies, or a body and the ground", "change `on` or `from`");
    return;
  }
  check_laws(description, element, subject, problems);
}

}  // namespace trivet::model
