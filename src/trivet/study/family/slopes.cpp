// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/slopes.h"

#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/modal/free_motions.h"
#include "trivet/modal/roots.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/study/family/frequency_slopes.h"

namespace trivet::study {

using Complex = std::complex<double>;

void add(CurveEquations& to, double weight, const CurveEquations& other) {
  to.stiffness += weight * other.stiffness;
  to.load += weight * other.load;
  to.row += weight * other.row;
  to.constant += weight * other.constant;
}

void add(RestEquations& to, double weight, const RestEquations& other) {
  to.first += weight * other.first;
  to.whole += weight * other.whole;
  to.loads.on_first += weight * other.loads.on_first;
  to.loads.on_whole += weight * other.loads.on_whole;
  to.row.row += weight * other.row.row;
  to.row.beside += weight * other.row.beside;
  to.row.at_rest += weight * other.row.at_rest;
}

namespace {

/// Σ a_i b_i, without conjugation.
Complex bilinear(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b) { return a.cwiseProduct(b).sum(); }

/// Factors of Z in coordinates scaled to a unit diagonal: light and stiff coordinates keep their digits.
class ScaledFactors {
 public:
  explicit ScaledFactors(const Eigen::MatrixXcd& stiffness)
      : scale_(stiffness.diagonal().unaryExpr([](const Complex& entry) {
          const double size = std::abs(entry);
          return size > 0 ? 1 / std::sqrt(size) : 1.0;
        })),
        factors_(Eigen::MatrixXcd(scale_.asDiagonal() * stiffness * scale_.asDiagonal())) {}
  [[nodiscard]] Eigen::VectorXcd solution(const Eigen::VectorXcd& right) const {
    return scale_.asDiagonal() * factors_.solve(Eigen::VectorXcd(scale_.asDiagonal() * right));
  }

 private:
  Eigen::VectorXd scale_;
  numerics::PivotedLu<Complex> factors_;
};

}  // namespace

Eigen::MatrixXd curve_slopes(const std::vector<CurveEquations>& here, std::size_t parameters,
                             const std::function<std::vector<CurveEquations>(std::size_t)>& changes) {
  std::vector<Eigen::VectorXcd> q, adjoint;
  std::vector<Complex> y;
  for (const CurveEquations& one : here) {
    const ScaledFactors factors(one.stiffness);
    const bool symmetric = one.stiffness == one.stiffness.transpose();
    q.push_back(factors.solution(one.load));
    adjoint.push_back((symmetric ? factors : ScaledFactors(one.stiffness.transpose())).solution(one.row));
    y.push_back(bilinear(one.row, q.back()) + one.constant);
  }
  Eigen::MatrixXd slopes(to_index(here.size()), to_index(parameters));
  for (std::size_t j = 0; j < parameters; ++j) {
    const std::vector<CurveEquations> change = changes(j);
    for (std::size_t i = 0; i < here.size(); ++i) {
      const Complex dy = bilinear(adjoint[i], change[i].load - change[i].stiffness * q[i]) +
          bilinear(change[i].row, q[i]) + change[i].constant;
      slopes(to_index(i), to_index(j)) = (dy / y[i]).real();
    }
  }
  return slopes;
}

namespace {

/// D K D x = D b, refined once: light and stiff coordinates keep their digits.
Eigen::VectorXd solution_at_rest(const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& scale,
                                 const Eigen::VectorXd& load) {
  const numerics::PivotedLu<double> factors(Eigen::MatrixXd(scale.asDiagonal() * stiffness * scale.asDiagonal()));
  const auto solve = [&](const Eigen::VectorXd& b) -> Eigen::VectorXd {
    return scale.asDiagonal() * factors.solve(Eigen::VectorXd(scale.asDiagonal() * b));
  };
  const Eigen::VectorXd first = solve(load);
  return first + solve(load - stiffness * first);
}

}  // namespace

Eigen::RowVectorXd rest_slopes(const RestEquations& here, const Eigen::VectorXd& scale, std::size_t parameters,
                               const std::function<RestEquations(std::size_t)>& change_of) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(scale.size());
  // K₀ that does not hold the machine bears no load: its inverse is not needed.
  const bool bears = !here.loads.on_first.isZero(0), has_others = !here.loads.on_whole.isZero(0);
  const auto solution = [&](bool wanted, const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& load) {
    return wanted ? solution_at_rest(stiffness, scale, load) : none;
  };
  const Eigen::VectorXd by_weight = solution(bears, here.first, here.loads.on_first),
                        by_loads = solution(has_others, here.whole, here.loads.on_whole),
                        mu = solution(bears, here.first.transpose(), here.row.row.transpose()),
                        lambda = solution(has_others, here.whole.transpose(), here.row.beside.transpose());
  const double value = here.row.row.dot(by_weight) + here.row.beside.dot(by_loads) + here.row.at_rest;
  Eigen::RowVectorXd slopes(to_index(parameters));
  for (std::size_t j = 0; j < parameters; ++j) {
    const RestEquations change = change_of(j);
    const double dy = mu.dot(change.loads.on_first - change.first * by_weight) +
        lambda.dot(change.loads.on_whole - change.whole * by_loads) + change.row.row.dot(by_weight) +
        change.row.beside.dot(by_loads) + change.row.at_rest;
    slopes(to_index(j)) = dy / value;
  }
  return slopes;
}

namespace {

/// Derivatives of a shape, one column per parameter, in scaled coordinates and with the scaled frequency as one unknown
/// more. The smallest solution leaves shapes of equal frequencies as they are.
Eigen::MatrixXd shape_changes(const modal::OwnSystem& own, const Eigen::VectorXd& shape, double lambda,
                              const std::vector<modal::OwnSystem>& rates) {
  const numerics::DynamicMatrices& m = own.matrices;
  const Eigen::Index n = m.size();
  const Eigen::VectorXd d = numerics::unit_scale(m);
  Eigen::MatrixXd bordered = Eigen::MatrixXd::Zero(n + 1, n + 1);
  bordered.topLeftCorner(n, n) = d.asDiagonal() * (m.K - lambda * m.A) * d.asDiagonal();
  const double size = bordered.cwiseAbs().maxCoeff();
  bordered /= size;
  bordered.topRightCorner(n, 1) = -(d.asDiagonal() * (m.A * shape));
  bordered.bottomLeftCorner(1, n) = (d.asDiagonal() * ((m.A + m.A.transpose()) * shape)).transpose();
  Eigen::MatrixXd right(n + 1, to_index(rates.size()));
  for (std::size_t j = 0; j < rates.size(); ++j) {
    right.col(to_index(j)).head(n) =
        -(d.asDiagonal() * ((rates[j].matrices.K - lambda * rates[j].matrices.A) * shape)) / size;
    right(n, to_index(j)) = -shape.dot(rates[j].matrices.A * shape);
  }
  return d.asDiagonal() * numerics::smallest_solution(bordered, right).topRows(n);
}

/// Of the mode at one place.
Eigen::RowVectorXd share_slopes(const modal::OwnSystem& own, const modal::OwnModes& modes, Eigen::Index k,
                                const std::vector<modal::OwnSystem>& rates) {
  const Eigen::VectorXd shape = modes.shapes.col(k), moved = shape.head(own.energy[0].rows());
  Eigen::VectorXd shares(6);
  for (std::size_t j = 0; j < 6; ++j) shares(to_index(j)) = moved.dot(own.energy[j] * moved) / modes.norm(k);
  Eigen::Index purest = 0;
  const double share = shares.maxCoeff(&purest);
  const Eigen::MatrixXd& energy = own.energy[purest];
  const Eigen::MatrixXd changes = shape_changes(own, shape, modes.lambda(k), rates).topRows(moved.size());
  Eigen::RowVectorXd slopes = moved.transpose() * (energy + energy.transpose()) * changes;
  for (std::size_t j = 0; j < rates.size(); ++j) slopes(to_index(j)) += moved.dot(rates[j].energy[purest] * moved);
  return slopes / (modes.norm(k) * share);
}

}  // namespace

Eigen::MatrixXd decoupling_slopes(const modal::OwnSystem& own, const std::vector<modal::OwnSystem>& rates,
                                  const std::vector<std::size_t>& modes) {
  const modal::OwnModes found = modal::own_modes(own);
  Eigen::MatrixXd slopes(to_index(modes.size()), to_index(rates.size()));
  for (std::size_t i = 0; i < modes.size(); ++i)
    slopes.row(to_index(i)) = share_slopes(own, found, to_index(modes[i]), rates);
  return slopes;
}

Eigen::MatrixXcd RootEquations::stiffness(const assembly::Assembled& assembled) const {
  if (exact) return assembled.dynamic_stiffness(Complex(0, -1) * lambda, lambda.imag());
  const numerics::DynamicMatrices& m = assembled.matrices;
  return m.complex_stiffness() + lambda * m.B + lambda * lambda * m.A;
}

Eigen::MatrixXcd RootEquations::slope(const assembly::Assembled& assembled) const {
  if (exact) return modal::stiffness_slope(assembled, lambda);
  return 2.0 * lambda * assembled.matrices.A + assembled.matrices.B.cast<Complex>();
}

Eigen::RowVectorXd damping_ratio_slopes(
    const CaseContext& c, std::size_t index, const Eigen::VectorXd& towards,
    const std::function<Eigen::MatrixXcd(const RootEquations&, std::size_t)>& change) {
  constexpr double one_root = 1e-6;  // relative distance below which roots are one subspace
  const std::vector<modal::Root>& roots = c.roots().list;
  const Complex given = roots[index].eigenvalue;
  RootEquations root{0, c.assembled.frequency_dependent() && roots[index].exact};
  Eigen::Index count = 0, place = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (std::abs(roots[i].eigenvalue - given) > one_root * std::abs(given)) continue;
    if (i == index) place = count;
    root.lambda += roots[i].eigenvalue;
    ++count;
  }
  root.lambda /= static_cast<double>(count);
  // The same damping ratio, and where laws are defined.
  if (root.lambda.imag() < 0) root.lambda = std::conj(root.lambda);
  const Eigen::VectorXd scale = numerics::unit_scale(root.exact ? c.assembled.constant : c.assembled.matrices);
  const modal::NullVectors vectors = modal::null_vectors(root.stiffness(c.assembled), scale, count);
  const numerics::PivotedLu<Complex> rate(
      Eigen::MatrixXcd(vectors.left.transpose() * root.slope(c.assembled) * vectors.right));
  std::vector<Eigen::MatrixXcd> changes;
  for (std::size_t j = 0; j < to_size(towards.size()); ++j)
    changes.push_back(-rate.solve(Eigen::MatrixXcd(vectors.left.transpose() * change(root, j) * vectors.right)));
  const auto measure = [&](Complex of_root) {
    return of_root.real() / root.lambda.real() - (std::conj(root.lambda) * of_root).real() / std::norm(root.lambda);
  };
  return separated_motions(changes, towards, measure).row(place);
}

}  // namespace trivet::study
