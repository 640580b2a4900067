// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "trivet/elements/knot_curve.h"
#include "trivet/elements/law.h"
#include "trivet/foundation/problems.h"

/// Elements given only by tables of dynamic stiffness (air springs, wire-rope isolators, hydraulic mounts): k*(ω,
/// amplitude) per direction, interpolated and never extrapolated. Causality of the data is not checked here.
namespace trivet::elements {

/// k' + i k'' of one direction over angular frequency [rad/s] and, if it matters, zero-to-peak amplitude of the
/// relative motion [m or rad]. An empty list of either means that the stiffness does not depend on it (one row or one
/// column). [N/m or N m/rad]
struct StiffnessTable {
  std::vector<double> angular_frequencies;  ///< increasing, ≥ 0
  std::vector<double> amplitudes;           ///< increasing, ≥ 0; interpolated linearly
  Eigen::MatrixXd storage;                  ///< row: frequency, column: amplitude
  Eigen::MatrixXd loss;                     ///< like storage, ≥ 0
  Interpolation interpolation = Interpolation::monotone_cubic;
};

/// k*(ω, amplitude), ω ≥ 0. @throws InvalidInput outside the table
[[nodiscard]] std::complex<double> dynamic_stiffness(const StiffnessTable& table, double angular_frequency,
                                                     double amplitude);

/// Errors: sizes, order, numbers that are not finite, negative loss.
[[nodiscard]] foundation::Problems check(const StiffnessTable& table, const std::string& subject);

/// Six independent directions (translations along e1 e2 e3, rotations about them) that act at the fraction `centre` of
/// the arm. An empty table is a direction without stiffness.
struct TableLaw {
  std::array<StiffnessTable, 6> directions;
  double centre = 0.5;
};

using ComplexMatrix12 = Eigen::Matrix<std::complex<double>, 12, 12>;

/// Dynamic stiffness 12×12 at a frequency [rad/s] and at one amplitude per direction [m, rad]. @throws InvalidInput
/// outside a table
[[nodiscard]] ComplexMatrix12 dynamic_stiffness(const TableLaw& law, const Eigen::Vector3d& arm,
                                                double angular_frequency, const Vector6& amplitudes);

/// Frequencies [rad/s] that all tables cover.
struct FrequencyRange {
  double from = 0;
  double to = 0;  ///< infinity if no table depends on frequency
};
[[nodiscard]] FrequencyRange frequency_range(const TableLaw& law);
[[nodiscard]] foundation::Problems check(const TableLaw& law);

}  // namespace trivet::elements
