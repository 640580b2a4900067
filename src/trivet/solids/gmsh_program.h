// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::solids {

/// A script for the program gmsh (Debian package gmsh; under the GPL, hence only ever a child process) on one STEP
/// file. The script finds the file as part.step, in millimetres whatever the file's own unit, and writes its results
/// beside it.
struct GmshJob {
  std::filesystem::path step_file;
  std::filesystem::path folder;  ///< an empty folder for the job, the caller's to remove
  std::string script;            ///< runs after the solids of the file have been read
  std::string task;              ///< what progress reports
  double time_limit = 3600;      ///< [s] > 0; the environment variable TRIVET_GMSH_SECONDS overrides it
};

/// Runs the job on one thread, with none of the user's settings of gmsh, so that equal files give equal results.
/// What can go wrong is a problem with the subject "file": no gmsh, no such file, no STEP file, a failed script with
/// gmsh's own words.
[[nodiscard]] foundation::Expected<void> run_gmsh(const GmshJob& job, const foundation::Progress& progress = {});

}  // namespace trivet::solids
