// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/foundation/problems.h"

/// Keys of features that this version does not have: the message names the feature instead of a typing mistake.
namespace trivet::project {

/// Rule and remedy for a key that belongs to a feature outside this version, or elsewhere.
struct UnsupportedKey {
  std::string rule;
  std::string remedy;
};

/// @param path  of the table that has the key, as in messages: "", "elements.mount", "analyses.transient"
[[nodiscard]] std::optional<UnsupportedKey> unsupported_key(const std::string& path, const std::string& key);

/// For a type of element: "gap", "friction", …
[[nodiscard]] std::optional<UnsupportedKey> unsupported_type(const std::string& type);

/// A key of `analyses` that belongs to such a feature.
[[nodiscard]] bool is_unsupported_analysis(const std::string& key);

}  // namespace trivet::project
