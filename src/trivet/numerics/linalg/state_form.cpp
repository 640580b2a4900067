// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/state_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::numerics {

StateForm state_form(const DynamicMatrices& given, const Eigen::MatrixXcd& given_sides) {
  assert(given_sides.rows() == given.size());
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices m = scaled(given, d);
  const Eigen::MatrixXcd h = d.asDiagonal() * given_sides;
  const std::vector<Eigen::Index> p = massive_rows(m.A), z = rows_without(m.size(), p);
  const auto n = to_index(p.size()), k = to_index(z.size());
  assert(n + k == m.size() && "each coordinate has mass or none");
  const Eigen::MatrixXcd K = m.complex_stiffness();
  const double speed = std::sqrt(std::max(K.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min()));
  const Eigen::MatrixXd no_lag = m.B(z, z), mass = m.A(p, p);
  const PivotedLu<Complex> lag(no_lag.cast<Complex>()), inertia(mass.cast<Complex>());
  // z' first, because it acts on v' through the coupling damping; v = speed · w balances the state matrix.
  Eigen::MatrixXcd z_rate(k, 2 * n + k), v_rate(n, 2 * n + k);
  z_rate << K(z, p), speed * m.B(z, p).cast<Complex>(), K(z, z);
  Eigen::MatrixXcd z_input = h(z, Eigen::all), v_input = h(p, Eigen::all);
  if (k > 0) {
    z_rate = -lag.solve(z_rate);
    z_input = lag.solve(z_input);
  }
  v_rate << K(p, p), speed * m.B(p, p).cast<Complex>(), K(p, z);
  // Products are evaluated first: Eigen would add them to the sums in parts.
  const Eigen::MatrixXcd lag_rate = m.B(p, z).cast<Complex>() * z_rate, lag_input = m.B(p, z).cast<Complex>() * z_input;
  v_rate = -inertia.solve(Eigen::MatrixXcd(v_rate + lag_rate));
  v_input = inertia.solve(Eigen::MatrixXcd(v_input - lag_input));
  StateForm form;
  form.real = !m.lossy();
  form.state = Eigen::MatrixXcd::Zero(2 * n + k, 2 * n + k);
  form.state.block(0, n, n, n) = speed * Eigen::MatrixXcd::Identity(n, n);
  form.state.middleRows(n, n) = v_rate / speed;
  form.state.bottomRows(k) = z_rate;
  form.input = Eigen::MatrixXcd::Zero(2 * n + k, h.cols());
  form.input.middleRows(n, n) = v_input / speed;
  form.input.bottomRows(k) = z_input;
  form.output = Eigen::MatrixXcd::Zero(m.size(), 2 * n + k);
  for (Eigen::Index i = 0; i < n; ++i) form.output(p[i], i) = d(p[i]);
  for (Eigen::Index i = 0; i < k; ++i) form.output(z[i], 2 * n + i) = d(z[i]);
  return form;
}

GeneralEigen eigen_of_states(const StateForm& form) {
  assert(form.state.rows() == form.state.cols());
  GeneralEigen found = form.real ? general_eigen(Eigen::MatrixXd(form.state.real())) : general_eigen(form.state);
  if (!found.converged) throw foundation::NotComputable("the eigensolver of the state matrix did not converge");
  return found;
}

}  // namespace trivet::numerics
