// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rest_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/deflections.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// The deflections over the share λ of the load: δ + G f(δ) = λ δ_linear, with the machine of positive references as
/// the linear one.
class LoadPath {
 public:
  explicit LoadPath(const model::System& undeformed) {
    const References references = positive_references(undeformed);
    const model::System linear = with_references(undeformed, references);
    const assembly::Assembled assembled = assembly::assemble(linear);
    deflections_ = nonlinear_deflections(linear, assembled, references);
    MatrixXd right(assembled.matrices.size(), to_index(deflections_.size()) + 1);
    for (std::size_t j = 0; j < deflections_.size(); ++j) right.col(to_index(j)) = deflections_[j].on_coordinates;
    const Index count = to_index(deflections_.size());
    right.col(count) = assembly::static_load(linear, assembled);
    loaded_ = !right.col(count).isZero(0);
    if (!loaded_) return;
    const numerics::PivotedLu<double> stiffness(assembled.matrices.K);
    constexpr double singular = 1e-13;
    if (!(stiffness.reciprocal_condition() > singular))
      throw foundation::NotComputable(
          "static: the machine is free to move, so it has no position of rest; hold it by another element");
    const MatrixXd moved = right.leftCols(count).transpose() * stiffness.solve(right);
    receptance_ = moved.leftCols(count);
    references_ = Eigen::Map<const VectorXd>(references.data(), count);
    linear_ = moved.col(count);
  }

  [[nodiscard]] bool loaded() const { return loaded_ && !linear_.isZero(0); }

  void evaluate(const VectorXd& deflections, double share, numerics::Equations& equations) const {
    const Index count = deflections.size();
    VectorXd force(count), tangent(count);
    for (Index j = 0; j < count; ++j) {
      const elements::ForceAndTangent found = deflections_[to_size(j)].law.at(deflections(j));
      force(j) = found.force;
      tangent(j) = found.tangent;
    }
    equations.value = deflections + receptance_ * force - share * linear_;
    equations.by_unknowns = MatrixXd::Identity(count, count) + receptance_ * tangent.asDiagonal();
    equations.by_parameter = -linear_;
  }

  /// The only position of rest of a machine whose forces never fall. A body that is free within a gap falls until it
  /// bears: a share of the references holds it at first, and is then taken away. Empty if forces may fall, or if
  /// Newton's method does not converge.
  [[nodiscard]] std::optional<VectorXd> only_one() const {
    if (!std::all_of(deflections_.begin(), deflections_.end(), [](const Deflection& d) { return d.law.is_monotone(); }))
      return std::nullopt;
    if (std::optional<VectorXd> at_once = solved(linear_, 0)) return at_once;
    std::optional<VectorXd> found = linear_;
    for (const double held : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0.0}) {
      found = solved(*found, held);
      if (!found) return std::nullopt;
    }
    return found;
  }

  /// Newton's method with a line search. @param held  share of the references that holds the machine in addition
  [[nodiscard]] std::optional<VectorXd> solved(VectorXd now, double held) const {
    constexpr int most = 100;
    constexpr double accurate = 1e-13, least_step = 1e-6;
    const MatrixXd added = held * receptance_ * references_.asDiagonal();
    numerics::Equations equations;
    const auto at = [&](const VectorXd& deflections) {
      evaluate(deflections, 1, equations);
      equations.value += added * deflections;
      equations.by_unknowns += added;
    };
    at(now);
    for (int i = 0; i < most; ++i) {
      const VectorXd change = -numerics::PivotedLu<double>(equations.by_unknowns).solve(equations.value);
      if (!change.allFinite()) return std::nullopt;
      if (change.norm() <= accurate * now.norm()) return now;
      const double before = equations.value.norm();
      double step = 1;
      for (;; step /= 2) {
        at(now + step * change);
        if (equations.value.norm() < before || step < least_step) break;
      }
      now += step * change;
    }
    return std::nullopt;
  }

  /// Deflections at the whole load, and the shares at which the load turns before.
  std::pair<VectorXd, std::vector<double>> followed() const {
    constexpr double first_step = 0.05, longest_step = 0.5, shortest_step = 1e-10, least_cosine = 0.9;
    constexpr double across_a_kink = 1e-4;  // a step in which the path may turn sharply: a stop closes
    constexpr int most_points = 5000;
    const numerics::Branch branch([this](const VectorXd& unknowns, double share,
                                         numerics::Equations& equations) { evaluate(unknowns, share, equations); },
                                  VectorXd::Constant(linear_.size(), 1e-3 * linear_.cwiseAbs().maxCoeff()), 1.0);
    std::vector<double> turns;
    std::optional<BranchPoint> now = branch.start(VectorXd::Zero(linear_.size()), 0);
    double step = first_step, highest = 0;
    for (int i = 0; now && i < most_points && step >= shortest_step; ++i) {
      const std::optional<BranchPoint> next = branch.after(*now, step);
      const bool good = next &&
          (step < across_a_kink ||
           (now->tangent.dot(next->tangent.cwiseProduct(next->scale).cwiseQuotient(now->scale).normalized()) >
                least_cosine &&
            !numerics::Branch::hides_folds(*now, *next, step)));
      if (!good) {
        step /= 2;
        continue;
      }
      const bool turns_back = next->parameter_direction() < 0 && now->parameter_direction() > 0;
      const std::optional<BranchPoint> fold = turns_back ? branch.fold(*now, step) : std::nullopt;
      highest = std::max({highest, next->parameter, fold ? fold->parameter : 0.0});
      const double rising_to = fold ? numerics::Branch::length(*now, *fold) : step;
      if (highest >= 1) {
        if (const std::optional<BranchPoint> whole = branch.at(1, *now, 0, rising_to)) return {whole->unknowns, turns};
        step /= 2;
        continue;
      }
      if (fold) turns.push_back(fold->parameter);
      now = next;
      step = std::min(longest_step, 1.5 * step);
    }
    throw foundation::NotComputable(fmt::format(
        "static: no position of rest was found: the load can be raised to {:.4g} of its whole only", highest));
  }

 private:
  std::vector<Deflection> deflections_;
  bool loaded_ = false;
  MatrixXd receptance_;
  VectorXd linear_, references_;
};

}  // namespace

std::vector<std::string> notes_about_rest(const model::System& system) {
  std::vector<std::string> notes;
  for (const model::Element& element : system.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      if (notes.empty())
        notes.emplace_back("nonlinear machine: all but static and steady is for small motions about rest");
      const bool turns = part.axis >= 3;
      notes.push_back(fmt::format("{}: its laws have {:.4g} {} {} {} at rest, at a deflection of {:.4g} {}",
                                  element.name, elements::force_and_tangent(part.laws, part.at_rest).tangent,
                                  turns ? "N m/rad" : "N/m", turns ? "about" : "along", "xyz"[part.axis % 3],
                                  part.at_rest, turns ? "rad" : "m"));
    }
  return notes;
}

RestPosition rest_position(const model::System& system) {
  model::Description description = system.description();
  for (model::Element& element : description.elements)
    for (model::NonlinearPart& part : element.nonlinear_parts) part.at_rest = 0;
  const auto at = [&] { return *model::System::checked(description); };
  const LoadPath path(at());
  std::vector<double> limit_loads;
  if (path.loaded()) {
    const std::optional<VectorXd> only = path.only_one();
    const auto [deflections, turns] = only ? std::pair(*only, std::vector<double>()) : path.followed();
    limit_loads = turns;
    Index next = 0;
    for (model::Element& element : description.elements)
      for (model::NonlinearPart& part : element.nonlinear_parts) part.at_rest = deflections(next++);
  }
  const model::System there = at();
  return {with_references(there, tangents_at_rest(there)), limit_loads};
}

}  // namespace trivet::nonlinear
