// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/select/mount_selection.h"

namespace trivet::results {

/// The best combinations of mounts compared with the given design, and what each mount reaches at best.
[[nodiscard]] Document selection_document(const study::MountSelection& found, const foundation::Problems& warnings);

/// The settings that put a mount at the places of each choice: --set 'elements.left.type = "catalogue:NAME"', one per
/// line.
[[nodiscard]] std::string mount_settings(const std::vector<project::MountChoice>& choices,
                                         const std::vector<std::size_t>& mounts);

}  // namespace trivet::results
