// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/condensed_machine.h"

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::nonlinear {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

CondensedMachine::CondensedMachine(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                                   const assembly::Loading& loading)
    : ground_(to_index(deflections.size())) {
  if (assembled.frequency_dependent())
    throw foundation::NotComputable(
        "nonlinear motion with elements whose stiffness is a function of frequency is not computed yet; give them "
        "constant matrices or a Maxwell model");
  const Index count = to_index(deflections.size()), n = assembled.matrices.size();
  MatrixXd rows(n, count), ground_rows(assembled.ground.size(), count);
  for (Index j = 0; j < count; ++j) {
    rows.col(j) = deflections[to_size(j)].on_coordinates;
    ground_rows.col(j) = deflections[to_size(j)].on_ground;
  }
  const numerics::Load right = assembly::right_side(assembled, loading);
  MatrixXcd right_sides(n, count + to_index(right.terms().size()));
  right_sides.leftCols(count) = rows.cast<Complex>();
  for (std::size_t t = 0; t < right.terms().size(); ++t) {
    terms_.push_back({right.terms()[t].power, right.terms()[t].delay, count + to_index(t)});
    right_sides.col(terms_.back().column) = right.terms()[t].value;
  }
  for (const numerics::LoadTerm& term : loading.motion.terms())
    ground_.add({term.power, term.delay, ground_rows.transpose().cast<Complex>() * term.value});
  const numerics::PoleResidueForm form = numerics::pole_residue_form(assembled.matrices, right_sides);
  const MatrixXcd across = rows.transpose().cast<Complex>();
  const double free = form.free_motion.size() > 0 ? form.free_motion.cwiseAbs().maxCoeff() : 0;
  if (free > 0)
    throw foundation::NotComputable(
        "the machine is free to move when its nonlinear parts are removed; add a soft linear stiffness");
  poles_ = form.poles;
  shapes_ = across * form.shapes;
  participation_ = form.participation;
  static_part_ = across * form.static_part;
  residues_.resize(count * count, poles_.size());
  for (Index p = 0; p < poles_.size(); ++p)
    residues_.col(p) = (shapes_.col(p) * participation_.row(p).head(count)).reshaped();
  all_shapes_ = form.shapes;
  all_static_ = form.static_part;
  all_receptance_ = numerics::PivotedLu<double>(assembled.matrices.K).solve(rows);
  static_receptance_ = rows.transpose() * all_receptance_;
}

MatrixXcd CondensedMachine::coordinates(const MatrixXd& forces, double omega, double factor) const {
  const Index harmonics = (forces.rows() - 1) / 2;
  MatrixXcd all(all_receptance_.rows(), harmonics + 1);
  for (Index k = 0; k <= harmonics; ++k) {
    VectorXcd force(forces.cols());
    for (Index j = 0; j < forces.cols(); ++j)
      force(j) = k == 0 ? Complex(forces(0, j)) : Complex(forces(2 * k - 1, j), -forces(2 * k, j));
    all.col(k) = coordinates_at(static_cast<double>(k) * omega, k == 1 ? factor : 0, force);
  }
  return all;
}

VectorXcd CondensedMachine::coordinates_at(double omega, double factor, const VectorXcd& force) const {
  if (omega == 0) return -(all_receptance_.cast<Complex>() * force);
  const Complex s(0, omega);
  VectorXcd weights = VectorXcd::Zero(static_part_.cols());
  weights.head(size()) = -force;
  if (factor != 0)
    for (const Term& term : terms_)
      weights(term.column) = factor * numerics::integer_power(s, term.power) * std::exp(-s * term.delay);
  const VectorXcd inverse = (s - poles_.array()).inverse().matrix();
  return all_shapes_ * (inverse.asDiagonal() * (participation_ * weights)) + all_static_ * weights;
}

MatrixXcd CondensedMachine::at(Complex s, Index first, Index columns, MatrixXcd& slope) const {
  const VectorXcd inverse = (s - poles_.array()).inverse().matrix();
  MatrixXcd weighted = inverse.asDiagonal() * participation_.middleCols(first, columns);
  MatrixXcd value = shapes_ * weighted + static_part_.middleCols(first, columns);
  weighted = inverse.asDiagonal() * weighted;
  slope = Complex(0, -1) * (shapes_ * weighted);
  return value;
}

void CondensedMachine::set_receptance(double omega, MatrixXcd& found) const {
  const VectorXcd inverse = (Complex(0, omega) - poles_.array()).inverse().matrix();
  found = static_part_.leftCols(size());
  found.reshaped().noalias() += residues_ * inverse;
}

void CondensedMachine::set_receptance(double omega, Receptance& found) const {
  set_receptance(omega, found.receptance);
  const VectorXcd squares = Complex(0, -1) * (Complex(0, omega) - poles_.array()).inverse().square().matrix();
  found.slope.resize(size(), size());
  found.slope.reshaped().noalias() = residues_ * squares;
}

LinearMotion CondensedMachine::linear_motion(double omega) const {
  const Complex s(0, omega), i(0, 1);
  LinearMotion found{VectorXcd::Zero(size()), VectorXcd::Zero(size())};
  const auto add = [&](int power, double delay, const VectorXcd& value, const VectorXcd& slope) {
    const Complex factor = numerics::integer_power(s, power) * std::exp(-s * delay);
    found.motion += factor * value;
    found.slope += factor * (slope + i * (static_cast<double>(power) / s - delay) * value);
  };
  for (const Term& term : terms_) {
    MatrixXcd slope;
    const MatrixXcd value = at(s, term.column, 1, slope);
    add(term.power, term.delay, value, slope);
  }
  for (const numerics::LoadTerm& term : ground_.terms())
    add(term.power, term.delay, term.value, VectorXcd::Zero(size()));
  return found;
}

}  // namespace trivet::nonlinear
