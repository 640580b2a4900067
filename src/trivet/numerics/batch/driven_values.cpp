// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/batch/driven_values.h"

#include <cmath>
#include <complex>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::numerics {
namespace {

using Complex = std::complex<double>;

/// The row of a design, or the one of all designs.
Eigen::Index row_of(const Eigen::ArrayXXd& numbers, Eigen::Index design) { return numbers.rows() == 1 ? 0 : design; }

}  // namespace

Eigen::MatrixXcd driven_stiffness(const DrivenDesigns& designs, Eigen::Index design, double omega) {
  const auto matrix = [&](const Eigen::ArrayXXd& packed) { return unpacked(packed, row_of(packed, design)); };
  Eigen::MatrixXcd stiffness = (matrix(designs.K) - omega * omega * matrix(designs.A)).cast<Complex>();
  stiffness.imag() = omega * matrix(designs.B);
  if (designs.D.size() > 0) stiffness.imag() += matrix(designs.D);
  return stiffness;
}

Eigen::VectorXcd sum_of_terms(const std::vector<DesignTerm>& terms, Eigen::Index design, double omega) {
  Eigen::VectorXcd sum;
  for (const DesignTerm& term : terms) {
    if (sum.size() == 0) sum.setZero(term.re.cols());
    const Complex power = std::pow(Complex(0, omega), term.power);
    for (Eigen::Index i = 0; i < sum.size(); ++i)
      sum(i) += power * Complex(term.re(row_of(term.re, design), i), term.im(row_of(term.im, design), i));
  }
  return sum;
}

Eigen::ArrayXd driven_magnitudes(const DrivenDesigns& designs, Eigen::Index design, double omega) {
  const PivotedLu<Complex> factors(driven_stiffness(designs, design, omega));
  std::vector<Eigen::VectorXcd> motions;
  for (const std::vector<DesignTerm>& load : designs.loads)
    motions.push_back(factors.solve(sum_of_terms(load, design, omega)));
  Eigen::ArrayXd sizes(to_index(designs.curves.size()));
  for (Eigen::Index c = 0; c < sizes.size(); ++c) {
    const DesignCurve& one = designs.curves[to_size(c)];
    const Complex constant(one.constant_re(row_of(one.constant_re, design), 0),
                           one.constant_im(row_of(one.constant_im, design), 0));
    const double size =
        std::abs(sum_of_terms(one.rows, design, omega).cwiseProduct(motions[one.load]).sum() + constant);
    sizes(c) = std::isfinite(size) ? size : std::numeric_limits<double>::quiet_NaN();
  }
  return sizes;
}

}  // namespace trivet::numerics
