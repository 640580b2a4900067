// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::fmu {

enum class InterfaceKind { model_exchange, co_simulation };

/// Phases of an instance, as bits, so that a function can name all in which it may be called. In co-simulation,
/// initialization is followed by `step`; in model exchange, by `event`.
using Phases = unsigned;
namespace phase {
inline constexpr Phases instantiated = 1, initialization = 2, event = 4, continuous_time = 8, step = 16,
                        terminated = 32;
inline constexpr Phases running = event | continuous_time | step;
/// Initial states are known.
inline constexpr Phases computed = initialization | running | terminated;
inline constexpr Phases any = instantiated | computed;
}  // namespace phase

/// "initialization mode".
[[nodiscard]] std::string phase_name(Phases phase);

}  // namespace trivet::fmu
