// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/select/mount_selection.h"

namespace trivet::results {

/// The best combinations of mounts compared with the given design, and what each mount reaches at best.
[[nodiscard]] std::string selection_text(const study::MountSelection& found);
[[nodiscard]] std::string selection_json(const study::MountSelection& found, const foundation::Problems& warnings);
/// The settings that give the best combination: --set 'elements.left.type = "catalogue:NAME"', one per line.
[[nodiscard]] std::string selection_settings(const study::MountSelection& found);

/// The settings that put a mount at the places of each choice.
[[nodiscard]] std::string mount_settings(const std::vector<project::MountChoice>& choices,
                                         const std::vector<std::size_t>& mounts);

}  // namespace trivet::results
