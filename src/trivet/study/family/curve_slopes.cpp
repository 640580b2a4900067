// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/curve_slopes.h"

#include <algorithm>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/study/requirements/driven_result.h"
#include "trivet/study/requirements/requirement_curve.h"

namespace trivet::study {
namespace {

std::complex<double> with(const Eigen::VectorXcd& row, const Eigen::VectorXcd& column) {
  return row.cwiseProduct(column).sum();
}

/// A frequency so low that the slopes are those at rest to 1e-12, where no equation is singular.
double almost_at_rest(const modal::Modes& modes) {
  constexpr double share = 1e-6;
  for (const modal::Mode& mode : modes.list)
    if (const double omega = mode.angular_frequency.value_or(0); omega > 0) return share * omega;
  return share;
}

}  // namespace

Eigen::MatrixXd curve_slopes(const CaseContext& c, const DesignNeighbours& neighbours, const RequirementResult& result,
                             const std::vector<double>& frequencies) {
  const auto driven = [&](const model::System& system, const assembly::Assembled& assembled) {
    RequirementCurve curve = requirement_curve(system, assembled, result);
    return DrivenResult(assembled, std::move(curve.channel), std::move(curve.loading));
  };
  struct Solved {
    double omega;
    response::Dynamics equations;
    Eigen::VectorXcd q, adjoint;
    std::complex<double> y;
  };
  std::vector<Solved> here;
  const DrivenResult given = driven(c.system, c.assembled);
  for (const double at : frequencies) {
    const double omega = std::max(at, almost_at_rest(c.modes));
    response::Dynamics equations = given.at(omega);
    const response::Motion motion = response::motion(equations);
    Eigen::VectorXcd adjoint = response::adjoint(equations)[0];
    here.push_back({omega, std::move(equations), motion.coordinates[0], std::move(adjoint), motion.value[0]});
  }
  Eigen::MatrixXd slopes(to_index(frequencies.size()), to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    std::vector<response::Dynamics> change;
    for (const Solved& solved : here) change.emplace_back(solved.equations).add(-1, solved.equations);
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const DrivenResult there = driven(*model.system, *model.assembled);
      for (std::size_t i = 0; i < here.size(); ++i) {
        response::Dynamics apart = there.at(here[i].omega);
        apart.add(-1, here[i].equations);  // entries that do not change leave no round-off
        change[i].add(model.weight, apart);
      }
    }
    for (std::size_t i = 0; i < here.size(); ++i) {
      const Eigen::VectorXcd& q = here[i].q;
      const std::complex<double> y = here[i].y;
      const std::complex<double> dy = with(here[i].adjoint, change[i].load[0] - change[i].stiffness[0] * q) +
          with(change[i].channel[0], q) + change[i].direct[0];
      slopes(to_index(i), to_index(j)) = (dy / y).real();
    }
  }
  return slopes;
}

}  // namespace trivet::study
