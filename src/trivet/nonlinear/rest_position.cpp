// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rest_position.h"

#include <fmt/format.h>

#include <cmath>

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
    double step = first_step;
    for (int i = 0; now && i < most_points && step >= shortest_step; ++i) {
      const std::optional<BranchPoint> next = branch.after(*now, step);
      const bool good = next &&
          (step < across_a_kink ||
           now->tangent.dot(next->tangent.cwiseProduct(next->scale).cwiseQuotient(now->scale).normalized()) >
               least_cosine);
      if (!good) {
        step /= 2;
        continue;
      }
      if (next->parameter >= 1) {
        const double share = (1 - now->parameter) / (next->parameter - now->parameter);
        const VectorXd guess = now->unknowns + share * (next->unknowns - now->unknowns);
        if (const std::optional<BranchPoint> whole = branch.start(guess, 1)) return {whole->unknowns, turns};
        step /= 2;
        continue;
      }
      if (next->parameter_direction() < 0 && now->parameter_direction() > 0)
        if (const std::optional<BranchPoint> fold = branch.fold(*now, step)) turns.push_back(fold->parameter);
      now = next;
      step = std::min(longest_step, 1.5 * step);
    }
    throw foundation::NotComputable(fmt::format(
        "static: no position of rest was found: the load can be followed to {:.3g} of its whole only", now->parameter));
  }

 private:
  std::vector<Deflection> deflections_;
  bool loaded_ = false;
  MatrixXd receptance_;
  VectorXd linear_;
};

}  // namespace

RestPosition rest_position(const model::System& system) {
  model::Description description = system.description();
  for (model::Element& element : description.elements)
    for (model::NonlinearPart& part : element.nonlinear_parts) part.at_rest = 0;
  const auto at = [&] { return *model::System::checked(description); };
  const LoadPath path(at());
  std::vector<double> limit_loads;
  if (path.loaded()) {
    const auto [deflections, turns] = path.followed();
    limit_loads = turns;
    Index next = 0;
    for (model::Element& element : description.elements)
      for (model::NonlinearPart& part : element.nonlinear_parts) part.at_rest = deflections(next++);
  }
  const model::System there = at();
  return {with_references(there, tangents_at_rest(there)), limit_loads};
}

}  // namespace trivet::nonlinear
