// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Warns of a key that has no effect because of the other keys of its table.
void warn_of_idle_key(TableReader& reader, const std::string& key, std::string finding, std::string rule,
                      std::string remedy);

}  // namespace trivet::project
