// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/foundation/folder_handle.h"
#include "trivet/results/result_manifest.h"

namespace trivet::results {

/// A result folder in place, and the one that follows it.
struct ResultExchange {
  const foundation::FolderHandle& current;  ///< in place
  const ResultManifest& ours;               ///< its manifest
  const foundation::FolderHandle& next;     ///< the new result
  const ResultManifest& next_ours;          ///< its manifest
};

/// Both folders change places in one step; before, the user's files get a second name in the new one. Afterwards the
/// files of the earlier result are where the new one was. @param next_place, place  the folders that hold them, under
/// these names
/// @returns false, with the folder in place as it was, if the file system cannot do that  @throws std::runtime_error if
/// it cannot be done at all
[[nodiscard]] bool exchange_folders(const ResultExchange& exchange, const foundation::FolderHandle& next_place,
                                    const std::string& next_name, const foundation::FolderHandle& place,
                                    const std::string& name, std::vector<std::string>& notes);

/// Moves the new files into the folder that is in place, one after another, then removes those of the earlier result
/// that are left. Each file is whole at any time; the manifest, replaced first and last, names the files of both
/// results meanwhile.
/// @throws std::runtime_error if a file cannot be moved
void replace_one_by_one(const ResultExchange& exchange, std::vector<std::string>& notes);

}  // namespace trivet::results
