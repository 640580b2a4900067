// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// Precondition checks of this module: each throws foundation::InvalidInput with quantity, value with unit, and rule.
namespace trivet::excitation {

void require_finite(double value, std::string_view quantity, std::string_view unit);
void require_positive(double value, std::string_view quantity, std::string_view unit);      ///< and finite
void require_not_negative(double value, std::string_view quantity, std::string_view unit);  ///< and finite

/// 0 ≤ ζ < 1.
void require_damping_ratio(double zeta);

}  // namespace trivet::excitation
