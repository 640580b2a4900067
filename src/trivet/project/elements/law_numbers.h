// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// A number > 0 that must be there.
[[nodiscard]] double read_positive(TableReader& reader, const char* key, Quantity quantity);

[[nodiscard]] Quantity force_quantity(bool is_rotation);
[[nodiscard]] Quantity travel_quantity(bool is_rotation);
[[nodiscard]] Quantity velocity_quantity(bool is_rotation);
[[nodiscard]] Quantity stiffness_quantity(bool is_rotation);

}  // namespace trivet::project
