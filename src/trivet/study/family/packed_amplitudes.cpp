// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/packed_amplitudes.h"

#include <cmath>
#include <complex>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace trivet::study {
namespace {

using Complex = std::complex<double>;

numerics::DynamicMatrices matrices(const numerics::DrivenDesigns& designs, Eigen::Index design) {
  numerics::DynamicMatrices of = {numerics::unpacked(designs.A, design), numerics::unpacked(designs.B, design),
                                  numerics::unpacked(designs.K, design), Eigen::MatrixXd()};
  if (designs.D.size() > 0 && (designs.D.row(design) != 0).any()) of.K_loss = numerics::unpacked(designs.D, design);
  return of;
}

Eigen::VectorXcd value_of(const numerics::DesignTerm& term, Eigen::Index design) {
  Eigen::VectorXcd value(term.re.cols());
  value.real() = term.re.row(design).transpose();
  value.imag() = term.im.row(design).transpose();
  return value;
}

numerics::Load load_of(const std::vector<numerics::DesignTerm>& terms, Eigen::Index design, Eigen::Index n) {
  numerics::Load load(n);
  for (const numerics::DesignTerm& term : terms) load.add({term.power, 0, value_of(term, design)});
  return load;
}

/// Adds (iω)^power Σ row_i q_i at each frequency. Products of std::complex look for infinities, which takes longer.
void add_term(const numerics::DesignTerm& term, Eigen::Index design, const Eigen::MatrixXcd& q,
              const std::vector<double>& omega, Eigen::ArrayXd& re, Eigen::ArrayXd& im) {
  const Eigen::VectorXcd row = value_of(term, design);
  const bool is_real = row.imag().isZero(0);
  for (Eigen::Index f = 0; f < q.cols(); ++f) {
    const Complex* at = q.col(f).data();
    double x = 0, y = 0;
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      const double a = row(i).real(), b = row(i).imag();
      x += a * at[i].real();
      y += a * at[i].imag();
      if (is_real) continue;
      x -= b * at[i].imag();
      y += b * at[i].real();
    }
    for (int k = 0; k < term.power; ++k) x = -omega[to_size(f)] * std::exchange(y, omega[to_size(f)] * x);
    re(f) += x;
    im(f) += y;
  }
}

}  // namespace

Eigen::ArrayXXd packed_amplitudes(const numerics::DrivenDesigns& designs, Eigen::Index design,
                                  const std::vector<double>& omega) {
  const numerics::DynamicMatrices of = matrices(designs, design);
  const Eigen::Index n = of.size(), count = to_index(omega.size());
  Eigen::ArrayXXd amplitudes(count, to_index(designs.curves.size()));
  for (std::size_t l = 0; l < designs.loads.size(); ++l) {
    const numerics::SweepResult found =
        numerics::sweep(of, load_of(designs.loads[l], design, n), omega, {.every_backward_error = false, .threads = 1});
    for (std::size_t c = 0; c < designs.curves.size(); ++c) {
      const numerics::DesignCurve& curve = designs.curves[c];
      if (curve.load != l) continue;
      Eigen::ArrayXd re = Eigen::ArrayXd::Constant(count, curve.constant_re(design, 0)),
                     im = Eigen::ArrayXd::Constant(count, curve.constant_im(design, 0));
      for (const numerics::DesignTerm& term : curve.rows) add_term(term, design, found.response, omega, re, im);
      auto into = amplitudes.col(to_index(c));
      for (Eigen::Index f = 0; f < count; ++f) {
        const double amplitude = std::sqrt(re(f) * re(f) + im(f) * im(f));
        into(f) = std::isfinite(amplitude) ? amplitude : foundation::infinity;
      }
    }
  }
  return amplitudes;
}

}  // namespace trivet::study
