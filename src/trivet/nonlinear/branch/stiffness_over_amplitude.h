// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::nonlinear {

/// Dynamic stiffness of an element with nonlinear inner parts: the first harmonic of its force over a sine of its
/// deflection along z of its end K, with N and all other directions at rest.
struct AmplitudeStiffness {
  double amplitude = 0;                   ///< of the deflection [m]
  std::vector<double> angular_frequency;  ///< [rad/s], along the curve
  Eigen::VectorXcd stiffness;             ///< [N/m]
  std::string ended;                      ///< why it ends before the end of the band; empty: it does not

  /// Between two points; empty beyond them, and where several motions are known.
  [[nodiscard]] std::optional<std::complex<double>> at(double omega) const;
};

/// From `from` to `to` [rad/s], about the state of its laws in the system.
[[nodiscard]] std::vector<AmplitudeStiffness> stiffness_over_amplitude(const model::System& system, std::size_t element,
                                                                       double from, double to,
                                                                       const std::vector<double>& amplitudes);

}  // namespace trivet::nonlinear
