// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/packed_curve.h"

#include <cmath>
#include <limits>

#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::study {
namespace {

using Complex = std::complex<double>;

Eigen::VectorXcd sum_of(const std::vector<numerics::DesignTerm>& terms, Eigen::Index design, Eigen::Index n,
                        Complex s) {
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(n);
  for (const numerics::DesignTerm& term : terms) {
    const Complex power = std::pow(s, term.power);
    for (Eigen::Index i = 0; i < n; ++i) sum(i) += power * Complex(term.re(design, i), term.im(design, i));
  }
  return sum;
}

}  // namespace

PackedCurve packed_curve(const numerics::DrivenDesigns& designs, Eigen::Index design, std::size_t curve, double omega) {
  const Complex s(0, omega);
  const numerics::DesignCurve& one = designs.curves[curve];
  const Eigen::MatrixXd K = numerics::unpacked(designs.K, design), D = numerics::unpacked(designs.D, design),
                        B = numerics::unpacked(designs.B, design), A = numerics::unpacked(designs.A, design);
  PackedCurve at;
  at.stiffness = (K - omega * omega * A).cast<Complex>();
  at.stiffness.imag() = D + omega * B;
  at.load = sum_of(designs.loads[one.load], design, K.rows(), s);
  at.row = sum_of(one.rows, design, K.rows(), s);
  at.constant = {one.constant_re(design, 0), one.constant_im(design, 0)};
  return at;
}

double packed_magnitude(const numerics::DrivenDesigns& designs, Eigen::Index design, std::size_t curve, double omega) {
  const PackedCurve here = packed_curve(designs, design, curve, omega);
  const Eigen::VectorXcd q = numerics::PivotedLu<Complex>(here.stiffness).solve(here.load);
  const double size = std::abs(here.row.cwiseProduct(q).sum() + here.constant);
  return std::isfinite(size) ? size : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace trivet::study
