// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/rubbing_loop.h"

#include <cassert>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;

namespace {

template <typename Scalar>
using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// One number per point.
template <typename Of>
VectorXd each(const RubbingLoop& loop, const Of& of) {
  VectorXd found(to_index(loop.points().size()));
  for (Index i = 0; i < found.size(); ++i) found(i) = of(loop.points()[i]);
  return found;
}

/// The forces on the three deflections by forces over the travel on the wall.
template <typename Scalar>
std::array<Columns<Scalar>, 3> on_deflections(const RubbingLoop& loop, const RubbingLoop::Forces<Scalar>& on_wall) {
  if (!loop.law().is_ring()) return {Columns<Scalar>(), on_wall[0], on_wall[1]};
  const auto around = [&](Index a) {
    return each(loop, [a](const RubbingLoop::Point& point) { return point.frame.hoop * point.frame.tangents(0, a); });
  };
  return {around(0).asDiagonal() * on_wall[0], around(1).asDiagonal() * on_wall[0], on_wall[1]};
}

/// The forces on the three deflections at the points by variations of one of them.
/// @param waves   points × columns
/// @param slopes  of these by the phase
template <typename Scalar>
std::array<Columns<Scalar>, 3> forces_by(const RubbingLoop& loop, double omega, Index deflection,
                                         const Columns<Scalar>& waves, const Columns<Scalar>& slopes,
                                         std::optional<Scalar> turned) {
  using Point = RubbingLoop::Point;
  if (loop.points().empty()) return {};
  RubbingLoop::Variation<Scalar> by;
  const bool is_ring = loop.law().is_ring(), presses = is_ring ? deflection < 2 : deflection == 0;
  // δL = (∂L/∂a n + ∂L/∂ȧ ω n') δ + ∂L/∂ȧ ω n δ', a along the contact, n its normal, primes by the phase.
  if (presses) {
    const VectorXd by_deflection = each(loop, [&](const Point& point) {
      return point.limit.by_deflection * point.frame.normal(deflection) +
          point.limit.by_rate * omega * point.normal_slope(deflection);
    });
    const VectorXd by_rate =
        each(loop, [&](const Point& point) { return point.limit.by_rate * omega * point.frame.normal(deflection); });
    by.limit = by_deflection.asDiagonal() * waves;
    by.limit += by_rate.asDiagonal() * slopes;
  }
  if (!is_ring && deflection > 0) by.across[deflection - 1] = waves;
  if (is_ring && deflection == 2) by.across[1] = waves;
  if (!is_ring || deflection == 2) return on_deflections(loop, loop.variation<Scalar>(by, turned));
  by.across[0] =
      each(loop, [&](const Point& point) { return point.frame.on_wall(0, deflection); }).asDiagonal() * waves;
  by.hoop = each(loop, [&](const Point& point) { return point.frame.hoop_by_along() * point.frame.normal(deflection); })
                .asDiagonal() *
      waves;
  std::array<Columns<Scalar>, 3> found = on_deflections(loop, loop.variation<Scalar>(by, turned));
  for (Index a = 0; a < 2; ++a)  // as the contact turns and widens
    found[a] += each(loop,
                     [&](const Point& point) {
                       const ContactFrame& frame = point.frame;
                       const double force = point.force.x();
                       return frame.turned(frame.friction(point.force))(a, deflection) +
                           frame.hoop_by_along() * force * frame.tangents(0, a) * frame.normal(deflection);
                     })
                    .asDiagonal() *
        waves;
  return found;
}

template <typename Scalar>
void subtract(double stiffness, Index count, Columns<Scalar>& tangent) {
  if (stiffness == 0) return;
  if (tangent.size() == 0) tangent.setZero(count, count);
  assert(tangent.rows() == count && tangent.cols() == count);
  tangent.diagonal().array() -= stiffness;
}

}  // namespace

RubbingHarmonics rubbing_harmonics(const RubbingLoop& loop, const MatrixXd& course, double omega, bool with_tangent) {
  // Coefficients f̂_k = (1/π) ∫ f(φ) (cos kφ, sin kφ) dφ, half of that for the mean, of the friction f = Tᵀ H f_t on the
  // three deflections (tangents T, hoop H, force over the travel f_t), less the stiffness of the linear machine there.
  assert(course.cols() == 3 && course.rows() % 2 == 1);
  const Index count = course.rows(), points = to_index(loop.points().size());
  const Eigen::Matrix3d own = loop.law().own_stiffness();
  RubbingHarmonics found{-course * own, MatrixXd::Zero(count, 3)};
  MatrixXd rows(points, count), integral(count, points);
  Eigen::RowVectorXd row;
  for (Index i = 0; i < points; ++i) {
    const RubbingLoop::Point& point = loop.points()[i];
    numerics::set_fourier_row((count - 1) / 2, point.phase, row);
    rows.row(i) = row;
    integral.col(i) = point.weight / (two_pi / 2) * row.transpose();
    integral(0, i) /= 2;
    found.force += integral.col(i) * (point.frame.friction(point.force).transpose() * point.frame.tangents);
  }
  if (!with_tangent) return found;
  MatrixXd slopes = MatrixXd::Zero(points, count);  // of the rows by the phase
  for (Index k = 1; 2 * k < count; ++k) {
    slopes.col(2 * k - 1) = -static_cast<double>(k) * rows.col(2 * k);
    slopes.col(2 * k) = static_cast<double>(k) * rows.col(2 * k - 1);
  }
  for (std::size_t b = 0; b < 3; ++b) {
    const std::array<MatrixXd, 3> forces = forces_by<double>(loop, omega, to_index(b), rows, slopes, std::nullopt);
    for (std::size_t a = 0; a < 3; ++a) {
      if (forces[a].size() > 0) found.tangent[a][b] = integral * forces[a];
      subtract(own(to_index(a), to_index(b)), count, found.tangent[a][b]);
    }
  }
  if (points == 0) return found;
  RubbingLoop::Variation<double> by_frequency;  // which changes the rate
  by_frequency.limit.resize(points, 1);
  const MatrixXd rates = slopes * course;
  for (Index i = 0; i < points; ++i) {
    const RubbingLoop::Point& point = loop.points()[i];
    by_frequency.limit(i) = point.limit.by_rate * point.frame.normal.dot(rates.row(i));
  }
  const std::array<MatrixXd, 3> forces = on_deflections(loop, loop.variation<double>(by_frequency));
  for (std::size_t a = 0; a < 3; ++a)
    if (forces[a].size() > 0) found.by_omega.col(to_index(a)) = integral * forces[a];
  return found;
}

RubbingVariation rubbing_variation(const RubbingLoop& loop, double omega, double mu, Index harmonics) {
  const Index count = 2 * harmonics + 1, points = to_index(loop.points().size());
  const Eigen::Matrix3d own = loop.law().own_stiffness();
  MatrixXcd waves(points, count), slopes(points, count), integral(count, points);
  for (Index i = 0; i < points; ++i) {
    const RubbingLoop::Point& point = loop.points()[i];
    for (Index k = 0; k < count; ++k) {
      const double order = mu + static_cast<double>(k - harmonics);
      const Complex wave = std::polar(1.0, order * point.phase);
      waves(i, k) = wave;
      slopes(i, k) = Complex(0, order) * wave;
      integral(k, i) = point.weight / two_pi * std::conj(wave);
    }
  }
  // f̂_k = (1/2π) ∫ δf(φ) e^{−i(μ + k)φ} dφ, by variations that each period turns by e^{2πiμ}.
  const Complex turned = std::polar(1.0, two_pi * mu);
  RubbingVariation found;
  for (std::size_t b = 0; b < 3; ++b) {
    const std::array<MatrixXcd, 3> forces = forces_by<Complex>(loop, omega, to_index(b), waves, slopes, turned);
    for (std::size_t a = 0; a < 3; ++a) {
      if (forces[a].size() > 0) found[a][b] = integral * forces[a];
      subtract(own(to_index(a), to_index(b)), count, found[a][b]);
    }
  }
  return found;
}

}  // namespace trivet::nonlinear
