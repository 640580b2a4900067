// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/basis_integrals.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/load.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

}  // namespace

BasisIntegrals::BasisIntegrals(const PoleExpansions& expansions, IntegrationNodes nodes)
    : poles_(expansions.poles), nodes_(std::move(nodes)) {
  assert(nodes_.omega.size() == nodes_.weight.size());
  for (int m = lowest_power; m <= highest_power; ++m)
    for (const PoleExpansion& part : expansions.parts)
      if (!part.power.col(m - lowest_power).isZero(0)) {
        powers_.push_back(m);
        break;
      }
  const Eigen::Index count = poles_.size(), functions = count + to_index(powers_.size());
  for (Eigen::Index k = 0; k < functions; ++k) {
    const bool pair = expansions.real && k < count && poles_(k).imag() != 0;
    if (pair) {
      assert(k + 1 < count && poles_(k + 1) == std::conj(poles_(k)) && "conjugate poles are adjacent");
      basis_.push_back({k, k + 1, 1, 1});
      basis_.push_back({k, k + 1, Complex(0, 1), Complex(0, -1)});
      ++k;
    } else {
      basis_.push_back({k, k, 1, 0});
      if (!expansions.real) basis_.push_back({k, k, Complex(0, 1), 0});
    }
  }
  const Eigen::Index n = nodes_.omega.size();
  real_.resize(n, functions);
  imag_.resize(n, functions);
  square_.resize(n, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::ArrayXd away = nodes_.omega.array() - poles_(k).imag();
    square_.col(k) = (away.square() + poles_(k).real() * poles_(k).real()).inverse();
    real_.col(k) = -poles_(k).real() * square_.col(k);
    imag_.col(k) = -away * square_.col(k).array();
  }
  for (std::size_t p = 0; p < powers_.size(); ++p)
    for (Eigen::Index i = 0; i < n; ++i) {
      const Complex value = numerics::integer_power(Complex(0, nodes_.omega(i)), powers_[p]);
      real_(i, count + to_index(p)) = value.real();
      imag_(i, count + to_index(p)) = value.imag();
    }
}

Eigen::MatrixXd BasisIntegrals::coefficients(const PoleExpansion& part) const {
  Eigen::MatrixXd result(part.residue.rows(), to_index(basis_.size()));
  for (std::size_t f = 0; f < basis_.size(); ++f) {
    const Function& function = basis_[f];
    const Eigen::Index k = function.first;
    const Eigen::VectorXcd plain = k < poles_.size()
        ? Eigen::VectorXcd(part.residue.col(k))
        : Eigen::VectorXcd(part.power.col(powers_[k - poles_.size()] - lowest_power));
    const bool imaginary = function.factor.imag() != 0;
    for (Eigen::Index c = 0; c < plain.size(); ++c)
      result(c, to_index(f)) = imaginary ? plain(c).imag() : plain(c).real();
  }
  return result;
}

Eigen::MatrixXcd BasisIntegrals::values(const PoleExpansion& part) const {
  const Eigen::Index count = poles_.size();
  Eigen::MatrixXcd amplitude(part.residue.rows(), real_.cols());
  amplitude.leftCols(count) = part.residue;
  for (std::size_t p = 0; p < powers_.size(); ++p)
    amplitude.col(count + to_index(p)) = part.power.col(powers_[p] - lowest_power);
  const Eigen::MatrixXd re = amplitude.real(), im = amplitude.imag();
  Eigen::MatrixXcd result(amplitude.rows(), real_.rows());
  result.real() = re * real_.transpose() - im * imag_.transpose();
  result.imag() = re * imag_.transpose() + im * real_.transpose();
  return result;
}

Eigen::MatrixXcd BasisIntegrals::products(const Eigen::VectorXcd& density) const {
  assert(density.size() == nodes_.omega.size());
  const Eigen::Index count = poles_.size(), functions = real_.cols(), extra = functions - count;
  const Eigen::VectorXcd weight = density.cwiseProduct(nodes_.weight.cast<Complex>());
  const bool real_weight = weight.imag().isZero(0);
  // Columns: the weight, its conjugate, then for each power m the weight · conj(s^m) and conj(weight · s^m).
  const Eigen::Index columns = 2 + 2 * extra;
  Eigen::MatrixXd wr(weight.size(), columns), wi(weight.size(), columns);
  const auto set = [&](Eigen::Index column, const Eigen::VectorXcd& values) {
    wr.col(column) = values.real(), wi.col(column) = values.imag();
  };
  set(0, weight);
  set(1, weight.conjugate());
  for (Eigen::Index m = 0; m < extra; ++m) {
    Eigen::VectorXcd power(weight.size());
    power.real() = real_.col(count + m);
    power.imag() = imag_.col(count + m);
    set(2 + 2 * m, weight.cwiseProduct(power.conjugate()));
    set(3 + 2 * m, weight.cwiseProduct(power).conjugate());
  }
  const Eigen::Index used = real_weight && extra == 0 ? 1 : columns;
  Eigen::MatrixXcd j(functions, columns);
  j.leftCols(used).real() = real_.transpose() * wr.leftCols(used);
  j.leftCols(used).imag() = imag_.transpose() * wr.leftCols(used);
  if (!real_weight || extra > 0) {
    j.leftCols(used).real() -= imag_.transpose() * wi.leftCols(used);
    j.leftCols(used).imag() += real_.transpose() * wi.leftCols(used);
  } else {
    j.col(1) = j.col(0);
  }
  const Eigen::VectorXd of_first = j.col(0).cwiseAbs(), of_second = j.col(1).cwiseAbs();
  const Eigen::VectorXd size = (square_.transpose() * weight.cwiseAbs()).cwiseSqrt();

  Eigen::MatrixXcd result(functions, functions);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (Eigen::Index b = 0; b < count; ++b)
    for (Eigen::Index a = 0; a < count; ++a) {
      const Complex sum = poles_(a) + std::conj(poles_(b));
      // f_k = 1/(iω − λ_k): f_a f̄_b = −(f_a + f̄_b)/(λ_a + λ̄_b), because the denominators add up to −(λ_a + λ̄_b).
      // The sum of two fractions is used only if it does not cancel.
      if (epsilon * (of_first(a) + of_second(b)) <= fraction_accuracy * std::abs(sum) * size(a) * size(b)) {
        result(a, b) = -(j(a, 0) + std::conj(j(b, 1))) / sum;
        continue;
      }
      const Eigen::ArrayXd re =
          real_.col(a).array() * real_.col(b).array() + imag_.col(a).array() * imag_.col(b).array();
      const Eigen::ArrayXd im =
          imag_.col(a).array() * real_.col(b).array() - real_.col(a).array() * imag_.col(b).array();
      result(a, b) = Complex((re * weight.real().array() - im * weight.imag().array()).sum(),
                             (im * weight.real().array() + re * weight.imag().array()).sum());
    }
  for (Eigen::Index m = 0; m < extra; ++m) {
    result.col(count + m) = j.col(2 + 2 * m);
    result.row(count + m).head(count) = j.col(3 + 2 * m).head(count).adjoint();
  }
  return result;
}

Eigen::MatrixXd BasisIntegrals::real_products(const Eigen::VectorXcd& weight) const {
  const Eigen::MatrixXcd plain = products(weight);
  const auto count = to_index(basis_.size());
  Eigen::MatrixXcd half(plain.rows(), count);
  for (Eigen::Index f = 0; f < count; ++f) {
    const Function& function = basis_[f];
    half.col(f) = std::conj(function.factor) * plain.col(function.first) +
        std::conj(function.second_factor) * plain.col(function.second);
  }
  Eigen::MatrixXd result(count, count);
  for (Eigen::Index f = 0; f < count; ++f) {
    const Function& function = basis_[f];
    result.row(f) =
        (function.factor * half.row(function.first) + function.second_factor * half.row(function.second)).real();
  }
  return result;
}

}  // namespace trivet::response
