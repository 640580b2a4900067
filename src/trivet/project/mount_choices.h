// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/analyses/mount_choice.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Reads the choices of mounts of [parameters], with the catalogues that they name.
/// @param written  the document before element types are merged in
[[nodiscard]] std::vector<MountChoice> read_mount_choices(TableReader& root, const Node& written);

}  // namespace trivet::project
