// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "trivet/nonlinear/balance/observed_motion.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {

/// Numbers of one result of a periodic motion, in the order of tables.
struct MotionNumber {
  const char* name;
  double (*value)(const nonlinear::ObservedMotion& motion);
};
inline constexpr std::array<MotionNumber, 4> motion_numbers = {
    {{"mean", [](const nonlinear::ObservedMotion& m) { return m.mean; }},
     {"largest", [](const nonlinear::ObservedMotion& m) { return m.largest; }},
     {"smallest", [](const nonlinear::ObservedMotion& m) { return m.smallest; }},
     {"rms", [](const nonlinear::ObservedMotion& m) { return m.rms; }}}};

namespace json {

[[nodiscard]] inline Json motion(const nonlinear::ObservedMotion& m) {
  return {{"mean", m.mean},
          {"largest", m.largest},
          {"smallest", m.smallest},
          {"rms", m.rms},
          {"harmonics", list(m.harmonics)}};
}

}  // namespace json
}  // namespace trivet::results
