// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/engine/command.h"

namespace trivet::engine {

/// The keys of a request, checked against the row of its command.
class KeyReader {
 public:
  /// Adds an error for every key that the command does not have, that has a wrong kind or excludes another.
  KeyReader(const Command& command, const Request& request, foundation::Problems& problems);

  [[nodiscard]] bool has(const std::string& key) const { return find(key) != nullptr; }
  [[nodiscard]] bool flag(const std::string& key) const;
  /// A whole number ≥ 1, or the default of the row; 0 if there is none.
  [[nodiscard]] int count(const std::string& key) const;
  /// A text, or the default of the row.
  [[nodiscard]] std::string text(const std::string& key) const;
  /// Texts: a repeated key, a list, or the parts of one text between commas.
  [[nodiscard]] std::vector<std::string> texts(const std::string& key) const;
  /// The same without a split at commas.
  [[nodiscard]] std::vector<std::string> names(const std::string& key) const;
  /// Angular frequencies [rad/s] from a text in which each has its unit ("1 Hz,2.7 Hz"), or from numbers in rad/s.
  /// @throws foundation::InvalidInput, naming the key
  [[nodiscard]] std::vector<double> frequencies(const std::string& key) const;
  /// [s] from a number, or a text with a unit; none if the key is absent. @throws foundation::InvalidInput
  [[nodiscard]] std::optional<double> seconds(const std::string& key) const;
  /// Axes of moments: "x", "0.9,0,0.1", or lists of three numbers. @throws foundation::InvalidInput
  [[nodiscard]] std::vector<Eigen::Vector3d> directions(const std::string& key) const;
  [[nodiscard]] const Value* find(const std::string& key) const;

  /// The key as whoever asks writes it: "--at".
  [[nodiscard]] std::string written(const std::string& key) const { return before_ + key; }

 private:
  [[nodiscard]] const Key& row(const std::string& key) const;
  [[nodiscard]] double frequency(const std::string& key, const Value& value) const;

  const Command& command_;
  const Keys& keys_;
  std::string before_;
};

/// The value as a text: "1.5", "true", "1,2".
[[nodiscard]] std::string text_of(const Value& value);

}  // namespace trivet::engine
