// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "trivet/results/files/target_place.h"

namespace trivet::results {

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

}  // namespace trivet::results
