// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::project {

extern const char* const schema_text;   ///< JSON Schema of the project file, without element laws and analyses
extern const char* const starter_text;  ///< commented starter project
extern const char* const generic_catalogue_text;  ///< catalogues/generic.toml
}  // namespace trivet::project
