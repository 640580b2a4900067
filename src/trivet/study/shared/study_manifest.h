// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/project/project.h"

namespace trivet::study {

/// What a study is of, in words that are compared: ("seed", "1"), …
using StudyIdentity = std::vector<std::pair<std::string, std::string>>;

/// Command, version, case, settings, and the SHA-256 of the project file and of every file that it names.
[[nodiscard]] StudyIdentity study_identity(const std::string& command, const project::Project& project);

/// "the seed is 1 there and 2 here; …"; empty if they are equal.
[[nodiscard]] std::string identity_differences(const StudyIdentity& there, const StudyIdentity& here);

/// The file that says what a study folder is of.
struct StudyManifest {
  StudyIdentity identity;
  std::string fixed;  ///< what the first process fixes for all, in the words of its command

  [[nodiscard]] std::string text() const;
  /// Empty if the text is damaged.
  [[nodiscard]] static std::optional<StudyManifest> read(const std::string& text);
  /// A hash of all of it, which the files of its parts have.
  [[nodiscard]] std::string hash() const;
};

/// A text with a last line that is its SHA-256.
[[nodiscard]] std::string with_hash_line(const std::string& text);
/// The text without that line; empty if it does not match.
[[nodiscard]] std::optional<std::string> without_hash_line(const std::string& text);

}  // namespace trivet::study
