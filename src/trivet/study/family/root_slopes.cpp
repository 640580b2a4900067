// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/root_slopes.h"

#include <cmath>
#include <complex>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/modal/exact_roots.h"
#include "trivet/modal/null_vectors.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/study/family/separated_motions.h"

namespace trivet::study {
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
