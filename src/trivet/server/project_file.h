// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::server {

/// The project file on disk at one moment.
struct FileState {
  std::string text;               ///< empty with problems
  std::string version;            ///< hash of its bytes; empty: there is no file, or it is blank
  foundation::Problems problems;  ///< why a page cannot have the text: it cannot be read, or is not UTF-8

  /// Is there something on the disk that no page can show?
  [[nodiscard]] bool is_hidden() const { return !version.empty() && problems.has_errors(); }
};

[[nodiscard]] FileState read_state(const std::string& file);
/// Hash by which two texts are told apart.
[[nodiscard]] std::string version_of(const std::string& text);

/// Replaces the file as a whole, or not at all; its permissions stay. Of a link its target is replaced.
/// @throws std::runtime_error with the reason
void replace_text(const std::string& file, const std::string& text);

}  // namespace trivet::server
