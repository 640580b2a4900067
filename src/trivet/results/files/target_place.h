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

}  // namespace trivet::results
