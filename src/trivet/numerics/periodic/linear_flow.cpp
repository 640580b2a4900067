// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/linear_flow.h"

#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::numerics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

LinearFlow::LinearFlow(const MatrixXd& F) {
  const Index n = F.rows();
  if (n == 0) return;
  const GeneralEigen eigen = general_eigen(F);
  if (!eigen.converged) return;
  growth_.resize(n);
  turning_.resize(n);
  partner_.resize(to_size(n));
  to_states_.resize(n, n);
  for (Index i = 0; i < n;) {
    const std::complex<double> value = eigen.values(i);
    const bool pair = value.imag() != 0 && i + 1 < n;
    growth_(i) = value.real();
    turning_(i) = pair ? value.imag() : 0;
    partner_[i] = pair ? i + 1 : i;
    to_states_.col(i) = eigen.vectors.col(i).real();
    if (pair) {
      growth_(i + 1) = value.real();
      turning_(i + 1) = -value.imag();
      partner_[i + 1] = i;
      to_states_.col(i + 1) = eigen.vectors.col(i).imag();
    }
    i += pair ? 2 : 1;
  }
  const PivotedLu<double> lu(to_states_);
  constexpr double dependent = 1e-9;
  if (!(lu.reciprocal_condition() > dependent)) return;
  from_states_ = lu.solve(MatrixXd(MatrixXd::Identity(n, n)));
  regular_ = true;
}

LinearFlow::Step LinearFlow::step(double time) const {
  Step result{VectorXd(growth_.size()), VectorXd(growth_.size())};
  for (Index i = 0; i < growth_.size(); ++i) {
    const double size = std::exp(growth_(i) * time);
    result.diagonal(i) = size * std::cos(turning_(i) * time);
    result.beside(i) = size * std::sin(turning_(i) * time);
  }
  return result;
}

void LinearFlow::apply(const Step& step, RowMatrix& y) const {
  const Index columns = y.cols();
  for (Index i = 0; i < y.rows(); ++i) {
    const Index other = partner_[i];
    double* const row = y.row(i).data();
    const double on_diagonal = step.diagonal(i);
    if (other == i) {
      for (Index j = 0; j < columns; ++j) row[j] *= on_diagonal;
    } else if (other > i) {
      double* const partner = y.row(other).data();
      const double beside = step.beside(i), from_row = step.beside(other), of_partner = step.diagonal(other);
      for (Index j = 0; j < columns; ++j) {
        const double a = row[j], b = partner[j];
        row[j] = on_diagonal * a + beside * b;
        partner[j] = from_row * a + of_partner * b;
      }
    }
  }
}

void LinearFlow::apply_with_kicks(double step, const Kicks& kicks, RowMatrix& y) const {
  const Index n = y.rows(), moving = growth_.size(),
              stride = (y.cols() + longest_pack - 1) / longest_pack * longest_pack;
  const auto with_rest = [&](Step of_flow) {
    of_flow.diagonal.conservativeResize(n);
    of_flow.diagonal.tail(n - moving).setOnes();
    return of_flow;
  };
  const Step half = with_rest(this->step(step / 2)), whole = with_rest(this->step(step));
  std::vector<char> leads(to_size(n));
  for (Index i = 0; i < moving; ++i) leads[i] = partner_[i] > i;
  LineMemory states;
  states.resize(to_size(n * stride));
  Eigen::Map<RowMatrix> padded(states.data(), n, stride);
  padded.setZero();
  padded.leftCols(y.cols()) = y;
  const Index forces = kicks.kick.cols();
  assert(forces > 0 && kicks.jacobians.rows() % forces == 0);
  take_kicked_steps({.states = n,
                     .forces = forces,
                     .values = kicks.seen.rows(),
                     .steps = kicks.jacobians.rows() / forces,
                     .seen = kicks.seen.data(),
                     .jacobians = kicks.jacobians.data(),
                     .kick = kicks.kick.data(),
                     .leads = leads.data(),
                     .half = {half.diagonal.data(), half.beside.data()},
                     .whole = {whole.diagonal.data(), whole.beside.data()}},
                    states.data(), y.cols(), stride);
  y = padded.leftCols(y.cols());
}

MatrixXd LinearFlow::at(double time) const {
  RowMatrix y = from_states_;
  apply(step(time), y);
  return to_states_ * y;
}

}  // namespace trivet::numerics
