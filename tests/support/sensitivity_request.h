// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/random_system.h"
#include "trivet/assembly/loads.h"
#include "trivet/response/sensitivity/peak_shares.h"

namespace trivet::test {

/// Response to all harmonic excitations of a system.
inline response::SensitivityRequest sensitivity_request(
    const std::vector<std::string>& of, assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement) {
  return {of, quantity, [](const model::System& system, const assembly::Assembled& assembled) {
            return assembly::harmonic_loading(system, assembled);
          }};
}

inline std::vector<model::Excitation> drive(int kind, RandomSystem& random) {
  model::Action action;
  for (int j = 0; j < 6; ++j) action.amplitude(j) = std::polar(j < 3 ? 1e-3 : 1e-2, random.number(-3, 3));
  action.at = random.vector(0.4);
  if (kind == 1) action.derivative = 2;
  if (kind == 2) action.wave = model::Wave{Eigen::Vector3d(0.6, 0.8, 0), 50};
  if (kind == 3) action.body = 0;
  return {{"drive", action, model::Harmonic{kind == 3 ? 2 : 0}}};
}

}  // namespace trivet::test
