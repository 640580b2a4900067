// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::assembly {

/// Frequency band [rad/s].
struct Band {
  double from = 0;
  double to = 0;
  bool operator==(const Band&) const = default;
};

}  // namespace trivet::assembly
