// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::project {

/// JSON Schema of the project file: project.schema.json with the keys of every element law and analysis, which are
/// defined next to their readers, and the groups of keys (`shared_keys`) that they list under `with`.
[[nodiscard]] std::string project_schema();

}  // namespace trivet::project
