// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "trivet/foundation/problems.h"

/// Checks used by several elements.
namespace trivet::elements {

/// Error unless the length [m] is within the limits for parts (foundation/part_size.h); returns whether it is.
bool check_length(foundation::Problems& problems, const std::string& key, double value);

/// The same for several lengths, each reported separately.
bool check_lengths(foundation::Problems& problems, std::initializer_list<std::pair<const char*, double>> lengths);

/// Error at `key` if `width` and `thickness` [m] differ by more than a factor of foundation::most_slender.
void check_slenderness(foundation::Problems& problems, const std::string& key, double width, double thickness);

/// The dynamic stiffening factor: error unless > 0, warning outside 1 … 4.
void check_factor(foundation::Problems& problems, double dynamic_factor);

/// Warning outside 0.25 … 20, the range of shape factors over which the accuracy of the formulas was measured.
void check_shape_factor(foundation::Problems& problems, double shape_factor);

/// @throws InvalidInput with the first error of the list, if there is one
void require_sound(const foundation::Problems& problems);

}  // namespace trivet::elements
