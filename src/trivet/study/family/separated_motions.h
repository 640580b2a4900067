// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

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

}  // namespace trivet::study
