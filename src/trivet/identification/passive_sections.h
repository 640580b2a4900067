// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace trivet::identification {

// Building blocks of passive, causal functions, and the table rows to which they are fitted.

/// A passive, causal driving-point function Z(s) (impedance or mobility) is a sum with weights ≥ 0 of the two sections
/// s/(s² + 2ζωs + ω²) and (s + 2ζω)/(s² + 2ζωs + ω²), of relaxations, a constant, s and 1/s: its real part on the axis
/// is the density of a measure ≥ 0, which they sample. [Herglotz; Brune 1931, J. Math. Phys. 10, 191]
struct Section {
  double angular_frequency = 0;  ///< ω [rad/s]
  double damping_ratio = 0;      ///< ζ
};
/// s/(s² + 2ζωs + ω²)
[[nodiscard]] std::complex<double> inertial_section(const Section& section, std::complex<double> s);
/// (s + 2ζω)/(s² + 2ζωs + ω²)
[[nodiscard]] std::complex<double> elastic_section(const Section& section, std::complex<double> s);

/// Sections that rows at these frequencies [rad/s] > 0 (increasing, at least two) can resolve: their half width ζω is
/// at least `share` of the row spacing around ω. Narrower ones would explain anything between two rows. Up to a factor
/// of 30 beyond the band.
[[nodiscard]] std::vector<Section> sections_shown(const std::vector<double>& frequencies, double share);

/// Selects at most 120 rows of a curve, equally spaced in the sum of its relative changes and the logarithm of
/// frequency.
[[nodiscard]] std::vector<Eigen::Index> rows_that_follow(const std::vector<double>& frequencies,
                                                         const Eigen::VectorXcd& values);

/// Weights ≥ 0 for which the weighted sum of the columns is nearest to the values, in relative distances; a sum nearer
/// than `enough` (rms) is not improved further.
[[nodiscard]] Eigen::VectorXd nearest_weights(const Eigen::MatrixXcd& columns, const Eigen::VectorXcd& values,
                                              double enough);

/// Verdict on whether a passive, causal structure can have a mobility.
struct MobilityVerdict {
  double relative_rms = 0;  ///< distance from the nearest such mobility, rms of the relative distance over the rows
  bool passes = true;       ///< the distance is within noise
  bool too_coarse = false;  ///< only resonances narrower than the row spacing explain it
  bool refused = false;     ///< the distance is so large that the phase must be wrong
};

/// The driving-point mobility of any passive linear structure, with any damping, is a sum with weights ≥ 0 of a mass, a
/// spring, a dashpot and sections of second order (passive_sections.h). The nearest sum with sections that the rows can
/// resolve is found by non-negative least squares on relative distances.
/// @param angular_frequencies  [rad/s] > 0, increasing
/// @param mobility             [(m/s)/N], not 0
[[nodiscard]] MobilityVerdict mobility_causality(const std::vector<double>& angular_frequencies,
                                                 const Eigen::VectorXcd& mobility);

}  // namespace trivet::identification
