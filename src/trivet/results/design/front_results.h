// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/optimize/design_front.h"

namespace trivet::results {

/// The front on the screen: its points with their parameters, the knee, and how evenly they lie.
[[nodiscard]] std::string front_text(const study::DesignFront& front);

/// A point as --set of any command.
[[nodiscard]] std::string front_settings(const study::DesignFront& front, std::size_t point);

/// One row per point: amplitudes in SI, then the parameters in their units, then the residual.
[[nodiscard]] std::string front_csv(const study::DesignFront& front);

/// Amplitudes in SI, parameters in their units.
[[nodiscard]] std::string front_json(const study::DesignFront& front, const foundation::Problems& warnings);

}  // namespace trivet::results
