// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>

#include "trivet/numerics/batch/design_peaks.h"
#include "trivet/numerics/roots/designs.h"
#include "trivet/study/family/case_vector.h"

namespace trivet::study {

/// A result at one frequency: y = cᵀq + y₀ with Zq = h; or the changes of these.
struct CurveEquations {
  Eigen::MatrixXcd stiffness;     ///< Z
  Eigen::VectorXcd load, row;     ///< h, c
  std::complex<double> constant;  ///< y₀
};
[[nodiscard]] CurveEquations packed_curve(const numerics::DrivenDesigns& designs, Eigen::Index design,
                                          std::size_t curve, double omega);

/// Margins of amplitudes, isolations and peaks of many designs at once, designs × requirements; infinite for all
/// others, NaN where the kernels prove nothing.
struct CurveMargins {
  Eigen::ArrayXXd margins;
  std::vector<numerics::DesignStatus> status;  ///< per design: how its curves were searched, the worst of all
};
[[nodiscard]] CurveMargins curve_margins(const CaseVector& of, const CaseVector::Unpacked& designs);

/// Margins of all other covered requirements, as `requirement_values` computes them for one: NaN where the kernels
/// prove nothing (no positive definite matrices).
[[nodiscard]] Eigen::ArrayXXd quick_margins(const CaseVector& of, const CaseVector::Unpacked& designs);

/// Both. On one thread. @param entries  one packed design per row
[[nodiscard]] Eigen::ArrayXXd packed_margins(const CaseVector& of, const Eigen::MatrixXd& entries);

/// Highest amplitudes of the curves of a search in its band, and peaks at all frequencies.
[[nodiscard]] numerics::DesignPeaks searched_peaks(const CaseVector& of, const CaseVector::Unpacked& designs,
                                                   const CaseVector::Search& search);

/// A and K of some rows of all designs.
[[nodiscard]] numerics::Designs part_of_designs(const numerics::Designs& all, const std::vector<Eigen::Index>& rows);

}  // namespace trivet::study
