// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::server {

/// The project file on disk at one moment.
struct FileState {
  std::string text;
  std::string version;            ///< hash of the text; empty: it cannot be read
  foundation::Problems problems;  ///< why it cannot be read
};

[[nodiscard]] FileState read_state(const std::string& file);
/// Hash by which two texts are told apart.
[[nodiscard]] std::string version_of(const std::string& text);

/// Replaces the file as a whole, or not at all; its permissions stay. Of a link its target is replaced.
/// @throws std::runtime_error with the reason
void replace_text(const std::string& file, const std::string& text);

}  // namespace trivet::server
