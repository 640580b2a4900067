// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "trivet/modal/modes.h"
#include "trivet/response/steady/model_rates.h"

namespace trivet::study {

/// Slopes of m equal values that are eigenvalues of one matrix, such as repeated natural frequencies.
///
/// Along a direction they are the eigenvalues of the change of that matrix over the common subspace: one-sided, sorted,
/// and not linear in the direction. Here the parameter is chosen that parts the values most; the motions that it parts
/// have slopes along all parameters. These bound the true ones: the least of the values grows at most so fast, and the
/// values part at least so fast.
/// @param changes  m × m over the subspace, per parameter
/// @param towards  how far each parameter may still move, with its sign
/// @param measure  change of the value for a change of the eigenvalue; linear
/// @returns  m × parameters, rows ascending along the chosen parameter; NaN if its change is defective
[[nodiscard]] Eigen::MatrixXd separated_motions(const std::vector<Eigen::MatrixXcd>& changes,
                                                const Eigen::VectorXd& towards,
                                                const std::function<double(std::complex<double>)>& measure);

/// Derivatives of ln ω of undamped natural frequencies: dω² = wᵀ(dK − ω²dA)φ / wᵀAφ, w = φ for symmetric matrices.
/// Frequencies that agree within 1e-6 belong to one subspace, with the slopes of `separated_motions`.
class FrequencySlopes {
 public:
  /// @param rates    per parameter
  /// @param towards  how far each parameter may still move, with its sign
  FrequencySlopes(const modal::Modes& modes, const numerics::DynamicMatrices& matrices,
                  std::vector<response::MatrixRates> rates, Eigen::VectorXd towards);

  /// Per parameter. @param number  of a mode with ω > 0
  [[nodiscard]] Eigen::RowVectorXd slopes(int number) const;
  /// One-sided slopes along a direction of all frequencies that are equal to that of this mode, ascending.
  [[nodiscard]] Eigen::VectorXd slopes_along(int number, const Eigen::VectorXd& direction) const;

 private:
  /// Modes of one frequency: the place of the first in the list, and their number.
  struct Subspace {
    std::size_t first = 0, size = 1;
  };
  [[nodiscard]] Subspace subspace_of(std::size_t mode) const;
  [[nodiscard]] Eigen::RowVectorXd slopes_of_single(const modal::Mode& mode) const;
  /// d ln ω as a matrix over the subspace, per parameter.
  [[nodiscard]] std::vector<Eigen::MatrixXcd> changes(const Subspace& subspace) const;

  const modal::Modes& modes_;
  const numerics::DynamicMatrices& matrices_;
  std::vector<response::MatrixRates> rates_;
  Eigen::VectorXd towards_;
};

}  // namespace trivet::study
