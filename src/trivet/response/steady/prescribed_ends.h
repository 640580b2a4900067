// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::response {

/// Motion of both ends of each element that harmonic motion of the ground prescribes at ω, with all free coordinates at
/// rest: 12 per element (end N, end K), in the element's local axes. Taken from the description alone, without
/// `assembly::Ground`: an independent derivation for the second solver.
class PrescribedEnds {
 public:
  using Vector = Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, 1>;

  /// @param excitations  names of the harmonic ones that act; empty: all
  PrescribedEnds(const model::System& system, const std::vector<std::string>& excitations);

  /// True if an excitation moves the ground and an end of this element is on it, directly or through a foundation.
  [[nodiscard]] bool can_move(std::size_t element) const;
  [[nodiscard]] Vector at(std::size_t element, double angular_frequency) const;

 private:
  using Motion = Eigen::Matrix<std::complex<long double>, 6, 1>;

  Motion ground_at(const Eigen::Vector3d& place, std::size_t element, long double omega) const;

  const model::Description& description_;
  std::vector<const model::Excitation*> moving_;
  std::vector<int> impedance_of_;  ///< element between each foundation and the rigid ground; −1 for modes
};

}  // namespace trivet::response
