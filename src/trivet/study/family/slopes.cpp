// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/slopes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/modal/free_motions.h"
#include "trivet/modal/roots.h"
#include "trivet/modal/suspension.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/family/frequency_slopes.h"
#include "trivet/study/requirements/nearest_to_line.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

namespace {

std::complex<double> bilinear(const Eigen::VectorXcd& row, const Eigen::VectorXcd& column) {
  return row.cwiseProduct(column).sum();
}

/// A frequency so low that the slopes are those at rest to 1e-12, where no equation is singular.
double almost_at_rest(const modal::Modes& modes) {
  constexpr double share = 1e-6;
  for (const modal::Mode& mode : modes.list)
    if (const double omega = mode.angular_frequency.value_or(0); omega > 0) return share * omega;
  return share;
}

}  // namespace

Eigen::MatrixXd curve_slopes(const CaseContext& c, const DesignNeighbours& neighbours, const RequirementResult& result,
                             const std::vector<double>& frequencies) {
  const auto driven = [&](const model::System& system, const assembly::Assembled& assembled) {
    RequirementCurve curve = requirement_curve(system, assembled, result);
    return DrivenResult(assembled, std::move(curve.channel), std::move(curve.loading));
  };
  struct Solved {
    double omega;
    response::Dynamics equations;
    Eigen::VectorXcd q, adjoint;
    std::complex<double> y;
  };
  std::vector<Solved> here;
  const DrivenResult given = driven(c.system, c.assembled);
  for (const double at : frequencies) {
    const double omega = std::max(at, almost_at_rest(c.modes));
    response::Dynamics equations = given.at(omega);
    const response::Motion motion = response::motion(equations);
    Eigen::VectorXcd adjoint = response::adjoint(equations)[0];
    here.push_back({omega, std::move(equations), motion.coordinates[0], std::move(adjoint), motion.value[0]});
  }
  Eigen::MatrixXd slopes(to_index(frequencies.size()), to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    std::vector<response::Dynamics> change;
    for (const Solved& solved : here) change.emplace_back(solved.equations).add(-1, solved.equations);
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const DrivenResult there = driven(*model.system, *model.assembled);
      for (std::size_t i = 0; i < here.size(); ++i) {
        response::Dynamics apart = there.at(here[i].omega);
        apart.add(-1, here[i].equations);  // entries that do not change leave no round-off
        change[i].add(model.weight, apart);
      }
    }
    for (std::size_t i = 0; i < here.size(); ++i) {
      const Eigen::VectorXcd& q = here[i].q;
      const std::complex<double> y = here[i].y;
      const std::complex<double> dy = bilinear(here[i].adjoint, change[i].load[0] - change[i].stiffness[0] * q) +
          bilinear(change[i].channel[0], q) + change[i].direct[0];
      slopes(to_index(i), to_index(j)) = (dy / y).real();
    }
  }
  return slopes;
}

namespace {

/// Derivatives of what the modes of a body depend on, per parameter.
std::vector<modal::OwnSystem> own_rates(const DesignNeighbours& neighbours, const modal::OwnSystem& here,
                                        std::size_t body) {
  std::vector<modal::OwnSystem> rates;
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    modal::OwnSystem& rate = rates.emplace_back(here);
    rate.matrices.A.setZero();
    rate.matrices.K.setZero();
    for (Eigen::MatrixXd& energy : rate.energy) energy.setZero();
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const modal::OwnSystem there = modal::own_system(model.system->bodies()[body], *model.assembled,
                                                       modal::rows_of(*model.system, *model.assembled, body));
      rate.matrices.A += model.weight * (there.matrices.A - here.matrices.A);
      rate.matrices.K += model.weight * (there.matrices.K - here.matrices.K);
      for (std::size_t k = 0; k < rate.energy.size(); ++k)
        rate.energy[k] += model.weight * (there.energy[k] - here.energy[k]);
    }
  }
  return rates;
}

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

Eigen::MatrixXd decoupling_slopes(const CaseContext& c, const DesignNeighbours& neighbours, std::size_t body,
                                  const std::vector<std::size_t>& modes) {
  const modal::OwnSystem own =
      modal::own_system(c.system.bodies()[body], c.assembled, modal::rows_of(c.system, c.assembled, body));
  const modal::OwnModes found = modal::own_modes(own);
  const std::vector<modal::OwnSystem> rates = own_rates(neighbours, own, body);
  Eigen::MatrixXd slopes(to_index(modes.size()), to_index(neighbours.parameters()));
  for (std::size_t i = 0; i < modes.size(); ++i)
    slopes.row(to_index(i)) = share_slopes(own, found, to_index(modes[i]), rates);
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

/// Loads and stiffnesses of a machine at rest.
struct Statics {
  Eigen::MatrixXd first, whole;  ///< K₀, K
  response::RestLoads loads;
};
Statics statics_of(const response::AtRest& at_rest) {
  const assembly::Assembled& whole = at_rest.assembled();
  return {whole.first_order().matrices.K, whole.matrices.K, response::rest_loads(at_rest.system(), whole)};
}

}  // namespace

Eigen::RowVectorXd rest_slopes(const CaseContext& c, const DesignNeighbours& neighbours, const RestRowOf& row_of) {
  const response::AtRest at_rest(c.system, c.assembled);
  const Eigen::VectorXd scale = numerics::unit_scale(c.assembled.matrices);
  const response::RestRow here = row_of(at_rest.system(), at_rest.assembled());
  const Statics rest = statics_of(at_rest);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(scale.size());
  // K₀ that does not hold the machine bears no load: its inverse is not needed.
  const bool bears = !rest.loads.on_first.isZero(0), has_others = !rest.loads.on_whole.isZero(0);
  const auto solution = [&](bool wanted, const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& load) {
    return wanted ? solution_at_rest(stiffness, scale, load) : none;
  };
  const Eigen::VectorXd by_weight = solution(bears, rest.first, rest.loads.on_first),
                        by_loads = solution(has_others, rest.whole, rest.loads.on_whole),
                        mu = solution(bears, rest.first.transpose(), here.row.transpose()),
                        lambda = solution(has_others, rest.whole.transpose(), here.beside.transpose());
  const double value = here.row.dot(by_weight) + here.beside.dot(by_loads) + here.at_rest;
  Eigen::RowVectorXd slopes(to_index(neighbours.parameters()));
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    double change = 0;
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const response::AtRest near(*model.system, *model.assembled);
      const response::RestRow there = row_of(near.system(), near.assembled());
      const Statics moved = statics_of(near);
      const Eigen::VectorXd on_weight =
          moved.loads.on_first - rest.loads.on_first - (moved.first - rest.first) * by_weight;
      const Eigen::VectorXd on_loads =
          moved.loads.on_whole - rest.loads.on_whole - (moved.whole - rest.whole) * by_loads;
      change += model.weight *
          (mu.dot(on_weight) + lambda.dot(on_loads) + (there.row - here.row).dot(by_weight) +
           (there.beside - here.beside).dot(by_loads) + there.at_rest - here.at_rest);
    }
    slopes(to_index(j)) = change / value;
  }
  return slopes;
}

namespace {

using Complex = std::complex<double>;

/// Relative distance below which roots are one subspace.
constexpr double one_root = 1e-6;

/// Z and dZ/dλ of the system that a root belongs to.
class SystemOfRoot {
 public:
  SystemOfRoot(const modal::Root& root, bool frequency_dependent) : exact_(frequency_dependent && root.exact) {}

  [[nodiscard]] Eigen::MatrixXcd stiffness(const assembly::Assembled& assembled, Complex lambda) const {
    if (exact_) return assembled.dynamic_stiffness(Complex(0, -1) * lambda, lambda.imag());
    const numerics::DynamicMatrices& m = assembled.matrices;
    return m.complex_stiffness() + lambda * m.B + lambda * lambda * m.A;
  }
  [[nodiscard]] Eigen::MatrixXcd slope(const assembly::Assembled& assembled, Complex lambda) const {
    if (exact_) return modal::stiffness_slope(assembled, lambda);
    return 2.0 * lambda * assembled.matrices.A + assembled.matrices.B.cast<Complex>();
  }
  [[nodiscard]] Eigen::VectorXd scale(const assembly::Assembled& assembled) const {
    return numerics::unit_scale(exact_ ? assembled.constant : assembled.matrices);
  }

 private:
  bool exact_;
};

}  // namespace

Eigen::RowVectorXd damping_ratio_slopes(const CaseContext& c, const DesignNeighbours& neighbours, std::size_t index,
                                        const Eigen::VectorXd& towards) {
  const std::vector<modal::Root>& roots = c.roots().list;
  const Complex given = roots[index].eigenvalue;
  Complex lambda = 0;
  Eigen::Index count = 0, place = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (std::abs(roots[i].eigenvalue - given) > one_root * std::abs(given)) continue;
    if (i == index) place = count;
    lambda += roots[i].eigenvalue;
    ++count;
  }
  lambda /= static_cast<double>(count);
  if (lambda.imag() < 0) lambda = std::conj(lambda);  // the same damping ratio, and where laws are defined
  const SystemOfRoot system(roots[index], c.assembled.frequency_dependent());
  const Eigen::MatrixXcd here = system.stiffness(c.assembled, lambda);
  const modal::NullVectors vectors = modal::null_vectors(here, system.scale(c.assembled), count);
  const numerics::PivotedLu<Complex> rate(
      Eigen::MatrixXcd(vectors.left.transpose() * system.slope(c.assembled, lambda) * vectors.right));
  std::vector<Eigen::MatrixXcd> changes;
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    Eigen::MatrixXcd change = Eigen::MatrixXcd::Zero(here.rows(), here.cols());
    for (const response::WeightedModel& model : neighbours.along(j))
      change += model.weight * (system.stiffness(*model.assembled, lambda) - here);
    changes.push_back(-rate.solve(Eigen::MatrixXcd(vectors.left.transpose() * change * vectors.right)));
  }
  return separated_motions(changes, towards,
                           [&](Complex of_root) {
                             return of_root.real() / lambda.real() -
                                 (std::conj(lambda) * of_root).real() / std::norm(lambda);
                           })
      .row(place);
}

}  // namespace trivet::study
