// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/condensed_machine.h"

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

namespace {

bool moves_ground(const PeriodicExcitation& excitation) {
  return std::any_of(excitation.loadings.begin(), excitation.loadings.end(),
                     [](const assembly::Loading& loading) { return !loading.motion.vanishes(); });
}

}  // namespace

CondensedMachine::CondensedMachine(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                                   const PeriodicExcitation& excitation)
    : basis_(deflection_basis(assembled, deflections, moves_ground(excitation))), excited_(excitation.harmonics) {
  for (const assembly::ElementMap& map : assembled.elements)
    if (map.defined_from > 0)
      throw foundation::NotComputable(
          "the mean of nonlinear motions needs static stiffnesses, and the table of an element starts above 0 Hz; add "
          "a "
          "row at 0 Hz");
  std::vector<Deflection> independent;
  MatrixXd rows(assembled.matrices.size(), basis_.size());
  for (const Index j : basis_.independent) {
    rows.col(to_index(independent.size())) = deflections[to_size(j)].on_coordinates;
    independent.push_back(deflections[to_size(j)]);
  }
  const numerics::PivotedLu<double> stiffness(assembled.matrices.K);
  machine_ = assembled.frequency_dependent() ? machine_over_frequency(assembled, independent, excitation.loadings)
                                             : machine_of_poles(assembled, independent, excitation.loadings);
  all_receptance_ = stiffness.solve(rows);
  static_receptance_ = rows.transpose() * all_receptance_;
}

MatrixXcd CondensedMachine::coordinates(const MatrixXd& of_all, double omega, double factor) const {
  const MatrixXd forces = of_all * basis_.spread.transpose();
  const Index harmonics = (forces.rows() - 1) / 2;
  MatrixXcd all(all_receptance_.rows(), harmonics + 1);
  all.col(0) = (-(all_receptance_ * forces.row(0).transpose())).cast<std::complex<double>>();
  std::size_t next = 0;
  for (Index k = 1; k <= harmonics; ++k) {
    VectorXcd force(forces.cols());
    for (Index j = 0; j < forces.cols(); ++j) force(j) = {forces(2 * k - 1, j), -forces(2 * k, j)};
    const bool is_excited = next < excited_.size() && excited_[next] == k;
    all.col(k) = machine_->coordinates(static_cast<double>(k) * omega, force, is_excited ? &next : nullptr, factor);
    if (is_excited) ++next;
  }
  return all;
}

}  // namespace trivet::nonlinear
