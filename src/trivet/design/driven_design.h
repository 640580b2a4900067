// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/design/missing_reasons.h"
#include "trivet/numerics/batch/driven_peaks.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::design {

/// A design for kernels of many designs: real symmetric constant matrices with loss factors, K positive definite, loads
/// with any phases and with powers of s = iω (an unbalance, a moving ground), results that may differ from design to
/// design. With more than twelve coordinates, only viscous damping and one real load that is constant over ω.
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

/// A load whose components are in phase is turned to be real: the phase of a result is not kept.
/// @param within_band  only the highest values in a finite band are requested: results may grow towards high
/// frequencies
[[nodiscard]] DesignOrReason<DrivenDesign> driven_design(const assembly::Assembled& assembled,
                                                         const std::vector<assembly::Channel>& channels,
                                                         const assembly::Loading& loading, bool within_band = false);

// What a family interpolates.

/// Packed lower triangles of A, B, K, D, then loads, rows and constants, real before imaginary parts.
[[nodiscard]] Eigen::VectorXd packed(const DrivenDesign& design);
/// Reference magnitude of each packed entry.
[[nodiscard]] Eigen::VectorXd scales(const DrivenDesign& design);
/// Reason why two designs cannot be in one family; empty if they can.
[[nodiscard]] std::string reason_for_separate_families(const DrivenDesign& a, const DrivenDesign& b);

/// Number of entries of the packed matrices.
[[nodiscard]] Eigen::Index matrix_entries(Eigen::Index coordinates);
/// Designs from packed entries, one row each: the matrices first, from column `at` on loads, rows and constants.
[[nodiscard]] numerics::DrivenDesigns unpacked_like(const DrivenDesign& first, const Eigen::MatrixXd& entries,
                                                    Eigen::Index at);
/// Highest amplitudes and peaks of such designs, on one thread: by numerics::design_peaks if all of them have viscous
/// damping, real loads that are constant over ω and the same real results, else by numerics::driven_peaks, which
/// decides nothing above twelve coordinates.
[[nodiscard]] numerics::DesignPeaks peaks_of(const DrivenDesign& first, const Eigen::MatrixXd& entries, Eigen::Index at,
                                             const numerics::DrivenPeakOptions& options);

}  // namespace trivet::design
