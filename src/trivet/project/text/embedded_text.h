// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// Files of the source tree that are part of the program.
namespace trivet::project {

[[nodiscard]] std::string schema_text();   ///< JSON Schema of the project file, without element laws and analyses
[[nodiscard]] std::string starter_text();  ///< commented starter project
[[nodiscard]] std::string generic_catalogue_text();  ///< catalogues/generic.toml

}  // namespace trivet::project
