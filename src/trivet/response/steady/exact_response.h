// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"

namespace trivet::response {

/// Values of channels for given coordinates at one ω, with the exact laws of elements.
struct ExactValues {
  Eigen::VectorXcd values;   ///< one per channel
  Eigen::VectorXd possible;  ///< sums of the magnitudes of the terms: a value far below is round-off
};

/// @param coordinates  first rows of the layout
[[nodiscard]] ExactValues exact_values(const assembly::Assembled& assembled,
                                       const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                                       const Eigen::VectorXcd& coordinates, std::complex<double> omega, double near);
[[nodiscard]] inline ExactValues exact_values(const assembly::Assembled& assembled,
                                              const std::vector<assembly::Channel>& channels,
                                              const assembly::Loading& loading, const Eigen::VectorXcd& coordinates,
                                              double omega) {
  return exact_values(assembled, channels, loading, coordinates, omega, omega);
}

/// All results at one ω, from the exact Z(ω).
struct ExactSample : ExactValues {
  Eigen::VectorXcd coordinates;  ///< first rows of the layout
  double condition = 0;          ///< of the scaled Z, estimated
  double backward_error =
      0;  ///< ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in coordinates of unit mass diagonal; NaN if Z is singular
};

/// q(ω) = Z(ω)⁻¹ h(ω) for frequency-dependent elements; one pivoted factorisation per frequency. ω may be complex (Re ω
/// ≥ 0).
class ExactResponse {
 public:
  ExactResponse(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                const assembly::Loading& loading);

  [[nodiscard]] ExactSample at(std::complex<double> omega, double near) const;
  [[nodiscard]] ExactSample at(double omega) const { return at(omega, omega); }

 private:
  const assembly::Assembled& assembled_;
  const std::vector<assembly::Channel>& channels_;
  Eigen::VectorXd scale_;
  assembly::Loading loading_;
};

}  // namespace trivet::response
