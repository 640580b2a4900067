// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/nonlinear/laws/deflections.h"

namespace trivet::nonlinear {

/// Nonlinear deflections of which all others are sums: the six of two struts on one coordinate are multiples of one.
/// Motions have only the independent ones as unknowns.
struct DeflectionBasis {
  std::vector<Eigen::Index> independent;  ///< ascending
  Eigen::MatrixXd spread;                 ///< independent × all: motions of all = motions of the independent · spread

  [[nodiscard]] Eigen::Index size() const { return spread.rows(); }
  [[nodiscard]] bool has_all() const { return spread.rows() == spread.cols(); }
  /// Place among the independent ones of a deflection that is one of them.
  [[nodiscard]] Eigen::Index place(Eigen::Index deflection) const;
};

/// @param ground_moves  are the ground coordinates moved, so that they are a part of the deflections?
[[nodiscard]] DeflectionBasis deflection_basis(const assembly::Assembled& assembled,
                                               const std::vector<Deflection>& deflections, bool ground_moves);

}  // namespace trivet::nonlinear
