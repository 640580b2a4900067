// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Parses TOML text. `source` names it in messages. Nesting and dotted keys deeper than 64 are rejected.
[[nodiscard]] foundation::Expected<Node> parse_toml(std::string_view text, const std::string& source);

// Where the keys and values of a TOML text are, in bytes, so that a value can be replaced and all else kept.

/// A key as written, without quotes as `name`.
struct WrittenKey {
  std::string name;
  std::size_t begin = 0, end = 0;
};

struct WrittenPair;

struct WrittenValue {
  enum class Kind { scalar, array, table };
  Kind kind = Kind::scalar;
  std::size_t begin = 0, end = 0;
  std::vector<WrittenValue> items;  ///< of an array
  std::vector<WrittenPair> pairs;   ///< of a table in braces
};

/// key.key = value
struct WrittenPair {
  std::vector<WrittenKey> keys;
  WrittenValue value;
};

/// A header, [a.b] or [[a.b]], with the pairs below it. The first section of a text has no header.
struct WrittenSection {
  std::vector<WrittenKey> header;
  bool repeated = false;  ///< [[a.b]]
  std::size_t begin = 0;  ///< of the header
  std::size_t end = 0;    ///< of the header
  std::vector<WrittenPair> pairs;
};

/// @param text  valid TOML
[[nodiscard]] std::vector<WrittenSection> toml_layout(std::string_view text);

/// Position after the comment or string that starts at `at`; `at` itself if neither starts there.
[[nodiscard]] std::size_t after_comment_or_string(std::string_view text, std::size_t at);

}  // namespace trivet::project
