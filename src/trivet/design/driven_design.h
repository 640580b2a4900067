// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/design/missing_reasons.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::design {

/// A design for `numerics::driven_peaks`: real symmetric constant matrices with loss factors, loads with any phases and
/// with powers of s = iω (an unbalance, a moving ground), results that may differ from design to design.
struct DrivenDesign {
  struct Term {
    int power = 0;
    Eigen::VectorXcd value;  ///< n
  };
  struct Curve {
    std::size_t load = 0;
    std::vector<Term> rows;
    std::complex<double> constant;  ///< of the ground motion
  };
  Eigen::MatrixXd A, B, K;               ///< n × n
  Eigen::MatrixXd D;                     ///< loss, n × n, zero without loss factors
  std::vector<std::vector<Term>> loads;  ///< two if some results are computed relative to the ground
  std::vector<Curve> curves;
};

/// @param within_band  only the highest values in a finite band are requested: results may grow towards high
/// frequencies
[[nodiscard]] DesignOrReason<DrivenDesign> driven_design(const assembly::Assembled& assembled,
                                                         const std::vector<assembly::Channel>& channels,
                                                         const assembly::Loading& loading, bool within_band = false);

// What DesignFamily interpolates.

/// Packed lower triangles of A, B, K, D, then loads, rows and constants, real before imaginary parts.
[[nodiscard]] Eigen::VectorXd packed(const DrivenDesign& design);
/// Reference magnitude of each packed entry.
[[nodiscard]] Eigen::VectorXd scales(const DrivenDesign& design);
/// Reason why two designs cannot be in one family; empty if they can.
[[nodiscard]] std::string reason_for_separate_families(const DrivenDesign& a, const DrivenDesign& b);
/// Designs from packed entries, one row each.
[[nodiscard]] numerics::DrivenDesigns unpacked_like(const DrivenDesign& first, const Eigen::MatrixXd& entries);

}  // namespace trivet::design
