// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/response_series.h"

#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/massless.h"

namespace trivet::numerics {
namespace {

/// Up to this size, −Z0⁻¹ [Z2 Z1] is formed once: a product with it costs less than a solution with the factors.
constexpr Eigen::Index most_formed = 18;

/// Coefficients of (Z0 + Z1 τ + Z2 τ²)⁻¹ Σ h_j τʲ for small matrices.
Eigen::MatrixXcd small_series(const Eigen::MatrixXcd& Z0, const Eigen::MatrixXcd& Z1, const Eigen::MatrixXcd& Z2,
                              const Eigen::MatrixXcd& h) {
  const Eigen::Index n = h.rows();
  const PivotedLu<Complex> lu(Z0);
  Eigen::MatrixXcd step(n, 2 * n);  // −Z0⁻¹ [Z2 Z1], applied to the last two coefficients stacked
  step << Z2, Z1;
  step = -lu.solve(step);
  Eigen::MatrixXcd q = Eigen::MatrixXcd::Zero(n, h.cols() + 1);  // a zero precedes the first coefficient
  q.col(1) = lu.solve(Eigen::VectorXcd(h.col(0)));
  const Eigen::VectorXcd reached = Z0 * q.col(1);
  q.col(1) += lu.solve(Eigen::VectorXcd(h.col(0) - reached));
  for (Eigen::Index j = 1; j < h.cols(); ++j) {
    q.col(j + 1).noalias() = step * Eigen::Map<const Eigen::VectorXcd>(q.col(j - 1).data(), 2 * n);
    if (!h.col(j).isZero(0)) q.col(j + 1) += lu.solve(Eigen::VectorXcd(h.col(j)));
  }
  return q.rightCols(h.cols());
}

/// The same for matrices of any size: `solve` applies Z0⁻¹, the others Z0, Z1 and Z2.
template <typename Solve, typename Zeroth, typename First, typename Second>
Eigen::MatrixXcd large_series(const Solve& solve, const Zeroth& zeroth, const First& first, const Second& second,
                              const Eigen::MatrixXcd& h) {
  Eigen::MatrixXcd q(h.rows(), h.cols());
  q.col(0) = solve(h.col(0));
  q.col(0) += solve(h.col(0) - zeroth(q.col(0)));
  for (Eigen::Index j = 1; j < h.cols(); ++j) {
    Eigen::VectorXcd right = h.col(j) - first(q.col(j - 1));
    if (j > 1) right -= second(q.col(j - 2));
    q.col(j) = solve(right);
  }
  return q;
}

/// The same for dense matrices.
Eigen::MatrixXcd series(const Eigen::MatrixXcd& Z0, const Eigen::MatrixXcd& Z1, const Eigen::MatrixXcd& Z2,
                        const Eigen::MatrixXcd& h) {
  if (h.rows() <= most_formed) return small_series(Z0, Z1, Z2, h);
  const PivotedLu<Complex> lu(Z0);
  const auto times = [](const Eigen::MatrixXcd& z) {
    return [&z](const Eigen::VectorXcd& x) -> Eigen::VectorXcd { return z * x; };
  };
  return large_series([&](const Eigen::VectorXcd& b) { return lu.solve(b); }, times(Z0), times(Z1), times(Z2), h);
}

/// iᵏ.
Complex power_of_i(int k) {
  static constexpr double re[] = {1, 0, -1, 0}, im[] = {0, 1, 0, -1};
  const int turn = (k % 4 + 4) % 4;
  return {re[turn], im[turn]};
}

/// Coefficients of (centre + radius τ)^power e^{−i (centre + radius τ) delay}.
Eigen::RowVectorXcd factor_series(const LoadTerm& term, double centre, double radius, int order) {
  Eigen::RowVectorXcd c = Eigen::RowVectorXcd::Zero(order + 1);
  if (term.power >= 0) {  // the binomial theorem, finite
    double choose = 1;
    for (int j = 0; j <= std::min(term.power, order); ++j) {
      c(j) = choose * std::pow(centre, term.power - j) * std::pow(radius, j);
      choose *= static_cast<double>(term.power - j) / (j + 1);
    }
  } else {
    c(0) = std::pow(centre, term.power);
    for (int j = 1; j <= order; ++j)
      c(j) = c(j - 1) * (radius / centre) * (static_cast<double>(term.power - j + 1) / j);
  }
  if (term.delay == 0) return c;
  Eigen::RowVectorXcd turning(order + 1), product = Eigen::RowVectorXcd::Zero(order + 1);
  turning(0) = std::polar(1.0, -centre * term.delay);
  for (int j = 1; j <= order; ++j)
    turning(j) = turning(j - 1) * Complex(0, -radius * term.delay) / static_cast<double>(j);
  for (int j = 0; j <= order; ++j)
    for (int k = 0; k <= j; ++k) product(j) += c(k) * turning(j - k);
  return product;
}

}  // namespace

Eigen::MatrixXcd load_series(const Load& load, double centre, double radius, int order) {
  Eigen::MatrixXcd h = Eigen::MatrixXcd::Zero(load.size(), order + 1);
  for (const LoadTerm& term : load.terms()) {
    const Eigen::VectorXcd value = power_of_i(term.power) * term.value;
    if (term.power == 0 && term.delay == 0) h.col(0) += value;
    else h += value * factor_series(term, centre, radius, order);
  }
  return h;
}

ResponseSeries::ResponseSeries(const DynamicMatrices& matrices, const Load& load)
    : scale_(unit_scale(matrices)),
      matrices_(scaled(matrices, scale_)),
      load_(load.scaled(scale_)),
      system_(matrices_) {}

Eigen::MatrixXcd ResponseSeries::about(double centre, double radius, int order) const {
  assert(radius > 0 && order >= 0);
  const Eigen::MatrixXcd h = load_series(load_, centre, radius, order);
  if (matrices_.size() <= most_formed) {
    const Eigen::MatrixXcd A = matrices_.A.cast<Complex>(), B = matrices_.B.cast<Complex>();
    const Eigen::MatrixXcd slope = radius * (Complex(0, 1) * B - 2 * centre * A);
    const Eigen::MatrixXcd curvature = -radius * radius * A;
    return scale_.asDiagonal() * small_series(matrices_.at(centre), slope, curvature, h);
  }
  const SystemFactors factors = system_.factors(centre);
  const auto derivative = [&](int k, double factor) {
    return [this, k, factor, centre](const Eigen::VectorXcd& x) -> Eigen::VectorXcd {
      return factor * system_.product(k, centre, x);
    };
  };
  return scale_.asDiagonal() *
      large_series([&](const Eigen::VectorXcd& b) { return factors.solve(b); }, derivative(0, 1), derivative(1, radius),
                   derivative(2, radius * radius / 2), h);
}

SeriesAtInfinity load_series_at_infinity(const Load& load, double radius, int order) {
  // (iω)ᵏ = iᵏ s⁻ᵏ; the highest power leads.
  SeriesAtInfinity result{Eigen::MatrixXcd::Zero(load.size(), order + 1), -load.highest_power()};
  for (const LoadTerm& term : load.terms()) {
    const int later = load.highest_power() - term.power;
    if (later <= order) result.coefficients.col(later) += power_of_i(term.power) * std::pow(radius, later) * term.value;
  }
  return result;
}

SeriesAtInfinity ResponseSeries::at_infinity(double radius, int order) const {
  const DynamicMatrices& m = matrices_;
  if (const PartedSystem parted = parted_system(m); parted.any) {
    SeriesAtInfinity q = ResponseSeries(parted.matrices, load_.in_basis(parted.basis)).at_infinity(radius, order);
    q.coefficients = (scale_.asDiagonal() * (parted.basis * q.coefficients)).eval();
    return q;
  }
  SeriesAtInfinity h = load_series_at_infinity(load_, radius, order + 2);
  Eigen::MatrixXcd constant = -m.A.cast<Complex>();
  Eigen::MatrixXcd slope = Complex(0, radius) * m.B.cast<Complex>();
  Eigen::MatrixXcd curvature = radius * radius * m.complex_stiffness();
  // A row without mass is zero at s = 0. Divided by s it is regular: i B + s K, or by s² if it has stiffness only. The
  // load of such a row must then start that many powers later: the whole right side is shifted.
  std::vector<int> lowered(to_size(m.size()), 0);
  int shift = 0;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    if (!m.A.row(i).isZero(0)) continue;
    const int by = m.B.row(i).isZero(0) ? 2 : 1;
    lowered[i] = by;
    for (int k = 0; k < by; ++k) {
      constant.row(i) = slope.row(i) / radius;
      slope.row(i) = curvature.row(i) / radius;
      curvature.row(i).setZero();
    }
    int free_powers = 0;
    while (free_powers < by && h.coefficients(i, free_powers) == Complex(0)) ++free_powers;
    shift = std::max(shift, by - free_powers);
  }
  // s² Z q = s² h; q = s^power p.
  Eigen::MatrixXcd right = Eigen::MatrixXcd::Zero(m.size(), order + 1);
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const int by = lowered[i] - shift;  // divided by s^lowered, multiplied by s^shift
    for (int j = std::max(0, -by); j <= order; ++j) right(i, j) = h.coefficients(i, j + by) * std::pow(radius, -by);
  }
  return {scale_.asDiagonal() * series(constant, slope, curvature, right), 2 + h.power - shift};
}

}  // namespace trivet::numerics
