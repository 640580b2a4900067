// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "trivet/foundation/problems.h"

/// Findings that several elements share.
namespace trivet::elements {

/// Error unless the length [m] is one of a part (foundation/part_size.h); returns whether it is.
bool check_length(foundation::Problems& problems, const std::string& key, double value);

/// All of them, each reported for itself.
bool check_lengths(foundation::Problems& problems, std::initializer_list<std::pair<const char*, double>> lengths);

/// Error unless `width` and `thickness` [m] differ by a factor of foundation::most_slender at most, found at `key`.
void check_slenderness(foundation::Problems& problems, const std::string& key, double width, double thickness);

/// The dynamic stiffening factor: error unless > 0, warning outside 1 … 4.
void check_factor(foundation::Problems& problems, double dynamic_factor);

/// Warning outside 0.25 … 20, the range of shape factors that the formulas were measured over.
void check_shape_factor(foundation::Problems& problems, double shape_factor);

/// @throws InvalidInput with the first error of the list, if there is one
void require_sound(const foundation::Problems& problems);

}  // namespace trivet::elements
