// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/held_by_friction.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

#include "trivet/assembly/assembled.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool is_friction(const elements::ScalarLaw& law) {
  return std::holds_alternative<elements::HystereticForce>(law) || std::holds_alternative<elements::LuGreFriction>(law);
}

model::System without_friction(const model::System& system) {
  model::Description description = system.description();
  for (model::Element& element : description.elements) {
    for (model::NonlinearPart& part : element.nonlinear_parts) std::erase_if(part.laws, is_friction);
    element.rubbing_parts.clear();
    for (model::DistancePart& part : element.distance_parts) part.friction.reset();
  }
  return system.in_other_state(std::move(description));
}

/// With a positive stiffness of each part that has any, at rest or within its reach.
MatrixXd positive_stiffness(const model::System& system) {
  return assembly::assemble(with_references(system, positive_references(system))).matrices.K;
}

}  // namespace

std::vector<std::string> held_by_friction_alone(const model::System& system) {
  const MatrixXd whole = positive_stiffness(system), elastic = positive_stiffness(without_friction(system));
  const VectorXd scale =
      whole.diagonal().unaryExpr([](double entry) { return entry == 0 ? 1.0 : 1 / std::sqrt(std::abs(entry)); });
  const auto scaled = [&](const MatrixXd& stiffness) {
    return MatrixXd(scale.asDiagonal() * (0.5 * (stiffness + stiffness.transpose())) * scale.asDiagonal());
  };
  constexpr double round_off = 1e-12;
  if (!(numerics::symmetric_eigenvalues(scaled(whole)).cwiseAbs().minCoeff() > round_off)) return {};
  const auto eigen = numerics::symmetric_eigen(scaled(elastic));
  MatrixXd free(scale.size(), 0);
  for (Index i = 0; i < eigen.values.size(); ++i)
    if (std::abs(eigen.values(i)) <= round_off) {
      free.conservativeResize(Eigen::NoChange, free.cols() + 1);
      free.rightCols<1>() = scale.cwiseProduct(eigen.vectors.col(i));
    }
  std::vector<std::string> names;
  if (free.cols() == 0) return names;
  const References tangents = tangents_at_rest(system);
  const model::System about_rest = with_references(system, tangents);
  const assembly::Assembled assembled = assembly::assemble(about_rest);
  std::vector<Deflection> deflections = nonlinear_deflections(about_rest, assembled, tangents);
  add_rubbings(about_rest, assembled, deflections);
  for (const Deflection& one : deflections) {
    const double moved = (free.transpose() * one.on_coordinates).norm(), most = one.on_coordinates.norm() * free.norm();
    constexpr double small = 1e-6;
    if (moved > small * most) names.push_back(one.name);
  }
  return names;
}

void require_elastic_hold(const model::System& system, const std::string& subject) {
  const std::vector<std::string> names = held_by_friction_alone(system);
  if (names.empty()) return;
  throw foundation::NotComputable(
      fmt::format("{}: the machine is free to move when friction slides, which alone holds it in {}: no force "
                  "determines the mean of its motion; add a soft linear stiffness",
                  subject, fmt::join(names, ", ")));
}

}  // namespace trivet::nonlinear
