// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"

namespace trivet::nonlinear {

/// Excitation of periodic motions: loadings at harmonics of the motion.
struct PeriodicExcitation {
  /// Frequency of the first harmonic over that of the excitation or the shaft: 1/2 for a four-stroke engine.
  double first_harmonic = 1;
  std::vector<std::string> names;
  bool of_shaft = false;                    ///< orders of a shaft speed, not one frequency
  std::vector<Eigen::Index> harmonics;      ///< ascending
  std::vector<assembly::Loading> loadings;  ///< one per harmonic, over its own frequency
  /// What phases are measured from: the first excitation of the model at the lowest frequency, and of its force (or
  /// motion) the first component that is not zero.
  struct Reference {
    std::string name;
    double phase = 0;  ///< ahead of cos ωt [rad]
    double delay = 0;  ///< [s]
    [[nodiscard]] double phase_at(double omega) const { return phase - omega * delay; }
  };
  Reference reference;
  [[nodiscard]] Eigen::Index highest() const { return harmonics.empty() ? 1 : harmonics.back(); }
};

/// All harmonic excitations, or, without any, all orders; or those named. Orders have the largest common divisor as
/// their first harmonic.
/// @throws foundation::InvalidInput  for a name that is neither
/// @throws foundation::NotComputable for orders without a common divisor
[[nodiscard]] PeriodicExcitation periodic_excitation(const model::System& system, const assembly::Assembled& assembled,
                                                     const std::vector<std::string>& selected);

}  // namespace trivet::nonlinear
