// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/foundation/files.h"
#include "trivet/results/files/result_manifest.h"

namespace trivet::results {

/// An existing result folder and the new one that replaces it.
struct ResultExchange {
  const foundation::FolderHandle& current;  ///< the existing result
  const ResultManifest& ours;               ///< its manifest
  const foundation::FolderHandle& next;     ///< the new result
  const ResultManifest& next_ours;          ///< its manifest
};

/// Exchanges both folders in one step, after the user's files have been linked into the new one. Afterwards the files
/// of the earlier result are where the new one was. @param next_place, place  the folders that contain them, under
/// these names
/// @returns false, with the existing folder unchanged, if the file system does not support this  @throws
/// std::runtime_error if it fails otherwise
[[nodiscard]] bool exchange_folders(const ResultExchange& exchange, const foundation::FolderHandle& next_place,
                                    const std::string& next_name, const foundation::FolderHandle& place,
                                    const std::string& name, std::vector<std::string>& notes);

/// Moves the new files into the existing folder, one after another, then removes the remaining files of the earlier
/// result. Each file is complete at any time; the manifest, replaced first and last, names the files of both results
/// meanwhile.
/// @throws std::runtime_error if a file cannot be moved
void replace_one_by_one(const ResultExchange& exchange, std::vector<std::string>& notes);

}  // namespace trivet::results
