// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine/condensed_machine.h"

#include <complex>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

namespace {

/// The deflections, over the motion of the ground by each term of the loadings instead of that of its coordinates: feet
/// on one base move as the base does, whatever the number of ground coordinates.
std::vector<Deflection> over_ground_terms(std::vector<Deflection> deflections, const PeriodicExcitation& excitation) {
  const std::vector<Deflection> given = deflections;
  for (Deflection& one : deflections) one.on_ground.resize(0);
  for (const assembly::Loading& loading : excitation.loadings)
    for (const numerics::LoadTerm& term : loading.motion.terms()) {
      VectorXcd moved(to_index(given.size()));
      for (Index j = 0; j < moved.size(); ++j)
        moved(j) = (given[j].on_ground.transpose().cast<std::complex<double>>() * term.value)(0);
      const double largest = moved.size() > 0 ? moved.cwiseAbs().maxCoeff() : 0;
      if (!(largest > 0)) continue;
      for (Index j = 0; j < moved.size(); ++j) {
        Eigen::VectorXd& parts = deflections[j].on_ground;
        parts.conservativeResize(parts.size() + 2);
        parts.tail<2>() << moved(j).real() / largest, moved(j).imag() / largest;
      }
    }
  return deflections;
}

}  // namespace

CondensedMachine::CondensedMachine(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                                   const PeriodicExcitation& excitation)
    : basis_(deflection_basis(assembled, over_ground_terms(deflections, excitation), true)),
      excited_(excitation.harmonics) {
  for (const assembly::ElementMap& map : assembled.elements)
    if (map.defined_from > 0)
      throw foundation::NotComputable(
          "the mean of nonlinear motions needs static stiffnesses, and the table of an element starts above 0 Hz; add "
          "a "
          "row at 0 Hz");
  std::vector<Deflection> independent;
  MatrixXd rows(assembled.matrices.size(), basis_.size());
  for (const Index j : basis_.independent) {
    rows.col(to_index(independent.size())) = deflections[j].on_coordinates;
    independent.push_back(deflections[j]);
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
