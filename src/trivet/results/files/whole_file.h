// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "trivet/foundation/temporary_folder.h"

namespace trivet::results {

/// Where something new is to appear, and a temporary folder beside it, from which it is renamed when it is complete.
struct TargetPlace {
  std::filesystem::path path;  ///< absolute
  std::unique_ptr<foundation::TemporaryFolder> temporary;
};

/// Why a file or a folder that exists must not be replaced; empty if it may be.
using Refusal = std::function<std::string(const std::filesystem::path&, const std::filesystem::file_status&)>;

/// Checks a target before anything is computed.
/// @throws foundation::InvalidInput with the reason: a link, a pipe or a device, `refusal`, no folder, no permission
[[nodiscard]] TargetPlace target_place(const std::filesystem::path& target, const Refusal& refusal);

/// For Refusal: a folder where a file is to be written; other kinds are "".
[[nodiscard]] std::string reason_against_folder(const std::filesystem::file_status& status);

/// A file for one text, checked before the text is computed. The text is written to a temporary folder next to the
/// target and then replaces the target as a whole, or not at all.
class WholeFile {
 public:
  /// @param refusal  why an existing regular file must not be replaced; empty if it may be
  /// @throws foundation::InvalidInput with this reason, or if the target is a link or a folder, or if its folder is not
  /// writable
  WholeFile(const std::filesystem::path& target,
            const std::function<std::string(const std::filesystem::path&)>& refusal);
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// @throws std::runtime_error with the reason; an earlier file then stays unchanged
  void publish(const std::string& text) const;

 private:
  TargetPlace place_;
};

/// A picture file; an existing one may be an earlier SVG picture or an empty file.
class PictureFile : public WholeFile {
 public:
  /// @throws foundation::InvalidInput as WholeFile, and if it is `project` or contains something else
  PictureFile(const std::filesystem::path& target, const std::filesystem::path& project);
};

}  // namespace trivet::results
