// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/frequency_slopes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/modal/free_motions.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::study {

Eigen::MatrixXd separated_motions(const std::vector<Eigen::MatrixXcd>& changes, const Eigen::VectorXd& towards,
                                  const std::function<double(std::complex<double>)>& measure) {
  const Eigen::Index m = changes.front().rows();
  Eigen::MatrixXd slopes(m, to_index(changes.size()));
  Eigen::MatrixXcd motions = Eigen::MatrixXcd::Identity(m, m);
  if (m > 1) {
    double widest = -1;
    for (std::size_t j = 0; j < changes.size(); ++j) {
      const Eigen::MatrixXcd change = towards(to_index(j)) * changes[j];
      const numerics::GeneralEigen found = numerics::general_eigen(change);
      if (!found.converged) continue;
      std::vector<Eigen::Index> order(to_size(m));
      std::iota(order.begin(), order.end(), 0);
      std::ranges::stable_sort(
          order, [&](Eigen::Index a, Eigen::Index b) { return measure(found.values(a)) < measure(found.values(b)); });
      const double width = measure(found.values(order.back())) - measure(found.values(order.front()));
      if (!(width > widest)) continue;
      widest = width;
      motions = found.vectors(Eigen::all, order);
    }
  }
  const numerics::PivotedLu<std::complex<double>> basis(motions);
  for (std::size_t j = 0; j < changes.size(); ++j) {
    const Eigen::MatrixXcd in_motions = basis.solve(Eigen::MatrixXcd(changes[j] * motions));
    slopes.col(to_index(j)) = in_motions.diagonal().unaryExpr(measure);
  }
  return slopes;
}

namespace {

/// Relative distance of natural frequencies below which they are one subspace. The slopes of single modes would be
/// right only for changes smaller than this distance.
constexpr double one_frequency = 1e-6;

bool are_equal(const modal::Mode& lower, const modal::Mode& upper) {
  return upper.eigenvalue_squared - lower.eigenvalue_squared <= 2 * one_frequency * upper.eigenvalue_squared;
}

double real_part(std::complex<double> change) { return change.real(); }

}  // namespace

FrequencySlopes::FrequencySlopes(const modal::Modes& modes, const numerics::DynamicMatrices& matrices,
                                 std::vector<response::MatrixRates> rates, Eigen::VectorXd towards)
    : modes_(modes), matrices_(matrices), rates_(std::move(rates)), towards_(std::move(towards)) {}

FrequencySlopes::Subspace FrequencySlopes::subspace_of(std::size_t mode) const {
  const auto equal_to_next = [&](std::size_t i) { return are_equal(modes_.list[i], modes_.list[i + 1]); };
  Subspace found{mode, 1};
  for (; found.first > 0 && equal_to_next(found.first - 1); --found.first) ++found.size;
  while (found.first + found.size < modes_.list.size() && equal_to_next(found.first + found.size - 1)) ++found.size;
  return found;
}

std::vector<Eigen::MatrixXcd> FrequencySlopes::changes(const Subspace& subspace) const {
  const auto count = to_index(subspace.size);
  Eigen::MatrixXcd shapes(matrices_.size(), count);
  double square = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const modal::Mode& mode = modes_.list[subspace.first + i];
    shapes.col(i) = mode.coordinates.cast<std::complex<double>>();
    square += mode.eigenvalue_squared / static_cast<double>(count);
  }
  Eigen::MatrixXcd left = shapes;
  if (!matrices_.symmetric) {
    const Eigen::MatrixXcd singular = (matrices_.K - square * matrices_.A).cast<std::complex<double>>();
    left = modal::null_vectors(singular, numerics::unit_scale(matrices_), count).left;
  }
  const Eigen::MatrixXcd of_mass = left.transpose() * matrices_.A * shapes;
  const numerics::PivotedLu<std::complex<double>> mass(of_mass);
  std::vector<Eigen::MatrixXcd> result;
  for (const response::MatrixRates& rate : rates_) {
    const Eigen::MatrixXcd change = left.transpose() * ((rate.K - square * rate.A) * shapes);
    result.push_back(mass.solve(change) / (2 * square));
  }
  return result;
}

Eigen::RowVectorXd FrequencySlopes::slopes_of_single(const modal::Mode& mode) const {
  const Eigen::VectorXd& shape = mode.coordinates;
  const double square = mode.eigenvalue_squared, mass = shape.dot(matrices_.A * shape);
  Eigen::RowVectorXd slopes(to_index(rates_.size()));
  for (std::size_t j = 0; j < rates_.size(); ++j)
    slopes(to_index(j)) =
        (shape.dot(rates_[j].K * shape) - square * shape.dot(rates_[j].A * shape)) / (2 * square * mass);
  return slopes;
}

Eigen::RowVectorXd FrequencySlopes::slopes(int number) const {
  const Subspace subspace = subspace_of(to_size(number - 1));
  if (subspace.size == 1 && matrices_.symmetric) return slopes_of_single(modes_.list[subspace.first]);
  return separated_motions(changes(subspace), towards_, real_part).row(number - 1 - to_index(subspace.first));
}

Eigen::VectorXd FrequencySlopes::slopes_along(int number, const Eigen::VectorXd& direction) const {
  const std::vector<Eigen::MatrixXcd> per_parameter = changes(subspace_of(to_size(number - 1)));
  Eigen::MatrixXcd along = direction(0) * per_parameter.front();
  for (std::size_t j = 1; j < per_parameter.size(); ++j) along += direction(to_index(j)) * per_parameter[j];
  return separated_motions({along}, Eigen::VectorXd::Ones(1), real_part).col(0);
}

}  // namespace trivet::study
