// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/elements/materials.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// `material = "spring_steel"` or `{E, G or nu, density}`. The density may be NaN. None after reporting
/// errors.
[[nodiscard]] std::optional<elements::Metal> read_metal(TableReader& reader);

/// `material = {G, E or hardness, bulk_modulus or nu, stiffening}`: static moduli of a rubber; `stiffening` (dynamic
/// over static modulus) is only checked.
[[nodiscard]] std::optional<elements::Rubber> read_rubber(TableReader& reader);

}  // namespace trivet::project
