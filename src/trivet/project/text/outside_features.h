// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/foundation/problems.h"

/// Keys of features that this version does not have: the message names the feature instead of a typing mistake.
namespace trivet::project {

/// Rule and remedy for a key that belongs to a feature outside this version, or elsewhere.
struct OutsideFeature {
  std::string rule;
  std::string remedy;
};

/// @param path  of the table that has the key, as in messages: "", "elements.mount", "analyses.transient"
[[nodiscard]] std::optional<OutsideFeature> outside_feature(const std::string& path, const std::string& key);

/// For a type of element: "gap", "friction", …
[[nodiscard]] std::optional<OutsideFeature> outside_type(const std::string& type);

/// A key of `analyses` that belongs to such a feature.
[[nodiscard]] bool is_outside_analysis(const std::string& key);

}  // namespace trivet::project
