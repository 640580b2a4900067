// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/assembly/loads.h"

namespace trivet::response {

/// All that happens at one multiple of the shaft speed Ω, as loading over ω = order · Ω: what grows with Ω² grows with
/// ω²/order².
struct OrderLoading {
  double order = 0;
  assembly::Loading loading;
  std::vector<std::string> excitations;  ///< that act at this order
};

/// The orders of all excitations that go with a shaft, or of those named, ascending; equal orders act together. A
/// harmonic force that grows with ω² (an unbalance) is order 1. All turn with the same Ω.
/// @throws foundation::InvalidInput for a name that names none, or an order ≤ 0
[[nodiscard]] std::vector<OrderLoading> order_loadings(const model::System& system,
                                                       const assembly::Assembled& assembled,
                                                       const std::vector<std::string>& selected = {});

}  // namespace trivet::response
