// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace trivet::design {

/// A design in the form that a kernel needs, or the reason why it has no such form: "loss factors", "a moving ground" …
template <typename Design>
struct DesignOrReason {
  std::optional<Design> design;
  std::string reason;
};

}  // namespace trivet::design
