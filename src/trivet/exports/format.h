// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/exports/content.h"
#include "trivet/exports/target.h"

namespace trivet::exports {

/// A format of another program. Each is defined in FORMAT_export.cpp.
struct Format {
  const char* name;   ///< of `--to`
  const char* about;  ///< what it holds and who reads it
  Target::Kind kind = Target::Kind::file;
  /// Groups that it can hold; empty: any. `fixed`: it has a content of its own, and `what` must be empty.
  std::vector<std::string> groups = {};
  bool fixed = false;
  /// Writes to the target. @returns what the format cannot hold
  /// @throws foundation::InvalidInput, NotComputable if it cannot hold the content at all
  std::vector<std::string> (*write)(const Content& content, const Target& target,
                                    const foundation::Progress& progress) = nullptr;
  SideFile side = {};
};

/// Note of formats that hold matrices without the loads.
inline constexpr const char* loads_left_out =
    "the loads of the matrices are not written; matlab, numpy and hdf5 have them";

/// All formats that this program was built with.
[[nodiscard]] const std::vector<Format>& formats();

/// Exports one case of a project. Everything is checked before it is computed; nothing half written is left.
/// @returns notes on what is lost or not exact
/// @throws foundation::InvalidInput for an unknown format or content, NotComputable
[[nodiscard]] std::vector<std::string> export_project(const project::Project& project, const project::Case& variant,
                                                      const std::string& format, const std::vector<std::string>& what,
                                                      const std::filesystem::path& target,
                                                      const foundation::Progress& progress = {});

}  // namespace trivet::exports
