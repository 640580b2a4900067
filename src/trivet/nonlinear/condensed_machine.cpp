// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/condensed_machine.h"

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

CondensedMachine::CondensedMachine(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                                   const PeriodicExcitation& excitation)
    : excited_(excitation.harmonics) {
  for (const assembly::ElementMap& map : assembled.elements)
    if (map.defined_from > 0)
      throw foundation::NotComputable(
          "the mean of nonlinear motions needs static stiffnesses, and the table of an element starts above 0 Hz; add "
          "a "
          "row at 0 Hz");
  MatrixXd rows(assembled.matrices.size(), to_index(deflections.size()));
  for (Index j = 0; j < rows.cols(); ++j) rows.col(j) = deflections[to_size(j)].on_coordinates;
  const numerics::PivotedLu<double> stiffness(assembled.matrices.K);
  machine_ = assembled.frequency_dependent() ? machine_over_frequency(assembled, deflections, excitation.loadings)
                                             : machine_of_poles(assembled, deflections, excitation.loadings);
  all_receptance_ = stiffness.solve(rows);
  static_receptance_ = rows.transpose() * all_receptance_;
}

MatrixXcd CondensedMachine::coordinates(const MatrixXd& forces, double omega, double factor) const {
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
