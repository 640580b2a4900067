// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/amplitude_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivet::elements {

/// With p = (A/A_c)^m: k' = Δ/(1 + p²), k'' = 2 L p/(1 + p²), dp/dA = m p/A.
StiffnessOfAmplitude stiffness_at(const PayneForce& law, double amplitude) {
  const double ratio = std::max(amplitude / law.amplitude, std::numeric_limits<double>::min());
  const double p = std::pow(ratio, law.exponent), below = 1 + p * p,
               by_amplitude = law.exponent * p / (ratio * law.amplitude);
  return {law.stiffness / below, 2 * law.loss * p / below, -2 * law.stiffness * p / (below * below) * by_amplitude,
          2 * law.loss * (1 - p * p) / (below * below) * by_amplitude};
}

}  // namespace trivet::elements
