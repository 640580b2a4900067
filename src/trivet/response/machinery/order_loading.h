// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/assembly/loads.h"

namespace trivet::response {

/// All excitation at one multiple of the shaft speed Ω, as a loading over ω = order · Ω: a force proportional to Ω² is
/// proportional to ω²/order².
struct OrderLoading {
  double order = 0;
  assembly::Loading loading;
  std::vector<std::string> excitations;  ///< that act at this order
};

/// Orders of all excitations that depend on a shaft speed, or of those named, ascending; equal orders act together. A
/// harmonic force that grows with ω² (an unbalance) is order 1. All have the same Ω.
/// @throws foundation::InvalidInput for a name that is not such an excitation, or an order ≤ 0
[[nodiscard]] std::vector<OrderLoading> order_loadings(const model::System& system,
                                                       const assembly::Assembled& assembled,
                                                       const std::vector<std::string>& selected = {});

}  // namespace trivet::response
