// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/folder_handle.h"

namespace trivet::foundation {

/// Writes a new file; an existing entry of this name, even a link, is an error.
/// @param shown  path in the message  @throws std::runtime_error with the reason (a full disk, for instance)
void write_new_file(const FolderHandle& folder, const std::string& name, const std::string& content,
                    const std::filesystem::path& shown);

}  // namespace trivet::foundation
